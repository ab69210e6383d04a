//! A camera that has fallen into a spinning hole: the reference against closed forms and limits.
//! Another code's answers from inside are in kerr_schild.rs, the motion there in timelike.rs and
//! thrown.rs.

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

/// Places from the horizon to where motion ends.
fn depths(spin: f64) -> [f64; 4] {
    let (horizon, end) = (Kerr { spin }.horizon(), min_infall_radius(Kerr { spin }));
    [1.0, 0.9, 0.5, 0.0].map(|share| end + share * (horizon - end))
}

/// Along the ingoing principal null rays, L = a E sin^2(theta) and Sigma p^r = -E Sigma, neither
/// theta nor the ingoing azimuth changes (Misner, Thorne & Wheeler 1973 box 33.2): who looks along
/// one sees the place of the sky that she is below, from wherever she is. Only rounding is left.
#[test]
fn along_a_principal_null_ray_the_sky_is_straight_overhead() {
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

/// A spin of 1e-9 changes what is seen by as much times what lensing stretches it by, some
/// thousands next to the critical curve.
#[test]
fn without_spin_it_is_schwarzschilds_inside() {
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

/// The motion from just outside to just inside turns the picture by as much as the way is long, and
/// by nothing else: the azimuth's name changes there, and the sky does not.
#[test]
fn the_horizon_is_no_place_in_the_picture() {
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

/// Every backward ray from inside moves outward until it is outside, and keeps its constants.
#[test]
fn no_ray_from_inside_is_given_up() {
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
