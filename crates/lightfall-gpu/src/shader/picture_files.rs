//! The files that pictures are linked from. The lists come from the tables of methods, skies, disk
//! models and views.

use super::Variant;
use lightfall_model::scene::{
    DiskModel, DiskStructure, HotSpotKind, LimbDarkening, Method, Projection, Scene, SkyMode, View,
};
use std::collections::BTreeSet;

impl Variant {
    /// The files below shaders/ that the picture of some scene is linked from.
    pub fn files_of_all_pictures() -> BTreeSet<&'static str> {
        let scenes = bases().into_iter().flat_map(|base| {
            let mut scenes = Vec::new();
            let mut add = |change: &dyn Fn(&mut Scene)| {
                let mut scene = base.clone();
                change(&mut scene);
                scenes.push(scene);
            };
            for method in Method::on_gpu() {
                for spin in [0.0, 0.5, 0.9999] {
                    add(&|scene| (scene.method, scene.hole.spin) = (method, spin));
                }
            }
            for mode in SkyMode::ALL {
                for tilt_deg in [0.0, 30.0] {
                    add(&|scene| (scene.sky.mode, scene.disk.tilt_deg) = (mode, tilt_deg));
                }
            }
            for view in View::ALL {
                add(&|scene| scene.view = view);
            }
            for model in DiskModel::ALL {
                add(&|scene| scene.disk.model = model);
            }
            for limb in LimbDarkening::ALL {
                add(&|scene| scene.disk.limb = limb);
            }
            for (thickness, enabled, knots) in [
                (0.06, false, 0.0),
                (0.06, true, 0.0),
                (0.06, true, 1.0),
                (0.0, true, 0.0),
                (0.0, true, 1.0),
            ] {
                for limb in LimbDarkening::ALL {
                    add(&|scene| {
                        scene.disk.thickness = thickness;
                        scene.disk.limb = limb;
                        (scene.jet.enabled, scene.jet.knots) = (enabled, knots);
                    });
                }
                for view in View::ALL {
                    add(&|scene| {
                        (scene.view, scene.disk.thickness) = (view, thickness);
                        (scene.jet.enabled, scene.jet.knots) = (enabled, knots);
                    });
                }
            }
            add(&|scene| scene.sky.reference_star = true);
            for projection in Projection::ALL {
                add(&|scene| scene.camera.projection = projection);
            }
            add(&|scene| scene.effects.lensing = false);
            add(&|scene| scene.picture.antialias = false);
            scenes
        });
        scenes
            .flat_map(|scene| Self::picture(&scene).files())
            .collect()
    }
}

/// A scene without a disk, one with a smooth disk, and one whose disk has structure and a hot spot.
fn bases() -> [Scene; 3] {
    let without_disk = {
        let mut scene = Scene::default();
        scene.disk.enabled = false;
        scene
    };
    let mut smooth = Scene::default();
    smooth.disk.structure = DiskStructure::None;
    let mut living = Scene::default();
    living.disk.structure = DiskStructure::Turbulent;
    living.hot_spot.kind = HotSpotKind::Rigid;
    [without_disk, smooth, living]
}
