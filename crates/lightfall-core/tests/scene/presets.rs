//! The built-in presets: they load, and they show what their titles promise.

use lightfall_core::scene::presets::{DEFAULT, PRESETS, Preset, find};
use lightfall_core::scene::{Override, Scene, SkyMode};

fn scene(number: usize) -> Scene {
    PRESETS[number - 1].scene(&[]).unwrap()
}

/// The unit vector at these angles, in degrees.
fn place(theta_deg: f64, phi_deg: f64) -> [f64; 3] {
    let ((st, ct), (sp, cp)) = (
        theta_deg.to_radians().sin_cos(),
        phi_deg.to_radians().sin_cos(),
    );
    [st * cp, st * sp, ct]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Half the height of the picture at unit distance.
fn half_height(scene: &Scene) -> f64 {
    (scene.camera.fov_deg / 2.0).to_radians().tan()
}

#[test]
fn every_preset_loads_under_its_own_name_with_a_title() {
    for preset in PRESETS {
        let scene = preset.scene(&[]).unwrap();
        assert_eq!(scene.name, preset.name);
        assert!((10..80).contains(&scene.title.len()), "{}", scene.title);
        assert!(
            preset.text.starts_with("# "),
            "{} teaches nothing",
            preset.name
        );
    }
}

#[test]
fn presets_are_numbered_from_one_and_found_by_number_and_name() {
    for (i, preset) in PRESETS.iter().enumerate() {
        assert_eq!(preset.number, i + 1);
        assert_eq!(find(&preset.number.to_string()), Some(preset));
        assert_eq!(find(preset.name), Some(preset));
    }
    let none: Vec<Option<&Preset>> = ["0", "19", "02", "", "nothing"].map(find).to_vec();
    assert_eq!(none, [None; 5]);
    assert_eq!(PRESETS[DEFAULT - 1].name, "edge-on");
}

#[test]
fn an_override_that_a_preset_does_not_allow_is_blamed() {
    let error = PRESETS[0]
        .scene(&[Override::new("--set", "disk.outer", "1")])
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("--set: disk.outer = 1 is refused: it must be a number above 3 "),
        "{error}"
    );
}

#[test]
fn the_distant_and_the_edge_on_view_show_the_whole_width_of_the_disk() {
    for number in [1, 2] {
        let scene = scene(number);
        // The disk's widest angle in flat space: lensing widens it by less than the room left.
        let widest = (scene.disk.outer / scene.camera.r).asin().tan();
        let half_width =
            half_height(&scene) * f64::from(scene.picture.width) / f64::from(scene.picture.height);
        let filled = widest / half_width;
        assert!(
            (0.7..0.95).contains(&filled),
            "preset {number} fills {filled} of its width"
        );
    }
}

#[test]
fn the_star_of_the_ring_stands_exactly_behind_the_hole() {
    let scene = scene(5);
    let behind = place(scene.sky.reference_theta_deg, scene.sky.reference_phi_deg);
    let camera = place(scene.camera.theta_deg, scene.camera.phi_deg);
    // 1e-15 in the cosine is 5e-8 radians, far below the star's own radius.
    assert!((dot(behind, camera) + 1.0).abs() < 1e-15);
    assert!(scene.sky.reference_star && scene.sky.mode != SkyMode::Off && !scene.disk.enabled);
}

#[test]
fn the_ring_fills_about_half_of_the_height() {
    let scene = scene(5);
    // Weak field, an observer at r and a source at infinity: the ring's angle is sqrt(2 r_s / r),
    // low by some percent.
    let filled = (2.0 / scene.camera.r).sqrt().tan() / half_height(&scene);
    assert!((0.4..0.6).contains(&filled), "{filled}");
}

#[test]
fn the_probe_is_near_the_camera_inside_the_picture_and_to_one_side() {
    let Scene { camera, probe, .. } = scene(6);
    let (c, p) = (
        place(camera.theta_deg, camera.phi_deg),
        place(probe.theta_deg, probe.phi_deg),
    );
    let to_probe: [f64; 3] = std::array::from_fn(|i| probe.r * p[i] - camera.r * c[i]);
    // The camera looks at the hole: forward is -c, right toward growing phi, up toward decreasing
    // theta.
    let forward = c.map(|c| -c);
    let right = [
        -camera.phi_deg.to_radians().sin(),
        camera.phi_deg.to_radians().cos(),
        0.0,
    ];
    let up = place(camera.theta_deg - 90.0, camera.phi_deg);
    let distance = dot(to_probe, forward);
    assert!((1.2..4.0).contains(&distance), "{distance}");
    let scene = scene(6);
    let half = half_height(&scene);
    let (x, y) = (
        dot(to_probe, right) / distance / half / (16.0 / 9.0),
        dot(to_probe, up) / distance / half,
    );
    assert!(
        (0.2..0.6).contains(&x.abs()) && y.abs() < 0.6,
        "at ({x}, {y}) of the half picture"
    );
    let spans = probe.size / distance / (2.0 * half * 16.0 / 9.0);
    assert!(
        (1.0 / 8.0..1.0 / 5.0).contains(&spans),
        "spans {spans} of the width"
    );
    assert!(probe.enabled);
}

#[test]
fn near_the_limit_the_edge_of_the_cone_crosses_the_picture() {
    let Scene { camera, .. } = scene(7);
    // The shadow's half-angle: sin^2 = (27/4) (1 - 1/r)/r^2, and inside 1.5 r_s it is the obtuse
    // one; Synge 1966.
    let sine = (27.0 / 4.0 * (1.0 - 1.0 / camera.r)).sqrt() / camera.r;
    let cone_deg = sine.asin().to_degrees();
    let centre_deg = 180.0 - camera.pitch_deg;
    let below = cone_deg - centre_deg;
    assert!(
        camera.r == 1.12 && below > 0.0 && below < camera.fov_deg / 2.0,
        "edge {below} degrees below the centre"
    );
    assert!(
        centre_deg < camera.fov_deg / 2.0,
        "outward is in the picture"
    );
}
