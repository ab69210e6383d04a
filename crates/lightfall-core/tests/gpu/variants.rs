//! Every variant. The lists come from the tables of methods, skies, disk models and views, so that a
//! new row is tested as well.

use lightfall_core::gpu::{Entry, Tracer, Variant};
use lightfall_core::scene::{
    DiskModel, DiskStructure, Effects, HotSpotKind, LimbDarkening, Method, Projection, Scene,
    SkyMode, View,
};

/// Every variant that a scene can ask for, with two exceptions: sets of effects with some
/// switched off come with one sky and one disk only, and cameras next to the horizon come with the
/// view `colour` only.
pub fn every_variant() -> Vec<Variant> {
    let mut all = Vec::new();
    let mut scene = Scene::default();
    scene.disk.edge_taper = 0.0;
    let disks = [(false, 0.0), (true, 0.0), (true, 0.04), (true, 1.0)];
    let methods = Method::on_gpu().into_iter().flat_map(|method| {
        let spins: &[f64] = if method.properties().spins {
            &[0.0, 0.5]
        } else {
            &[0.0]
        };
        spins.iter().map(move |spin| (method, *spin))
    });
    for ((method, spin), (enabled, transmission)) in
        methods.flat_map(|method| disks.map(|disk| (method, disk)))
    {
        (scene.method, scene.hole.spin) = (method, spin);
        (scene.disk.enabled, scene.disk.transmission) = (enabled, transmission);
        all.extend([Variant::rays(&scene), Variant::timed(&scene)]);
        for projection in Projection::ALL {
            scene.camera.projection = projection;
            all.extend(Variant::star_kernels(&scene));
        }
        scene.camera.projection = Projection::Perspective;
        for mode in SkyMode::ALL {
            scene.sky.mode = mode;
            all.push(Variant::timed_light(&scene));
            for reference_star in [false, true] {
                for view in View::ALL {
                    (scene.sky.mode, scene.sky.reference_star, scene.view) =
                        (mode, reference_star, view);
                    all.push(Variant::picture(&scene));
                }
            }
        }
        (scene.sky.mode, scene.sky.stars) = (SkyMode::Picture, true);
        scene.view = View::Colour;
        all.push(Variant::picture(&scene));
        (scene.sky.mode, scene.sky.stars) = (SkyMode::Stars, false);
        for set in 0..32 {
            let [lensing, doppler, beaming, gravitational_shift, aberration] =
                std::array::from_fn(|effect| set >> effect & 1 == 1);
            scene.effects = Effects {
                lensing,
                doppler,
                beaming,
                gravitational_shift,
                aberration,
            };
            all.extend([Variant::rays(&scene), Variant::picture(&scene)]);
            all.extend(Variant::star_kernels(&scene));
        }
    }
    let shining: Vec<Variant> = all
        .iter()
        .copied()
        .filter(|v| v.disk && v.view.shows_light() && v.entry == Entry::Picture)
        .filter(|v| v.effects == Effects::default())
        .collect();
    for disk_model in DiskModel::ALL {
        let modelled = |variant: &Variant| Variant {
            disk_model,
            ..*variant
        };
        all.extend(shining.iter().map(modelled));
    }
    for projection in Projection::ALL {
        all.extend(shining.iter().map(|variant| Variant {
            projection: projection.of_picture(),
            ..*variant
        }));
    }
    for hot_spot in HotSpotKind::ALL {
        all.extend(shining.iter().map(|variant| Variant {
            hot_spot,
            limb: LimbDarkening::ElectronScattering,
            delay_nodes: match hot_spot {
                HotSpotKind::None => 0,
                _ => variant.tracer.delay_nodes(),
            },
            ..*variant
        }));
    }
    for repeats in [false, true] {
        all.extend(shining.iter().map(|variant| Variant {
            structure: true,
            repeats,
            delay_nodes: variant.tracer.delay_nodes(),
            ..*variant
        }));
    }
    let timed = shining.iter().filter(|variant| variant.sky == SkyMode::Off);
    all.extend(timed.map(|variant| Variant {
        entry: Entry::TimedLight,
        antialias: false,
        structure: true,
        delay_nodes: variant.tracer.delay_nodes(),
        ..*variant
    }));
    let skies = shining
        .iter()
        .filter(|variant| variant.sky.lies_in_hole_frame() && !variant.spinning);
    all.extend(skies.map(|variant| Variant {
        turned_sky: true,
        ..*variant
    }));
    // Pictures without the search for edges, and what refines them.
    all.extend(shining.iter().map(|variant| Variant {
        antialias: false,
        ..*variant
    }));
    let plain = |variant: &&Variant| variant.effects == Effects::default();
    let refined: Vec<Variant> = all
        .iter()
        .filter(plain)
        .filter_map(|v| v.refined())
        .collect();
    all.extend(refined);
    let close = |variant: &Variant| {
        let (tracer, view, effects) = (variant.tracer, variant.view, variant.effects);
        matches!(tracer, Tracer::Method(Method::Mino) | Tracer::ClosedKerr)
            && view == View::Colour
            && effects == Effects::default()
    };
    let close: Vec<Variant> = all.iter().copied().filter(close).collect();
    all.extend(close.into_iter().map(|variant| Variant {
        near_horizon: true,
        ..variant
    }));
    let delayed =
        |variant: &Variant| variant.tracer == Tracer::ClosedKerr && variant.delay_nodes > 0;
    let delayed: Vec<Variant> = all.iter().copied().filter(delayed).collect();
    all.extend(delayed.into_iter().map(|variant| Variant {
        throat: true,
        ..variant
    }));
    all.extend(matter_with_depth());
    let mut seen = std::collections::HashSet::new();
    all.retain(|variant| seen.insert(*variant));
    all
}

/// The variants of scenes with matter with depth: a disk with thickness, jets, and jets among disks of
/// both kinds.
fn matter_with_depth() -> Vec<Variant> {
    let mut all = Vec::new();
    let kinds = [
        (true, 0.06, false),
        (true, 0.06, true),
        (true, 0.0, true),
        (false, 0.0, true),
    ];
    for spin in [0.0, 0.5] {
        for (enabled, thickness, jet) in kinds {
            for set in 0..8 {
                let [structured, knots, dark] = [0, 1, 2].map(|bit| set >> bit & 1 == 1);
                let mut scene = Scene::default();
                scene.hole.spin = spin;
                (scene.disk.enabled, scene.disk.thickness) = (enabled, thickness);
                (scene.jet.enabled, scene.jet.knots) = (jet, f64::from(u8::from(knots)));
                scene.disk.structure = if structured {
                    DiskStructure::Turbulent
                } else {
                    DiskStructure::None
                };
                (scene.sky.mode, scene.disk.limb) = if dark {
                    (SkyMode::Off, LimbDarkening::None)
                } else {
                    (SkyMode::Stars, LimbDarkening::ElectronScattering)
                };
                let picture = Variant::picture(&scene);
                all.extend([
                    picture,
                    Variant::timed_light(&scene),
                    Variant::passages(&scene, false),
                    Variant::passages(&scene, true),
                ]);
                all.extend(picture.refined());
                all.extend(Variant::star_kernels(&scene));
                all.extend(View::ALL.map(|view| {
                    Variant::picture(&Scene {
                        view,
                        ..scene.clone()
                    })
                }));
            }
        }
    }
    all
}
