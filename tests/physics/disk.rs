use crate::{assert_close, reference::directions};
use lightfall::{
    physics::{disk, kerr::Kerr, reference::Reference},
    scene::{Disk, DiskModel, Scene},
};
use std::f64::consts::PI;

/// chi, r/M, then g of the most blue-shifted, the most red-shifted and the L = 0 ray to an observer at infinity in the
/// plane: reference/numerics.md 4.9.
const REDSHIFT: [[f64; 5]; 5] = [
    [0.0, 10.0, 1.294_244_589_36, 0.618_121_185_576, 0.836_660_026_534],
    [0.0, 20.0, 1.206_276_556_84, 0.746_097_563_53, 0.921_954_445_729],
    [0.9, 6.0, 1.352_161_500_45, 0.493_037_752_105, 0.743_444_058_715],
    [0.9, 10.0, 1.278_983_979_38, 0.625_496_497_924, 0.845_936_298_536],
    [0.998, 6.0, 1.347_858_348_41, 0.494_611_816_926, 0.746_674_190_559],
];

/// The extreme rays leave along or against the motion: lambda = (r^2 + a^2 +- a sqrt(Delta)) / (a +- sqrt(Delta)). The
/// table carries twelve digits, so half a unit of the last is 5e-12.
#[test]
fn disk_redshifts_are_those_of_the_table() {
    for [chi, r, bluest, reddest, middle] in REDSHIFT {
        let (kerr, r, a) = (Kerr { spin: chi }, r / 2.0, chi / 2.0);
        let (orbit, root) = (kerr.circular_orbit(r).unwrap(), (r * r - r + a * a).sqrt());
        let lambda = |root: f64| (r * r + a * a + a * root) / (a + root);
        for (lambda, expected) in [(lambda(root), bluest), (lambda(-root), reddest), (0.0, middle)] {
            assert_close(format_args!("chi {chi}, r {r}"), disk::redshift(&orbit, 1.0, lambda), expected, 5e-12);
        }
    }
}

/// Seen along the axis every ray has L = 0, so g = sqrt(1 - 3/(2r)) / sqrt(1 - 1/r0) by the article's formula, whatever
/// way the ray took. 1e-13 leaves room for rounding only.
#[test]
fn disk_seen_face_on_has_the_redshift_of_gravity_and_transverse_motion() {
    let mut scene = Scene::default();
    scene.camera.theta_deg = 0.0;
    let reference = Reference::new(&scene).unwrap();
    let mut seen = 0;
    for i in 0..40 {
        let angle = 0.01 * f64::from(i);
        for hit in
            reference.trace(glam::DVec3::new(-1.0, angle.cos() * angle, angle.sin() * angle)).hits.into_iter().flatten()
        {
            let expected = (1.0 - 1.5 / hit.r).sqrt() / (1.0 - 1.0 / scene.camera.r).sqrt();
            assert_close(format_args!("r = {}", hit.r), hit.g, expected, 1e-13);
            seen += 1;
        }
    }
    assert!(seen > 20, "only {seen} hits");
}

/// Matter at negative phi comes toward a camera at phi = 0 when it turns toward growing phi.
#[test]
fn disk_is_bluer_on_its_approaching_side() {
    let mut scene = Scene::default();
    scene.camera.theta_deg = 80.0;
    let reference = Reference::new(&scene).unwrap();
    let g = |d_phi: f64| reference.trace(glam::DVec3::new(-1.0, 0.02, d_phi)).hits[0].unwrap().g;
    assert!(g(-0.3) > 1.1 && g(0.3) < 0.9, "left {}, right {}", g(-0.3), g(0.3));
}

#[test]
fn disk_begins_at_the_isco_where_that_lies_outside_the_given_edge() {
    let mut scene = Scene::default();
    assert_eq!(disk::inner_edge(&scene), 3.0);
    scene.hole.spin = -0.9;
    assert_close("retrograde", disk::inner_edge(&scene), 8.717_352_279_606 / 2.0, 1e-12);
    scene.hole.spin = 0.9;
    assert_eq!(disk::inner_edge(&scene), 3.0);
}

/// The zero-torque profile peaks at (49/36) r_in with F = (36/49)^3 / 7: its derivative set to zero by hand.
#[test]
fn disk_flux_peaks_where_the_zero_torque_profile_does() {
    let flux = |r: f64| disk::flux(DiskModel::Newtonian, r, 3.0);
    let peak = 3.0 * 49.0 / 36.0;
    assert_close("peak", flux(peak), (36.0_f64 / 49.0).powi(3) / 7.0, 1e-14);
    assert!(flux(peak * 1.001) < flux(peak) && flux(peak * 0.999) < flux(peak));
    assert_eq!([flux(3.0), flux(2.0)], [0.0, 0.0]);
    let temperature = disk::temperature(&Disk::default(), peak, 3.0);
    assert_close("temperature", temperature, 18_000.0 * flux(peak).sqrt().sqrt(), 1e-14);
}

/// The two hits are crossings in the order of the backward ray, within the annulus, and a third is not recorded over them:
/// the same annulus cut at the first hit's radius keeps exactly the other.
#[test]
fn disk_hits_are_the_first_two_crossings_of_the_annulus() {
    let view = Scene::default();
    let reference = Reference::new(&view).unwrap();
    let mut double = 0;
    for d in directions(20_000).filter(|d| d.x < -0.8) {
        let [first, second] = reference.trace(d).hits;
        assert!(first.is_some() || second.is_none());
        for hit in [first, second].into_iter().flatten() {
            assert!(hit.r > 3.0 && hit.r < 11.0 && hit.phi > -PI && hit.phi <= PI, "{d}: {hit:?}");
        }
        if let (Some(first), Some(second)) = (first, second) {
            double += 1;
            let mut narrow = view.clone();
            if first.r < second.r {
                narrow.disk.inner = 0.5 * (first.r + second.r);
            } else {
                narrow.disk.outer = 0.5 * (first.r + second.r);
            }
            assert_eq!(Reference::new(&narrow).unwrap().trace(d).hits[0], Some(second), "{d}");
        }
    }
    assert!(double > 20, "only {double} rays hit twice");
}
