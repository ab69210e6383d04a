//! A camera inside a spinning hole: the reference against closed forms and limits. kerr_schild.rs
//! compares it with another code; timelike.rs and released.rs test the motion inside.

use crate::reference::directions;
use crate::timelike::scene;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::{Photon, min_infall_radius};
use lightfall_core::geometry::sphere::celestial_frame;
use lightfall_core::geometry::tetrad::rain_components;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{ObserverKind, Scene};

fn rain(spin: f64, r: f64, theta_deg: f64, velocity: [f64; 3]) -> Scene {
    scene(spin, ObserverKind::Rain, velocity, r, theta_deg)
}

/// Radii from the horizon to the smallest radius of motion.
fn depths(spin: f64) -> [f64; 4] {
    let (horizon, end) = (Kerr { spin }.horizon(), min_infall_radius(Kerr { spin }));
    [1.0, 0.9, 0.5, 0.0].map(|share| end + share * (horizon - end))
}

/// Along the ingoing principal null rays, L = a E sin^2(theta) and Sigma p^r = -E Sigma, neither
/// theta nor the ingoing azimuth changes (Misner, Thorne & Wheeler 1973 box 33.2). So an observer
/// that looks along such a ray sees the point of the sky above it, from every radius. The tolerance
/// allows only for rounding.
#[test]
fn along_a_principal_null_ray_the_sky_is_directly_overhead() {
    for spin in [-0.998, -0.4, 0.0, 0.7, 0.95, 0.9999] {
        for (r, theta_deg) in depths(spin)
            .into_iter()
            .flat_map(|r| [0.0, 35.0, 90.0, 140.0].map(|theta| (r, theta)))
        {
            let scene = rain(spin, r, theta_deg, [0.0; 3]);
            let (theta, phi) = (
                scene.camera.theta_deg.to_radians(),
                scene.camera.phi_deg.to_radians(),
            );
            let (kerr, [n, _, phi_hat]) = (Kerr { spin }, celestial_frame(theta, phi));
            let wanted = Photon {
                energy: 1.0,
                radial: -kerr.sigma(r, n.z) / (r * r),
                w: kerr.a() * n.truncate().length() / r * phi_hat,
            };
            let (frequency, momentum) = rain_components(kerr, r, theta, phi, &wanted, 0.0);
            let direction = -momentum / frequency;
            let trace = Reference::new(&scene).unwrap().trace(direction);
            let off = trace.sky.map(|sky| (sky - n).length());
            assert!(
                off.is_some_and(|off| off < 1e-11),
                "spin {spin}, r {r}, theta {theta_deg}: {trace:?} {n}"
            );
        }
    }
}

/// A spin of 1e-9 changes the picture by 1e-9 times the lensing magnification, which is some
/// thousands next to the critical curve.
#[test]
fn without_spin_the_inside_is_schwarzschilds() {
    for r in [1.0, 0.9, 0.5, 0.2] {
        for velocity in [[0.0; 3], [-0.3, 0.4, 0.5]] {
            let [still, turning] =
                [0.0, 1e-9].map(|spin| Reference::new(&rain(spin, r, 65.0, velocity)).unwrap());
            let (mut seen, mut differing) = (0, 0);
            for direction in directions(400) {
                let (one, other) = (still.trace(direction), turning.trace(direction));
                differing += u32::from(one.outcome != other.outcome);
                if let (Some(one), Some(other)) = (one.sky, other.sky) {
                    assert!((one - other).length() < 1e-5, "r {r}: {one} {other}");
                    seen += 1;
                }
            }
            assert!(
                seen > 80 && differing == 0,
                "r {r}: {seen} seen, {differing} differ"
            );
        }
    }
}

/// Between a place just outside the horizon and one just inside the picture changes only by the
/// distance between the two: the azimuth coordinate changes there, the sky does not.
#[test]
fn the_picture_is_continuous_through_the_horizon() {
    for (spin, theta_deg) in [(0.9, 90.0), (-0.9, 40.0), (0.998, 80.0), (0.3, 0.0)] {
        let kerr = Kerr { spin };
        let seen = |share: f64| {
            let r = kerr.horizon() * (1.0 + share);
            let mut scene = rain(spin, r, theta_deg, [0.2, 0.1, -0.3]);
            if share > 0.0 {
                scene.camera.phi_deg -= kerr.ingoing_azimuth_lead(r).to_degrees();
            }
            let reference = Reference::new(&scene).unwrap();
            directions(300)
                .map(|direction| reference.trace(direction))
                .collect::<Vec<_>>()
        };
        for (share, bar) in [(1e-5, 1e-2), (1e-8, 1e-5), (1e-13, 1e-5)] {
            let mut compared = 0;
            for (outside, inside) in seen(share).into_iter().zip(seen(-share)) {
                if let (Some(outside), Some(inside)) = (outside.sky, inside.sky) {
                    let off = (outside - inside).length();
                    assert!(
                        off < bar,
                        "spin {spin}, theta {theta_deg}, {share:e}: {off:e}"
                    );
                    compared += 1;
                }
            }
            assert!(compared > 60, "{compared}");
        }
    }
}

/// Every backward ray from inside moves outward until it has left the hole, and its constants hold.
#[test]
fn every_ray_from_inside_is_finished() {
    for spin in [-0.9999, -0.5, 0.05, 0.9, 0.999_999] {
        for r in depths(spin) {
            let reference = Reference::new(&rain(spin, r, 77.0, [0.0, 0.5, 0.5])).unwrap();
            for direction in directions(500) {
                let trace = reference.trace(direction);
                assert_ne!(
                    trace.outcome,
                    Outcome::Unfinished,
                    "spin {spin}, r {r}, {direction}"
                );
                assert!(
                    trace.residual < 1e-9,
                    "spin {spin}, r {r}, {direction}: {:e}",
                    trace.residual
                );
                assert!(reference.photon(direction).radial < 0.0 || r == Kerr { spin }.horizon());
            }
        }
    }
}
