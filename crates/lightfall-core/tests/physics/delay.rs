//! How long light is under way: the reference against tabulated values, against the closed form
//! without spin, and against Carter's equation as it stands.

mod closed_form;
mod tabulated;

use crate::random::Random;
use closed_form::{Way, lag};
use glam::{DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::{PhotonConstants, PhotonState};
use lightfall_core::geometry::quadrature::gauss_legendre;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::optics::delay::Lag;
use lightfall_core::optics::reference::{HoleAndDisk, Reference};
use lightfall_core::optics::trace::{Hit, Outcome, Trace};
use lightfall_core::scene::{ObserverKind, Scene};
use std::f64::consts::{PI, TAU};

/// The accuracy that the delays claim, in r_s/c.
const CLAIM: f64 = 1e-9;

fn pixel_scene(spin: f64, theta_deg: f64) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (20.0, theta_deg, 0.0);
    scene.camera.fov_deg = 50.0;
    (scene.disk.follow_isco, scene.disk.outer) = (true, 11.0);
    scene
}

fn through_pixel(scene: &Scene, pixel: [f64; 2]) -> Trace {
    let size = DVec2::new(960.0, 540.0);
    let looking = scene.camera.looking(DVec2::from_array(pixel), size);
    let direction = scene.camera.tetrad_from_camera() * looking;
    Reference::new(scene).unwrap().trace_with_delays(direction)
}

/// A ray without spin and with E = 1 from the radius `r`, which sweeps the angle `to_plane` until
/// it crosses the disk's plane.
fn flat_ray(r: f64, b: f64, inward: bool, to_plane: f64) -> (PhotonConstants, PhotonState) {
    let constants = PhotonConstants {
        a: 0.0,
        energy: 1.0,
        angular_momentum: 0.0,
        k: b * b,
        ingoing: r <= 1.0,
    };
    let (sin, cos) = to_plane.sin_cos();
    let speed = constants.potential(1.0 / r).max(0.0).sqrt();
    let start = PhotonState {
        u: 1.0 / r,
        du: if inward { speed } else { -speed },
        n: DVec3::new(cos, 0.0, -sin),
        dn: b * DVec3::new(sin, 0.0, cos),
        chi: 0.0,
    };
    (constants, start)
}

/// Every hit of random rays of a bare hole without spin, whatever its order, against the closed
/// form, which shares nothing with the reference but the angle and the radius.
#[test]
fn the_reference_agrees_with_the_closed_form_for_random_rays() {
    let mut random = Random::new();
    let hole = HoleAndDisk {
        kerr: Kerr { spin: 0.0 },
        annulus: Some([2.0, 30.0]),
    };
    let (mut orders, mut ways, mut worst) = ([0; 6], [0; 3], 0.0_f64);
    for i in 0..6000 {
        let r = match i % 3 {
            0 => random.log_between(0.05, 1.0),
            1 => random.log_between(1.0001, 3.0),
            _ => random.log_between(3.0, 1e4),
        };
        // Half of the rays are next to the critical curve, but not so near that it magnifies the
        // last bit of a ray above the claim.
        let b = if i % 2 == 0 {
            let off = random.log_between(1e-7, 1.0);
            CRITICAL_IMPACT
                * (1.0
                    + if random.between(0.0, 1.0) < 0.5 {
                        off
                    } else {
                        -off
                    })
        } else {
            random.between(0.0, 40.0)
        };
        let inward = r > 1.0 && random.between(0.0, 1.0) < 0.6;
        let (constants, start) = flat_ray(r, b, inward, random.between(0.0, TAU));
        // Outside the photon sphere no light with so large a b comes to the camera.
        if constants.potential(start.u) <= 0.0 {
            continue;
        }
        let (mut time, mut phis) = (0.0, vec![]);
        hole.follow(&constants, start, |step| {
            if let Some(hit) = step.hit {
                let way = match (inward, step.expansion.at(hit).du < 0.0) {
                    (true, false) => Way::In,
                    (true, true) => Way::InAndOut,
                    (false, _) => Way::Out,
                };
                phis.push((b * (time + hit), way));
            }
            time += step.length;
        });
        let trace = hole.trace_with_lags(&constants, start);
        assert_eq!(phis.len(), trace.hits.iter().flatten().count());
        for ((phi, way), hit) in phis.into_iter().zip(trace.hits.iter().flatten()) {
            let expected = lag(b, phi, 1.0 / r, 1.0 / hit.r, way);
            let found = hit.delay.unwrap();
            let off = (found - expected).abs();
            // Beyond 1000 r_s the last bits of the radius count: a relative 1e-12.
            assert!(
                off < CLAIM.max(1e-12 * r),
                "from {r}, b = {b}, {way:?} to {}, {phi} rad: {found} and not {expected}",
                hit.r
            );
            worst = worst.max(off);
            orders[((phi / PI) as usize).min(5)] += 1;
            ways[way as usize] += 1;
        }
    }
    println!("orders {orders:?}, ways {ways:?}, worst {worst:e}");
    assert!(orders.iter().all(|count| *count > 10) && ways.iter().all(|count| *count > 100));
}

/// A scene with a random spin, camera and motion.
fn random_scene(random: &mut Random, spin: f64) -> Scene {
    let mut scene = pixel_scene(spin, random.between(1.0, 179.0));
    scene.observer.kind = ObserverKind::Zamo;
    scene.observer.velocity = (random.between(0.0, 0.6) * random.direction()).to_array();
    scene.disk.outer = 30.0;
    scene
}

/// dt/dtau = (r^2 + a^2)(E (r^2 + a^2) - a L)/Delta + a L - a^2 E sin^2 theta, as Carter has it.
/// For light that falls in the same with (r^2 + a^2)/Delta dr/dtau added gives Kerr's ingoing time.
fn carters_rate(
    kerr: Kerr,
    constants: &PhotonConstants,
    state: &PhotonState,
    ingoing: bool,
) -> f64 {
    let (a, r) = (kerr.a(), 1.0 / state.u);
    let wide = r * r + a * a;
    let (energy, momentum) = (constants.energy, constants.angular_momentum);
    let radial = if ingoing { state.du * r * r } else { 0.0 };
    wide * (energy * wide - a * momentum + radial) / kerr.delta(r) + a * momentum
        - a * a * energy * (1.0 - state.n.z.powi(2))
}

#[test]
fn delays_of_random_rays_with_spin_are_the_integral_of_carters_equation() {
    let mut random = Random::new();
    let nodes = gauss_legendre(40);
    let (mut hits, mut worst) = (0, 0.0_f64);
    for spin in [0.0, 0.3, 0.9, -0.9, 0.998] {
        for _ in 0..12 {
            let mut scene = random_scene(&mut random, spin);
            scene.camera.r = random.log_between(2.5, 40.0);
            let reference = Reference::new(&scene).unwrap();
            let hole = reference.hole_and_disk();
            let (r, n) = reference.camera();
            for _ in 0..40 {
                // Denser toward the hole.
                let aim = DVec3::NEG_X + random.between(0.0, 1.5) * random.direction();
                let direction = aim.normalize();
                let photon = reference.photon(direction);
                let (constants, start) = PhotonConstants::of_photon(hole.kerr, &photon, r, n);
                let (mut sum, mut expected) = (0.0, vec![]);
                hole.follow(&constants, start, |step| {
                    let over = |end: f64| {
                        let rate = |x: f64| {
                            let state = step.expansion.at(end * x);
                            carters_rate(hole.kerr, &constants, &state, false)
                        };
                        end * nodes
                            .iter()
                            .map(|(x, weight)| weight * rate(*x))
                            .sum::<f64>()
                    };
                    expected.extend(step.hit.map(|hit| sum + over(hit)));
                    sum += over(step.length);
                });
                // The very ray of the quadrature: the reference normalizes its direction once more,
                // and next to the critical curve the last bit counts.
                let trace = hole.trace_with_lags(&constants, start);
                for (hit, expected) in trace.hits.iter().flatten().zip(expected) {
                    let delay = hit.delay.unwrap();
                    worst = worst.max((delay - expected).abs());
                    assert!(
                        (delay - expected).abs() < CLAIM,
                        "spin {spin}, {scene:?}, {direction}: {delay} and not {expected}"
                    );
                    hits += 1;
                }
            }
        }
    }
    println!("{hits} hits, worst {worst:e}");
    assert!(hits > 500, "{hits}");
}

/// Without a form that is finite there. At the horizon Carter's rate is the quotient of two numbers
/// that vanish, and a node at the distance x from it is wrong by about 1e-16/x. A node anywhere in
/// the step can be that near. So the integral is split at the horizon: then a node's weight is at
/// most about three times its distance, and no node contributes more than a few roundings.
#[test]
fn lags_of_random_rays_inside_a_spinning_hole_are_the_integral_of_carters_equation() {
    let mut random = Random::new();
    let nodes = gauss_legendre(40);
    let (mut hits, mut worst) = (0, 0.0_f64);
    for spin in [0.0, 0.5, 0.9, -0.9] {
        let kerr = Kerr { spin };
        for _ in 0..10 {
            let mut scene = random_scene(&mut random, spin);
            scene.observer.kind = ObserverKind::Rain;
            let depth = random.between(0.05, 0.7);
            scene.camera.r = kerr.horizon() - depth * (kerr.horizon() - kerr.inner_horizon());
            let reference = Reference::new(&scene).unwrap();
            let hole = reference.hole_and_disk();
            let (r, n) = reference.camera();
            for _ in 0..60 {
                let direction = random.direction();
                let photon = reference.photon(direction);
                let (constants, start) = PhotonConstants::of_photon(kerr, &photon, r, n);
                let (mut sum, mut expected) = (0.0, vec![]);
                hole.follow(&constants, start, |step| {
                    let part = |from: f64, to: f64| {
                        let rate = |x: f64| {
                            let state = step.expansion.at(from + (to - from) * x);
                            carters_rate(kerr, &constants, &state, true)
                        };
                        (to - from)
                            * nodes
                                .iter()
                                .map(|(x, weight)| weight * rate(*x))
                                .sum::<f64>()
                    };
                    let over = |end: f64| {
                        let mut depth = step.expansion.u;
                        depth.0[0] -= 1.0 / kerr.horizon();
                        if depth.0[0] > 0.0 && depth.at(end).0 < 0.0 {
                            let horizon = depth.root(end);
                            part(0.0, horizon) + part(horizon, end)
                        } else {
                            part(0.0, end)
                        }
                    };
                    let outward = |time: f64| step.expansion.at(time).du < 0.0;
                    expected.extend(step.hit.map(|hit| (outward(hit), sum + over(hit))));
                    sum += over(step.length);
                });
                // The very ray of the quadrature: the reference normalizes its direction once more,
                // and next to the critical curve the last bit counts.
                let trace = hole.trace_with_lags(&constants, start);
                assert!(
                    reference
                        .trace_with_delays(direction)
                        .hits
                        .iter()
                        .flatten()
                        .all(|hit| hit.delay.is_none())
                );
                for (hit, (outward, expected)) in trace.hits.iter().flatten().zip(expected) {
                    // Light that has been farther out than the disk is not ingoing there.
                    if !outward {
                        continue;
                    }
                    let ingoing = hit.delay.unwrap() - kerr.ingoing_time_lead(hit.r);
                    worst = worst.max((ingoing - expected).abs());
                    assert!(
                        (ingoing - expected).abs() < CLAIM,
                        "spin {spin}, {scene:?}, {direction}: {ingoing} and not {expected}"
                    );
                    hits += 1;
                }
            }
        }
    }
    println!("{hits} hits, worst {worst:e}");
    assert!(hits > 100, "{hits}");
}

/// The largest change of the delay `second` of a ray's second hit if the ray is turned by 1e-12 rad.
fn change_by_a_turn(reference: &Reference, direction: DVec3, second: f64) -> f64 {
    let (across, up) = direction.any_orthonormal_pair();
    [across, -across, up, -up]
        .map(|axis| reference.trace_with_delays(direction + 1e-12 * axis))
        .map(|turned| turned.hits[1].map_or(f64::INFINITY, |hit| hit.delay.unwrap() - second))
        .into_iter()
        .fold(0.0, |largest, change| largest.max(change.abs()))
}

/// What a camera at the first hit would measure of the second is missing between the two, wherever
/// the ray turns. The two start their steps at other places, and next to the critical curve the ray
/// magnifies their rounding above the claim. Then the error must be no larger than a tenth of that
/// of a turn of the ray by 1e-12 rad.
#[test]
fn delays_add_up_along_a_random_ray() {
    let mut random = Random::new();
    let mut pairs = 0;
    for spin in [0.0, 0.9, -0.9] {
        for _ in 0..20 {
            let mut scene = random_scene(&mut random, spin);
            scene.camera.r = random.log_between(3.0, 1000.0);
            let reference = Reference::new(&scene).unwrap();
            let hole = reference.hole_and_disk();
            let (r, n) = reference.camera();
            for _ in 0..100 {
                let aim = DVec3::NEG_X + random.between(0.0, 12.0 / r) * random.direction();
                let photon = reference.photon(aim.normalize());
                let (constants, start) = PhotonConstants::of_photon(hole.kerr, &photon, r, n);
                let mut places = vec![];
                hole.follow(&constants, start, |step| {
                    places.extend(step.hit.map(|hit| step.expansion.at(hit)));
                });
                let trace = hole.trace_with_lags(&constants, start);
                let [Some(first), Some(second)] = trace.hits else {
                    continue;
                };
                let from_there = hole.trace_with_lags(&constants, places[0]).hits;
                // The plane is crossed at the start, or not, by the last bit.
                let again = from_there
                    .iter()
                    .flatten()
                    .find(|hit| (hit.r - second.r).abs() < 1e-6);
                let (first, second) = (first.delay.unwrap(), second.delay.unwrap());
                let between = again.unwrap().delay.unwrap();
                let error = (second - first - between).abs();
                let sensitivity = || change_by_a_turn(&reference, aim.normalize(), second);
                assert!(
                    between > 0.0 && (error < CLAIM || error < 0.1 * sensitivity()),
                    "spin {spin}, {scene:?}, {aim}: {first} + {between} and not {second}"
                );
                pairs += 1;
            }
        }
    }
    assert!(pairs > 20, "{pairs}");
}

/// Along the principal null directions K' = 0 and L = a E sin^2 theta, and the time is that of the
/// tortoise coordinate alone. Nothing but rounding remains of the integrand.
#[test]
fn along_the_principal_null_directions_the_time_is_the_tortoise_coordinates() {
    for (spin, sin2, outward) in [
        (0.9, 0.3, 1.0),
        (0.9, 0.3, -1.0),
        (-0.998, 0.7, 1.0),
        (0.0, 0.5, -1.0),
    ] {
        let kerr = Kerr { spin };
        let (a, r): (f64, f64) = (kerr.a(), 1000.0);
        let (sin, z) = (f64::sqrt(sin2), f64::sqrt(1.0 - sin2));
        // Q = -(L - a E)^2, so that K = L^2 - (L - a E)^2, and |n'|^2 = K + a^2 z^2 = a^2 sin^2.
        let momentum = a * sin2;
        let constants = PhotonConstants {
            a,
            energy: 1.0,
            angular_momentum: momentum,
            k: momentum.powi(2) - (momentum - a).powi(2),
            ingoing: false,
        };
        let start = PhotonState {
            u: if outward > 0.0 { 0.25 } else { 1.0 / r },
            du: -outward
                * constants
                    .potential(if outward > 0.0 { 0.25 } else { 1.0 / r })
                    .sqrt(),
            n: DVec3::new(sin, 0.0, z),
            dn: DVec3::new(0.0, -a * sin, 0.0),
            chi: 0.0,
        };
        // A disk that the ray does not meet, so that it is followed down to there.
        let hole = HoleAndDisk {
            kerr,
            annulus: Some([2.0, 10.0]),
        };
        let mut lag = Lag::new(kerr, &constants, &start);
        let mut steps = 0;
        let trace = hole.follow(&constants, start, |step| {
            let middle = 0.5 * step.length;
            let there = 1.0 / step.expansion.at(middle).u;
            let expected =
                outward * (kerr.ingoing_time_lead(there) - kerr.ingoing_time_lead(1.0 / start.u));
            let found = lag.at(step, middle);
            assert!(
                (found - expected).abs() < CLAIM,
                "spin {spin}: {found} and not {expected}"
            );
            lag.add(step);
            steps += 1;
        });
        assert!(
            steps > 0 && trace.outcome != Outcome::Unfinished,
            "{trace:?}"
        );
    }
}

#[test]
fn straight_light_of_random_scenes_takes_as_long_as_its_way() {
    let mut random = Random::new();
    let mut hits = 0;
    for spin in [0.0, 0.9] {
        let mut scene = pixel_scene(spin, 60.0);
        scene.effects.lensing = false;
        let reference = Reference::new(&scene).unwrap();
        let camera = scene.camera.direction() * scene.camera.r;
        for _ in 0..200 {
            let aim = DVec3::NEG_X + random.between(0.0, 0.5) * random.direction();
            let trace = reference.trace_with_delays(aim);
            assert_eq!(trace, reference.trace_with_lags(aim));
            if let Some(hit) = trace.hits[0] {
                let place = hit.r * DVec3::new(hit.phi.cos(), hit.phi.sin(), 0.0);
                let way = place.distance(camera);
                assert!(
                    (hit.delay.unwrap() - way).abs() < 1e-12 * way,
                    "{hit:?} and not {way}"
                );
                hits += 1;
            }
        }
    }
    assert!(hits > 50, "{hits}");
}

/// Effects that are switched off change neither the way of the light nor its time.
#[test]
fn delays_do_not_depend_on_shifts_and_change_nothing_else_of_a_trace() {
    let scene = pixel_scene(0.9, 60.0);
    let mut plain = scene.clone();
    (plain.effects.doppler, plain.effects.gravitational_shift) = (false, false);
    for (pixel, ..) in tabulated::PIXELS {
        let [with, without] = [&scene, &plain].map(|scene| through_pixel(scene, pixel));
        let delays = |trace: &Trace| trace.hits.map(|hit| hit.and_then(|hit| hit.delay));
        assert_eq!(delays(&with), delays(&without));
        let direction = scene.camera.tetrad_from_camera()
            * scene
                .camera
                .looking(DVec2::from_array(pixel), DVec2::new(960.0, 540.0));
        let bare = Reference::new(&scene).unwrap().trace(direction);
        assert_eq!(delays(&bare), [None; 2]);
        let forgetful = Trace {
            hits: with
                .hits
                .map(|hit| hit.map(|hit| Hit { delay: None, ..hit })),
            ..with
        };
        assert_eq!(bare, forgetful);
    }
}
