//! Channels of matter with depth, against the light of the same picture.

use crate::linear::linear;
use lightfall_core::scene::{ObserverKind, Scene, SkyMode};

/// A disk that lets a part of the light through, with nothing behind it.
fn scene() -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = 0.9;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (20.0, 75.0, 60.0);
    scene.observer.kind = ObserverKind::Static;
    (
        scene.disk.follow_isco,
        scene.disk.outer,
        scene.disk.edge_taper,
    ) = (true, 11.0, 0.2);
    (scene.disk.thickness, scene.disk.depth) = (0.1, 1.0);
    scene.sky.mode = SkyMode::Off;
    scene.picture.antialias = false;
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn channels_of_matter_agree_with_the_light_of_the_picture() {
    let scene = scene();
    let linear = linear(&scene, "--aov medium --size 97x53");
    let of = |name: &str| linear.values(&format!("medium_{name}.Y"));
    let (transmission, depth, samples) = (of("transmission"), of("depth"), of("samples"));
    let (radius, error) = (of("radius"), of("error"));
    let [red, ..] = linear.light();
    let mut lit = 0;
    for i in 0..red.len() {
        assert!((depth[i] + transmission[i].ln()).abs() < 1e-5 * (1.0 + depth[i]));
        // Half-precision floats have no light as dim as that of some rays with a radius.
        assert!(
            !radius[i].is_nan() || red[i] == 0.0,
            "pixel {i}: {}",
            red[i]
        );
        if red[i] > 0.0 {
            lit += 1;
            let edges = scene.inner_edge()..scene.disk.outer;
            assert!(edges.contains(&radius[i]), "{}", radius[i]);
            assert!(samples[i] > 0.0 && error[i] >= 0.0);
        }
    }
    assert!(lit > 500, "{lit}");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn channels_of_a_scene_without_matter_say_that_there_is_none() {
    let mut thin = scene();
    thin.disk.thickness = 0.0;
    let linear = linear(&thin, "--aov medium --size 32x18");
    let all = |name: &str, is: fn(&f64) -> bool| linear.values(name).iter().all(is);
    assert!(all("medium_transmission.Y", |share| *share == 1.0));
    assert!(all("medium_depth.Y", |depth| *depth == 0.0));
    assert!(all("medium_samples.Y", |samples| *samples == 0.0));
    assert!(all("medium_radius.Y", |r| r.is_nan()));
}
