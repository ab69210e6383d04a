//! Rings too narrow for f32 to tell whether a ray meets them: a class of its own.

use crate::gpu;
use glam::DVec3;
use lightfall_core::accuracy::Ray;
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::{Method, Scene};
use lightfall_lab::extremes::{Cell, Verdict, measure_matrix};

/// The middle of the ring, in r_s.
const RADIUS: f64 = 5.0;
const RAYS: usize = 1000;

/// A ring of this width, as a share of its radius, seen from near.
fn scene(width: f64) -> Scene {
    let mut scene = Scene::default();
    (scene.camera.r, scene.camera.theta_deg) = (12.0, 60.0);
    scene.disk.follow_isco = false;
    scene.disk.inner = RADIUS * (1.0 - 0.5 * width);
    scene.disk.outer = RADIUS * (1.0 + 0.5 * width);
    scene
}

/// The directions on the observer's axes, from below the hole, in which a wide disk is met at the ring.
fn directions_to_ring() -> Vec<DVec3> {
    let mut wide = scene(0.0);
    (wide.disk.inner, wide.disk.outer) = (3.0, 100.0);
    let reference = Reference::new(&wide).unwrap();
    let direction = |i: usize| {
        let azimuth = 0.3 * (2.0 * (i as f64 + 0.5) / RAYS as f64 - 1.0);
        let at = |below: f64| {
            let (sin, cos) = azimuth.sin_cos();
            DVec3::new(-below.cos() * cos, below.sin(), below.cos() * sin)
        };
        let radius = |below: f64| reference.trace(at(below)).hits[0].map_or(0.0, |hit| hit.r);
        // Farther below the hole the near side of the disk is met farther outside.
        let mut bracket = [0.15, 0.6];
        for _ in 0..60 {
            let middle = 0.5 * (bracket[0] + bracket[1]);
            bracket[usize::from(radius(middle) > RADIUS)] = middle;
        }
        assert!((radius(bracket[1]) / RADIUS - 1.0).abs() < 1e-12);
        at(bracket[1])
    };
    (0..RAYS).map(direction).collect()
}

fn verdict(width: f64, directions: &[DVec3]) -> Verdict {
    let scene = scene(width);
    let to_camera = scene.camera.tetrad_from_camera().transpose();
    let cell = Cell {
        group: "disk",
        name: format!("a ring of {width:e} of its radius"),
        rays: directions
            .iter()
            .map(|direction| Ray::toward(to_camera * *direction))
            .collect(),
        scene,
    };
    let verdicts = measure_matrix(gpu(), &[cell], &[Method::Closed], |_, _| {}).unwrap();
    verdicts[0].clone()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn rays_at_a_ring_below_the_resolution_of_f32_are_counted_apart_and_at_a_wider_one_none_is() {
    let directions = directions_to_ring();
    // Two units of f32's last place.
    let narrow = verdict(2e-7, &directions);
    println!("{narrow:?}");
    assert!(narrow.misclassified > 50, "{narrow:?}");
    assert_eq!(narrow.unanswerable, narrow.misclassified, "{narrow:?}");
    assert!(narrow.holds && narrow.unexplained == 0, "{narrow:?}");
    let wide = verdict(1e-4, &directions);
    println!("{wide:?}");
    assert_eq!((wide.misclassified, wide.unanswerable), (0, 0), "{wide:?}");
    assert!(wide.hits == RAYS && wide.holds, "{wide:?}");
}
