//! Tilted disks on the GPU: against the view of a camera that is moved with everything but the hole,
//! and against the f64 reference.

use crate::ALONG;
use crate::light::light_from;
use crate::moved_camera::Twin;
use crate::{edge_on, gpu, median, pixel_directions, quantile};
use glam::{DVec3, Vec4};
use lightfall_core::geometry::sphere::wrap_angle;
use lightfall_core::gpu::kernel::{table_bytes, uniform};
use lightfall_core::gpu::{Gpu, GpuScene, GpuTilt, Variant, bindings, rays};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::spectrum;
use lightfall_core::optics::trace::Trace;
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{Frame, Method, Scene, SkyMode};

/// Every method around a hole without spin.
const METHODS: [Method; 4] = [
    Method::Closed,
    Method::Verlet,
    Method::Mino,
    Method::KerrSchild,
];

/// The edge-on view, not level, with a disk of this tilt and node.
fn tilted(method: Method, tilt_deg: f64, node_deg: f64) -> Scene {
    let mut scene = edge_on();
    (scene.method, scene.camera.roll_deg) = (method, 17.0);
    (scene.disk.tilt_deg, scene.disk.node_deg) = (tilt_deg, node_deg);
    scene
}

/// How far the traces of a scene are from those of other rays: in the directions of the sky, in the
/// hits' radii, g and delays (relative), and in azimuths; and how many rays are of another class.
#[derive(Default)]
struct Differences {
    sky: Vec<f64>,
    hits: Vec<f64>,
    classes: usize,
}

impl Differences {
    fn add(&mut self, found: &Trace, sky: Option<DVec3>, other: &Trace) {
        let hits = |trace: &Trace| trace.hits.iter().flatten().count();
        if found.outcome != other.outcome || hits(found) != hits(other) {
            self.classes += 1;
            return;
        }
        self.sky
            .extend(found.sky.zip(sky).map(|(sky, other)| sky.distance(other)));
        for (hit, other) in found.hits.iter().flatten().zip(other.hits.iter().flatten()) {
            let delays = hit.delay.unwrap() / other.delay.unwrap();
            let turn = wrap_angle(hit.phi - other.phi).abs();
            let ratios = [hit.r / other.r, hit.g / other.g, delays];
            let worst = ratios.map(|ratio| (ratio - 1.0).abs());
            self.hits.push(worst.into_iter().fold(turn, f64::max));
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_tilted_disk_is_traced_as_by_a_camera_that_is_moved_and_rolled_instead() {
    let gpu = gpu();
    for method in METHODS {
        let scene = tilted(method, 62.0, 115.0);
        let twin = Twin::of(&scene);
        let directions = pixel_directions(&scene, 96, 54);
        let turned: Vec<DVec3> = directions.iter().map(|d| twin.axes * *d).collect();
        let mut differences = Differences::default();
        let traces = rays::trace(gpu, &scene, &directions).unwrap();
        for (found, other) in traces
            .iter()
            .zip(rays::trace(gpu, &twin.scene, &turned).unwrap())
        {
            differences.add(found, other.sky.map(|sky| twin.turn * sky), &other);
        }
        let Differences { sky, hits, classes } = differences;
        assert!(sky.len() > 1000 && hits.len() > 1000, "{method:?}");
        // Directions are rounded to 6e-8, and the photon sphere amplifies that for a few rays.
        assert!(median(&sky) < 3e-6 && median(&hits) < 3e-6, "{method:?}");
        assert!(quantile(&sky, 0.98) < 1e-4, "{method:?}");
        assert!(quantile(&hits, 0.98) < 1e-4, "{method:?}");
        assert!(classes <= 5, "{method:?}: {classes} rays of another class");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_tilted_disk_is_traced_as_the_reference_traces_it() {
    let gpu = gpu();
    for (lensing, kind) in [
        (true, Method::Closed),
        (true, Method::Mino),
        (false, Method::Closed),
    ] {
        let mut scene = tilted(kind, 130.0, -30.0);
        scene.effects.lensing = lensing;
        scene.observer.velocity = [0.2, 0.3, -0.4];
        let reference = Reference::new(&scene).unwrap();
        let directions = pixel_directions(&scene, 96, 54);
        let mut differences = Differences::default();
        for (found, direction) in rays::trace(gpu, &scene, &directions)
            .unwrap()
            .iter()
            .zip(&directions)
        {
            let truth = reference.trace_with_delays(*direction);
            differences.add(found, truth.sky, &truth);
        }
        let Differences { sky, hits, classes } = differences;
        assert!(sky.len() > 500 && hits.len() > 200, "{kind:?}");
        assert!(median(&sky) < 1e-5 && median(&hits) < 1e-5, "{kind:?}");
        assert!(classes <= 5, "{kind:?}: {classes} rays of another class");
    }
}

/// The light along rays, by a shader without neighbouring rays.
fn light(gpu: &Gpu, scene: &Scene, directions: &[DVec3]) -> Vec<Vec4> {
    let variant = Variant::timed_light(scene);
    let mut uniforms = vec![
        (
            bindings::SCENE,
            uniform(&GpuScene::for_rays(scene).unwrap()),
        ),
        (bindings::SPECTRUM, table_bytes(&spectrum::table())),
    ];
    if variant.turned_sky {
        uniforms.push((bindings::TILT, uniform(&GpuTilt::new(scene))));
    }
    let given = directions.iter().map(|d| d.as_vec3().extend(0.0));
    light_from(gpu, &variant.source(), ALONG, &uniforms, given)
}

/// How many of these lights differ by more than a hundredth of themselves and of a faint light.
fn differing(lights: &[Vec4], others: &[Vec4]) -> usize {
    let differs = |(a, b): &(&Vec4, &Vec4)| {
        (**a - **b).truncate().abs().max_element() > 0.01 * (b.truncate().max_element() + 0.01)
    };
    lights.iter().zip(others).filter(differs).count()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn without_a_disk_a_tilt_changes_no_sky() {
    let gpu = gpu();
    for mode in [SkyMode::Grid, SkyMode::Procedural] {
        let mut scene = tilted(Method::Closed, 62.0, 115.0);
        (scene.disk.enabled, scene.sky.mode) = (false, mode);
        scene.sky.reference_star = true;
        (scene.sky.reference_theta_deg, scene.sky.reference_phi_deg) = (95.0, 200.0);
        let mut level = scene.clone();
        level.disk.tilt_deg = 0.0;
        let directions = pixel_directions(&scene, 128, 72);
        let (found, expected) = (
            light(gpu, &scene, &directions),
            light(gpu, &level, &directions),
        );
        let shining = |lights: &[Vec4]| {
            let bright = |light: &&Vec4| light.truncate().max_element() > 0.05;
            lights.iter().filter(bright).count()
        };
        assert!(shining(&expected) > 40, "{mode:?}");
        // Edges of lines and stars are steep.
        let count = differing(&found, &expected);
        assert!(count < directions.len() / 200, "{mode:?}: {count} differ");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn in_a_dark_sky_a_tilted_disk_shines_as_for_the_moved_camera() {
    let gpu = gpu();
    for method in METHODS {
        let mut scene = tilted(method, 62.0, 115.0);
        scene.sky.mode = SkyMode::Off;
        let twin = Twin::of(&scene);
        let directions = pixel_directions(&scene, 128, 72);
        let turned: Vec<DVec3> = directions.iter().map(|d| twin.axes * *d).collect();
        let (found, expected) = (
            light(gpu, &scene, &directions),
            light(gpu, &twin.scene, &turned),
        );
        let lit = expected
            .iter()
            .filter(|light| light.truncate().max_element() > 0.01);
        assert!(lit.count() > 1000, "{method:?}");
        let count = differing(&found, &expected);
        assert!(count < directions.len() / 500, "{method:?}: {count} differ");
    }
}

/// A tilt costs nothing where no disk is tilted, and only skies of the hole's own frame pay for one.
#[test]
fn only_a_sky_behind_a_tilted_disk_has_the_tilt_in_its_shader() {
    let knows_tilt = |scene: &Scene| {
        let text = Variant::picture(scene).source();
        text.contains("BINDING_TILT") || text.contains("hole_from_disk")
    };
    for preset in PRESETS {
        let scene = preset.scene(&[]).unwrap();
        assert!(!knows_tilt(&scene), "{}", preset.name);
        let mut noded = scene.clone();
        noded.disk.node_deg = 77.0;
        assert_eq!(Variant::picture(&noded), Variant::picture(&scene));
        let size = scene.picture.size();
        assert_eq!(
            GpuScene::new(&noded, &Frame::of(&noded).with_whole(size)).unwrap(),
            GpuScene::new(&scene, &Frame::of(&scene).with_whole(size)).unwrap(),
            "{}",
            preset.name
        );
        if scene.hole.spin != 0.0 {
            continue;
        }
        let mut leaning = scene.clone();
        leaning.disk.tilt_deg = 30.0;
        assert_eq!(Variant::rays(&leaning), Variant::rays(&scene));
        assert_eq!(Variant::timed(&leaning), Variant::timed(&scene));
        assert_eq!(
            Variant::star_kernels(&leaning),
            Variant::star_kernels(&scene)
        );
        let turns = matches!(scene.sky.mode, SkyMode::Procedural | SkyMode::Grid);
        assert_eq!(knows_tilt(&leaning), turns, "{}", preset.name);
    }
}
