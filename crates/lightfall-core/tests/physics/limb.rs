//! Limb darkening, against Chandrasekhar's table and cosines of emission from two other
//! computations.

use crate::assert_close;
use glam::DVec2;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::quadrature::integral;
use lightfall_core::optics::limb::{Limb, electron_scattering};
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::shift::RestFrame;
use lightfall_core::scene::{LimbDarkening, Scene};
use std::f64::consts::FRAC_PI_2;

/// Intensity over its mean at mu = 0, 0.05, ... 1: Chandrasekhar 1960, Radiative Transfer, table
/// XXIV.
const CHANDRASEKHAR: [f64; 21] = [
    0.41441, 0.47490, 0.52397, 0.57001, 0.61439, 0.65770, 0.70029, 0.74234, 0.78398, 0.82530,
    0.86637, 0.90722, 0.94789, 0.98842, 1.02882, 1.06911, 1.10931, 1.14943, 1.18947, 1.22945,
    1.26938,
];

/// Spin, pixel and mu, for a static camera at r = 20, theta = 83 degrees with a picture of 960 x
/// 540 pixels and a field of 50 degrees. Two computations agree on them: Walker and Penrose's
/// constant, and light carried along the ray by the connection of Kerr-Schild coordinates.
pub const COSINES: [(f64, [f64; 2], f64); 14] = [
    (0.0, [200.5, 300.5], 0.192_910),
    (0.0, [760.5, 300.5], 0.120_136),
    (0.0, [480.5, 150.5], 0.578_764),
    (0.0, [430.5, 190.5], 0.826_610),
    (0.0, [600.5, 215.5], 0.219_449),
    (0.0, [300.5, 240.5], 0.155_155),
    (0.0, [480.5, 380.5], 0.507_406),
    (0.9, [200.5, 300.5], 0.192_010),
    (0.9, [760.5, 300.5], 0.120_880),
    (0.9, [480.5, 150.5], 0.571_580),
    (0.9, [430.5, 190.5], 0.659_720),
    (0.9, [600.5, 215.5], 0.254_625),
    (0.9, [300.5, 240.5], 0.140_824),
    (0.9, [480.5, 380.5], 0.492_603),
];

fn scene(spin: f64) -> Scene {
    let mut scene = Scene::default();
    (scene.hole.spin, scene.disk.follow_isco) = (spin, true);
    (scene.camera.r, scene.camera.theta_deg, scene.camera.fov_deg) = (20.0, 83.0, 50.0);
    scene.disk.limb = LimbDarkening::ElectronScattering;
    scene
}

#[test]
fn limb_darkening_is_chandrasekhars_and_keeps_the_flux() {
    for (i, tabulated) in CHANDRASEKHAR.into_iter().enumerate() {
        let mu = 0.05 * i as f64;
        // The fit's own error, 0.24 %.
        assert_close(
            format!("mu = {mu}"),
            electron_scattering(mu),
            tabulated,
            2.5e-3,
        );
    }
    // In s = sqrt(mu) the integrand is a polynomial, so nothing but rounding is left.
    let flux = integral(0.0, 1.0, &|s| 4.0 * s.powi(3) * electron_scattering(s * s));
    assert_close("flux", flux, 1.0, 1e-14);
}

#[test]
fn limb_cosines_of_emission_are_those_of_two_other_computations() {
    for (spin, [x, y], mu) in COSINES {
        let scene = scene(spin);
        let reference = Reference::new(&scene).unwrap();
        let looking = scene
            .camera
            .looking(DVec2::new(x, y), scene.picture.size().as_dvec2());
        let direction = scene.camera.tetrad_from_camera() * looking;
        let hit = reference.trace(direction).hits[0].unwrap();
        let found = Limb::new(&scene)
            .cosine(&reference.photon(direction), hit.r)
            .unwrap();
        // Half of the last digit given.
        assert!(
            (found - mu).abs() < 5.1e-7,
            "{spin} ({x}, {y}): {found}, not {mu}"
        );
    }
}

#[test]
fn limb_cosines_without_lensing_are_those_of_a_straight_ray_boosted_to_the_matter() {
    let mut scene = scene(0.9);
    scene.effects.lensing = false;
    let kerr = Kerr { spin: 0.9 };
    let reference = Reference::new(&scene).unwrap();
    let mut compared = 0;
    for (_, [x, y], _) in COSINES {
        let looking = scene
            .camera
            .looking(DVec2::new(x, y), scene.picture.size().as_dvec2());
        let direction = scene.camera.tetrad_from_camera() * looking;
        let photon = reference.photon(direction);
        let Some(hit) = reference.trace(direction).hits[0] else {
            continue;
        };
        let (start, n) = (20.0 * scene.camera.direction(), scene.camera.direction());
        let to_disk = (-photon.radial * n - photon.w).normalize();
        let place = start - start.z / to_disk.z * to_disk;
        let along_phi = -to_disk.dot(glam::DVec3::Z.cross(place / hit.r));
        // The light's frequency for matter with speed v, per that for the ZAMO.
        let rest = RestFrame::at(kerr, hit.r, FRAC_PI_2);
        let orbit = kerr.circular_orbit(hit.r).unwrap();
        let v = (orbit.angular_velocity - rest.dragging) * rest.width / rest.lapse;
        let frequency = (1.0 - v * along_phi) / (1.0 - v * v).sqrt();
        let found = Limb::new(&scene).cosine(&photon, hit.r).unwrap();
        assert_close("mu", found, to_disk.z.abs() / frequency, 1e-12);
        compared += 1;
    }
    assert!(compared >= 2, "{compared} rays meet the disk");
}

#[test]
fn limb_darkening_changes_the_light_that_the_meter_sees() {
    use lightfall_core::optics::exposure::metered_exposure;
    let mut scene = lightfall_core::scene::presets::find("1")
        .unwrap()
        .scene(&[])
        .unwrap();
    scene.disk.limb = LimbDarkening::None;
    let plain = metered_exposure(&scene).unwrap().unwrap();
    scene.disk.limb = LimbDarkening::ElectronScattering;
    let darkened = metered_exposure(&scene).unwrap().unwrap();
    // A disk seen at mu of 0.1 to 0.6 is darkened to 0.5 to 0.95 of its mean.
    assert!(
        (0.1..1.0).contains(&(darkened - plain)),
        "{plain} {darkened}"
    );
}
