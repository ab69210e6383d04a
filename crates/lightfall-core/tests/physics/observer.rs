//! Observer matrices against the metric, boosts, conserved energies and special relativity.

use crate::assert_close;
use crate::random::Random;
use glam::{DMat3, DVec3, Vec3, Vec4};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::PhotonConstants;
use lightfall_core::geometry::observer::{
    ExpandedMatrix, ObserverError, ObserverMatrix, Photon, observer_matrix,
};
use lightfall_core::geometry::sphere::celestial_frame;
use lightfall_core::gpu::GpuScene;
use lightfall_core::optics::reference::Reference;
use lightfall_core::scene::ObserverKind::{Orbit, Rain, Static, Zamo};
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::{FRAC_PI_2, PI};

const MOVING: [f64; 3] = [0.3, -0.5, 0.4];

fn matrix(spin: f64, kind: ObserverKind, velocity: [f64; 3], r: f64, theta: f64) -> ObserverMatrix {
    observer_matrix(spin, kind, velocity, r, theta, 0.7).unwrap()
}

/// The places and observers of the tests below.
fn observers() -> Vec<(f64, ObserverKind, [f64; 3], f64, f64)> {
    let mut all = Vec::new();
    for spin in [-0.998, -0.4, 0.0, 0.7, 0.998] {
        for velocity in [[0.0; 3], MOVING] {
            for r in [1.02, 2.5, 20.0, 1e6] {
                for theta in [0.3, 1.2, FRAC_PI_2, 3.0] {
                    all.extend([Static, Zamo, Rain].map(|kind| (spin, kind, velocity, r, theta)));
                }
                if r > (Kerr { spin }).photon_orbit_prograde() {
                    all.push((spin, Orbit, velocity, r, FRAC_PI_2));
                }
            }
        }
    }
    all
}

/// The product of two momenta given as columns of the matrix, by the inverse metric in
/// Boyer-Lindquist components (Bardeen, Press & Teukolsky 1972 section II), independent of the
/// derivation of the rows.
fn product(spin: f64, r: f64, theta: f64, left: [f64; 4], right: [f64; 4]) -> f64 {
    let (a, sin, cos) = (spin / 2.0, theta.sin(), theta.cos());
    let (sigma, delta) = (r * r + (a * cos).powi(2), r * r - r + a * a);
    let area = (r * r + a * a).powi(2) - a * a * delta * sin * sin;
    let [(p_t, p_r, p_theta, p_phi), (q_t, q_r, q_theta, q_phi)] =
        [left, right].map(|[energy, radial, w_theta, w_phi]| {
            (
                -energy,
                radial * r * r / delta,
                r * w_theta,
                r * sin * w_phi,
            )
        });
    -area / (sigma * delta) * p_t * q_t - a * r / (sigma * delta) * (p_t * q_phi + p_phi * q_t)
        + delta / sigma * p_r * q_r
        + p_theta * q_theta / sigma
        + (delta - (a * sin).powi(2)) / (sigma * delta * sin * sin) * p_phi * q_phi
}

/// The matrix's columns are the covectors of e_t, -e_r, -e_theta, -e_phi. The tolerance is 1e-12 of
/// the largest term of a product, which is large near the horizon.
#[test]
fn tetrads_are_orthonormal_in_the_metric() {
    let mut compared = 0;
    for (spin, kind, velocity, r, theta) in observers() {
        if spin.abs() > 0.9 && r < 1.1 && kind == Static {
            continue;
        }
        let Ok(matrix) = observer_matrix(spin, kind, velocity, r, theta, 0.7) else {
            continue;
        };
        let [_, theta_hat, phi_hat] = celestial_frame(theta, 0.7);
        let column = |j: usize| {
            let w = DVec3::new(matrix.rows[2][j], matrix.rows[3][j], matrix.rows[4][j]);
            [
                matrix.rows[0][j],
                matrix.rows[1][j],
                w.dot(theta_hat),
                w.dot(phi_hat),
            ]
        };
        for i in 0..4 {
            for j in 0..4 {
                let expected = [[-1.0, 1.0][usize::from(i > 0)], 0.0][usize::from(i != j)];
                let found = product(spin, r, theta, column(i), column(j));
                let size = product_size(spin, r, theta, column(i), column(j));
                assert!(
                    (found - expected).abs() < 1e-13 * size.max(1.0),
                    "{kind:?} {velocity:?}, spin {spin}, r {r}, theta {theta}: e_{i}.e_{j} = {found}, terms {size:e}"
                );
            }
        }
        compared += 1;
    }
    assert!(compared > 50, "{compared} observers");
}

/// The sum of the magnitudes of the product's terms, to which its rounding errors are proportional.
fn product_size(spin: f64, r: f64, theta: f64, left: [f64; 4], right: [f64; 4]) -> f64 {
    let unit = |i: usize| -> [f64; 4] { std::array::from_fn(|k| f64::from(u8::from(k == i))) };
    let pairs = (0..16).map(|n| (n / 4, n % 4));
    pairs
        .map(|(i, j)| (left[i] * right[j] * product(spin, r, theta, unit(i), unit(j))).abs())
        .sum()
}

/// U(u) = u'^2 and the two constraints on n' together are the null condition, in variables that are
/// regular at the poles and inside the horizon.
#[test]
fn photons_of_every_observer_are_null_at_the_poles_and_inside_the_horizon_too() {
    let mut places = observers();
    for spin in [-0.9, 0.0, 0.6, 0.998] {
        for theta in [0.0, 1e-12, 1e-3, PI - 1e-9, PI] {
            for velocity in [[0.0; 3], MOVING] {
                places.extend([Static, Zamo, Rain].map(|kind| (spin, kind, velocity, 3.0, theta)));
                let kerr = Kerr { spin };
                let middle = 0.5 * (kerr.horizon() + kerr.inner_horizon());
                places.extend([kerr.horizon(), middle].map(|r| (spin, Rain, velocity, r, theta)));
            }
        }
    }
    let mut checked = 0;
    for (spin, kind, velocity, r, theta) in places {
        let Ok(matrix) = observer_matrix(spin, kind, velocity, r, theta, 0.7) else {
            continue;
        };
        for direction in [
            DVec3::X,
            DVec3::Y,
            DVec3::NEG_Z,
            DVec3::new(-0.48, 0.6, 0.64),
            DVec3::new(0.6, -0.64, 0.48),
        ] {
            let [n, ..] = celestial_frame(theta, 0.7);
            let photon = matrix.photon(direction);
            let (constants, start) = PhotonConstants::of_photon(Kerr { spin }, &photon, r, n);
            let residual = constants.residual(&start);
            assert!(
                residual < 3e-13,
                "{kind:?}, spin {spin}, r {r}, theta {theta}, {direction}: {residual:e}"
            );
            checked += 1;
        }
    }
    assert!(checked > 1500, "only {checked}");
}

/// Each kind is the ZAMO seen through one boost: along phi with the speed (Omega - omega)
/// sin(theta) A / (Sigma sqrt(Delta)) of an observer that orbits with Omega (Bardeen, Press &
/// Teukolsky 1972 section III), or inward with sqrt(1 - 1/gamma^2), gamma = 1/N for free fall from
/// rest.
#[test]
fn observer_kinds_are_pure_boosts_of_the_zamo() {
    let mut compared = [0; ObserverKind::ALL.len()];
    for spin in [-0.9, 0.0, 0.5, 0.98] {
        for (r, theta) in [
            (2.5, FRAC_PI_2),
            (2.5, 0.4),
            (1.2, 0.2),
            (300.0, 2.0),
            (4.0, 0.0),
        ] {
            let (a, sin, cos) = (spin / 2.0, theta.sin(), theta.cos());
            let (sigma, delta) = (r * r + (a * cos).powi(2), r * r - r + a * a);
            let area = (r * r + a * a).powi(2) - a * a * delta * sin * sin;
            let turning = |omega: f64| {
                [
                    0.0,
                    0.0,
                    sin * (omega - a * r / area) * area / (sigma * delta.sqrt()),
                ]
            };
            let falling = [-(1.0 - sigma * delta / area).sqrt(), 0.0, 0.0];
            let mut pairs = vec![(Static, turning(0.0)), (Rain, falling)];
            let kerr = Kerr { spin };
            if let Some(orbit) = kerr.circular_orbit(r).filter(|_| theta == FRAC_PI_2) {
                pairs.push((Orbit, turning(orbit.angular_velocity)));
            }
            for (kind, boost) in pairs {
                let Ok(found) = observer_matrix(spin, kind, [0.0; 3], r, theta, 0.7) else {
                    continue;
                };
                let expected = matrix(spin, Zamo, boost, r, theta);
                for (found, expected) in found
                    .rows
                    .into_iter()
                    .flatten()
                    .zip(expected.rows.into_iter().flatten())
                {
                    assert!(
                        (found - expected).abs() < 1e-12,
                        "{kind:?}, spin {spin}, r {r}, theta {theta}: {found} {expected}"
                    );
                }
                compared[kind as usize] += 1;
            }
        }
    }
    for kind in [Static, Orbit, Rain] {
        assert!(compared[kind as usize] > 1, "{kind:?}: {compared:?}");
    }
}

#[test]
fn an_expanded_matrix_gives_random_photons_of_the_matrix_which_leads_back_to_their_directions() {
    let mut random = Random::new();
    for (spin, kind, velocity, r, theta) in observers() {
        let matrix = matrix(spin, kind, velocity, r, theta);
        let [n, ..] = celestial_frame(theta, 0.7);
        let expanded = ExpandedMatrix::new(&matrix, r);
        let size = matrix
            .rows
            .as_flattened()
            .iter()
            .map(|entry| entry.abs())
            .fold(0.0, f64::max);
        for _ in 0..20 {
            let direction = DVec3::from_array([(); 3].map(|()| random.between(-1.0, 1.0)));
            let direction = direction.normalize();
            let (given, known) = (expanded.photon(direction), matrix.photon(direction));
            // Some ten roundings of numbers of this size.
            let tolerance = 3e-15 * size;
            let error = (given.energy - known.energy)
                .abs()
                .max((given.radial - known.radial).abs())
                .max((given.w - known.w).length());
            assert!(error < tolerance, "{error:e} {given:?} {known:?}");
            let twice = Photon {
                energy: 2.0 * given.energy,
                radial: 2.0 * given.radial,
                w: 2.0 * given.w,
            };
            let back = matrix.direction_of(&twice, n).expect("a frequency");
            assert!((back - direction).length() < 1e-11, "{back} {direction}");
        }
    }
}

/// Special relativity far from the hole: light from ahead is shifted by sqrt((1 + v)/(1 - v)), and
/// E is its inverse. The hole's own potential at 1e12 is below the tolerance.
#[test]
fn moving_observers_see_the_doppler_shift() {
    for v in [0.1, 0.9, 0.999_999] {
        let moving = matrix(0.5, Static, [0.0, v, 0.0], 1e12, 1.0);
        let shift = ((1.0 - v) / (1.0 + v)).sqrt();
        // For light from ahead rounding errors grow with gamma^2, which is 2.5e5 at most here.
        assert_close("ahead", moving.photon(DVec3::Y).energy, shift, 1e-9);
        assert_close(
            "behind",
            moving.photon(DVec3::NEG_Y).energy,
            1.0 / shift,
            1e-11,
        );
    }
}

/// On the axis phi only rotates the axes, and everything is continuous on the way there.
#[test]
fn poles_are_ordinary_places() {
    for spin in [-0.8, 0.0, 0.99] {
        for kind in [Static, Zamo, Rain] {
            for theta in [0.0, PI] {
                let rows = |theta: f64, phi: f64| {
                    observer_matrix(spin, kind, MOVING, 2.0, theta, phi)
                        .unwrap()
                        .rows
                };
                let (here, near, turned) = (
                    rows(theta, 0.7),
                    rows((theta - 1e-9).abs(), 0.7),
                    rows(theta, 1.9),
                );
                for (here, near) in here.into_iter().flatten().zip(near.into_iter().flatten()) {
                    assert!(
                        (here - near).abs() < 1e-8,
                        "{kind:?}, spin {spin}: {here} and {near}"
                    );
                }
                for j in 0..4 {
                    let w = |rows: [[f64; 4]; 5]| DVec3::new(rows[2][j], rows[3][j], rows[4][j]);
                    let error = (DMat3::from_rotation_z(1.2) * w(here) - w(turned)).length();
                    assert!(
                        error < 1e-14,
                        "{kind:?}, spin {spin}, column {j}: {error:e}"
                    );
                    assert_eq!((here[0][j], here[1][j]), (turned[0][j], turned[1][j]));
                }
            }
        }
    }
}

#[test]
fn impossible_observers_are_refused_with_a_sentence_that_names_the_field() {
    let refused = |spin, kind, velocity, r, theta| {
        observer_matrix(spin, kind, velocity, r, theta, 0.0).unwrap_err()
    };
    let still = [0.0; 3];
    let cases = [
        (
            refused(0.9, Static, still, 0.99, FRAC_PI_2),
            "camera.r is 0.99",
        ),
        (refused(0.9, Zamo, still, 0.7, 1.0), "camera.r is 0.7"),
        (
            refused(0.0, Orbit, still, 1.5, FRAC_PI_2),
            "camera.r is 1.5",
        ),
        (
            refused(0.0, Orbit, still, 5.0, 1.4),
            "camera.theta_deg is 80.2",
        ),
        (
            refused(0.0, Rain, [0.6, 0.8, 0.0], 5.0, 1.4),
            "observer.velocity is [0.6, 0.8, 0.0]",
        ),
        (
            refused(0.0, Rain, [f64::NAN, 0.0, 0.0], 5.0, 1.4),
            "observer.velocity",
        ),
        (refused(1.0, Rain, still, 5.0, 1.4), "hole.spin is 1"),
        (refused(f64::NAN, Rain, still, 5.0, 1.4), "hole.spin is NaN"),
        (refused(0.0, Rain, still, 0.0, 1.4), "camera.r is 0"),
        (refused(0.8, Rain, still, 0.2, 1.4), "camera.r is 0.2"),
        (refused(0.0, Rain, still, f64::NAN, 1.4), "camera.r is NaN"),
        (
            refused(0.0, Rain, still, 3.0, f64::INFINITY),
            "camera.theta_deg is inf",
        ),
    ];
    for (error, start) in cases {
        assert!(
            error.to_string().starts_with(start),
            "\"{error}\" does not start with \"{start}\""
        );
    }
    assert!(matches!(
        refused(0.9, Static, still, 1.0, FRAC_PI_2),
        ObserverError::Static { .. }
    ));
    assert!(
        observer_matrix(0.9, Zamo, still, 0.99, FRAC_PI_2, 0.0).is_ok(),
        "a ZAMO may be in the ergosphere"
    );
}

/// A component of the photon that arrives from `direction`, as shaders/observer.wgsl computes it.
fn component_in_f32(row: Vec4, curvature: f32, off: Vec3) -> f32 {
    row.dot(Vec4::from((1.0, off))) + curvature * (0.5 * off.dot(off))
}

/// In the ergosphere photons of the sky are a thousand times smaller than the matrix of a fast
/// observer. Differences of its entries would leave them four digits. About the smallest photon each
/// component is a sum of five terms that are up to ten times the photon's size; f32 rounds each of
/// them, and each sum, by at most 6e-8 of it.
#[test]
fn small_random_photons_keep_their_digits_in_f32() {
    const MAX_ERROR: f64 = 6e-6;
    let mut random = Random::new();
    let mut worst = 0.0_f64;
    for case in 0..200 {
        let mut scene = Scene::default();
        scene.hole.spin = random.between(0.5, 0.99) * [-1.0, 1.0][case % 2];
        let horizon = Kerr {
            spin: scene.hole.spin,
        }
        .horizon();
        scene.camera.r = horizon * random.between(1.005, 1.1);
        scene.camera.theta_deg = random.between(40.0, 140.0);
        scene.observer.kind = [Zamo, Rain][case / 2 % 2];
        let velocity = DVec3::from_array([(); 3].map(|()| random.between(-1.0, 1.0)));
        scene.observer.velocity = (random.between(0.0, 0.99) * velocity.normalize()).to_array();
        let reference = Reference::new(&scene).unwrap();
        let observer = GpuScene::for_rays(&scene).unwrap().observer;
        let size = |photon: &Photon| photon.energy.hypot(scene.camera.r * photon.w.length());
        for _ in 0..200 {
            let direction = DVec3::from_array([(); 3].map(|()| random.between(-1.0, 1.0)))
                .normalize()
                .as_vec3();
            let known = reference.photon(direction.as_dvec3().normalize());
            let off = direction - observer.expansion_centre;
            let energy = component_in_f32(observer.energy, observer.energy_curvature, off);
            let w = [
                component_in_f32(observer.w_x, observer.curvature.y, off),
                component_in_f32(observer.w_y, observer.curvature.z, off),
                component_in_f32(observer.w_z, observer.curvature.w, off),
            ];
            let error = (f64::from(energy) - known.energy)
                .hypot(scene.camera.r * (DVec3::from_array(w.map(f64::from)) - known.w).length());
            let error = error / size(&known);
            worst = worst.max(error);
            assert!(
                error < MAX_ERROR,
                "{scene:?} {direction}: {error:e} {known:?}"
            );
        }
    }
    println!("{worst:e}");
}
