//! Jets on the GPU: their light against the converged f64 twin.

use crate::medium::{errors, light};
use crate::quantile;
use lightfall_core::scene::{DiskStructure, ObserverKind, Scene, SkyMode};

/// A scene with smooth jets alone.
fn jets(spin: f64, [r, theta_deg]: [f64; 2], fov_deg: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (r, theta_deg, fov_deg);
    scene.observer.kind = ObserverKind::Static;
    scene.disk.enabled = false;
    scene.jet.enabled = true;
    scene.jet.knots = 0.0;
    scene.sky.mode = SkyMode::Off;
    scene
}

/// From the side, from far away, from inside a jet, along the axis, wide jets around holes without spin and
/// with nearly the most, and jets as blue and as fast as they can be.
fn scenes() -> Vec<Scene> {
    let wide = |spin| {
        let mut scene = jets(spin, [12.0, 60.0], 70.0);
        (scene.jet.width, scene.jet.length, scene.jet.speed) = (0.8, 15.0, 4.0);
        scene
    };
    let mut blue = jets(-0.7, [3.4, 90.0], 80.0);
    (blue.jet.colour, blue.jet.speed, blue.jet.length) = (20.0, 20.0, 150.0);
    vec![
        jets(0.9, [30.0, 70.0], 66.0),
        jets(0.9, [400.0, 90.0], 12.0),
        jets(0.9, [9.0, 12.0], 80.0),
        jets(0.5, [60.0, 0.0], 30.0),
        wide(0.0),
        wide(0.998),
        blue,
    ]
}

/// The median and the 95th percentile of the errors, and the number of lit pixels.
fn statistics(scene: &Scene, size: [u32; 2], relative: f64) -> ([f64; 2], usize) {
    let errors = errors(&light(scene, size, relative));
    (
        [0.5, 0.95].map(|share| quantile(&errors, share)),
        errors.len(),
    )
}

#[test]
#[ignore = "needs a graphics adapter"]
fn smooth_jets_hold_the_error_that_chooses_their_nodes() {
    let mut failed = false;
    for mut scene in scenes() {
        for max_error in [0.07, 0.012, 0.001] {
            scene.quality.max_error_light = max_error;
            let ([median, most], count) = statistics(&scene, [48, 40], 1e-6);
            let camera = [scene.camera.r, scene.camera.theta_deg];
            println!("{camera:?} {max_error}: {count} lit, {median:.1e} {most:.1e}");
            assert!(count > 80, "{camera:?}: {count}");
            failed |= most >= max_error;
        }
    }
    assert!(!failed, "an error above is larger than its limit");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_disk_among_the_jets_is_met_in_its_order() {
    // A sheet, opaque and transparent, a disk with thickness, and one so thick that the jets pass
    // through it.
    for (thickness, transmission, edge_taper) in [
        (0.0, 0.0, 0.1),
        (0.0, 0.5, 0.1),
        (0.08, 0.0, 0.2),
        (0.3, 0.0, 0.2),
    ] {
        let mut scene = jets(0.9, [20.0, 65.0], 60.0);
        scene.disk.enabled = true;
        scene.disk.follow_isco = true;
        (scene.disk.thickness, scene.disk.depth) = (thickness, 2.0);
        (scene.disk.outer, scene.disk.transmission) = (11.0, transmission);
        scene.disk.edge_taper = edge_taper;
        scene.jet.brightness = 3.0;
        let max_error = 0.012;
        scene.quality.max_error_light = max_error;
        let ([median, most], count) = statistics(&scene, [48, 40], 1e-5);
        println!("{thickness} {transmission}: {count} lit, {median:.1e} {most:.1e}");
        assert!(most < max_error, "{thickness} {transmission}: {most:e}");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn knots_are_those_of_the_twin() {
    for (structure, disk) in [
        (DiskStructure::None, false),
        (DiskStructure::Turbulent, true),
    ] {
        let mut scene = jets(0.9, [30.0, 70.0], 66.0);
        scene.disk.enabled = disk;
        scene.disk.structure = structure;
        scene.disk.time = 1234.5;
        // The disk beside them must not hide how much the knots change.
        scene.jet.brightness = 6.0;
        scene.quality.max_error_light = 1e-4;
        let smooth = light(&scene, [48, 40], 1e-4);
        // Little enough for the nodes of a single ray, which has no filter.
        scene.jet.knots = 0.1;
        let uneven = light(&scene, [48, 40], 1e-4);
        let changes = smooth.iter().zip(&uneven).map(|(a, b)| [a[1], b[1]]);
        let changed = quantile(&errors(&changes.collect::<Vec<_>>()), 0.9);
        let errors = errors(&uneven);
        let [median, most] = [0.5, 0.95].map(|share| quantile(&errors, share));
        println!(
            "{structure:?}: {} lit, {median:.1e} {most:.1e}; knots {changed:.1e}",
            errors.len()
        );
        // A ray that touches the sheath's rim meets more crests than it has nodes: a tenth of the pixels.
        assert!(changed > 0.1, "{structure:?}: {changed:e}");
        assert!(
            median < 5e-3 && most < 0.2,
            "{structure:?}: {median:e} {most:e}"
        );
    }
}
