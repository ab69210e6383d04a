//! The method closed around holes that spin, against the reference.

use crate::gpu;
use glam::DVec3;
use lightfall_core::accuracy::{
    ErrorSummary, Quantiles, Ray, Truth, rays_near_edge, rays_over_sky, tolerance,
};
use lightfall_core::geometry::sphere::wrap_angle;
use lightfall_core::gpu::rays::RayKernel;
use lightfall_core::optics::trace::Trace;
use lightfall_core::scene::{Method, ObserverKind, Scene};

/// Rays over the whole sky, and as many again next to the shadow's edge.
const RAYS: usize = 250;

fn seen_from(spin: f64, r: f64, theta_deg: f64, kind: ObserverKind) -> Scene {
    let mut scene = Scene {
        method: Method::Closed,
        ..Scene::default()
    };
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg) = (r, theta_deg);
    scene.observer.kind = kind;
    // A disk that reaches far inward has hits on rays that linger.
    (scene.disk.inner, scene.disk.outer) = (1.0, 14.0);
    scene
}

/// The reference's answers to the rays, and the method's.
fn answers_to(scene: &Scene, rays: Vec<Ray>) -> (Truth, Vec<Trace>) {
    let truth = Truth::of(scene, rays).unwrap();
    let directions: Vec<_> = truth.rays.iter().map(Ray::given).collect();
    let kernel = RayKernel::new(gpu(), scene).unwrap();
    let given = kernel.trace_camera_rays(gpu(), scene, &directions).unwrap();
    (truth, given)
}

/// Rays spread evenly over the directions within `radius` radians of a middle one.
fn rays_around(middle: DVec3, radius: f64, count: u32) -> Vec<Ray> {
    let (across, along) = middle.any_orthonormal_pair();
    let ray = |i: u32| {
        let (share, turn) = (f64::from(i) / f64::from(count), 2.399_963 * f64::from(i));
        let (sin, cos) = (radius * share.sqrt()).sin_cos();
        Ray::toward(cos * middle + sin * (turn.cos() * across + turn.sin() * along))
    };
    (0..count).map(ray).collect()
}

fn errors_of(scene: &Scene) -> ErrorSummary {
    let mut rays = rays_over_sky(RAYS);
    rays.extend(rays_near_edge(scene, RAYS, [1e-6, 0.3]));
    let (truth, given) = answers_to(scene, rays);
    ErrorSummary::of(&truth, &given)
}

/// Every ray must hold the method's bound, and 99 of 100 the bound `p99`, in radians.
///
/// f32 leaves 6e-8 of a direction. The constants, the roots and the integrals of a ray round some
/// times more, which next to the photon orbits, the axis and the horizon are differences of nearly
/// equal numbers: with Mesa's driver 99 of 100 rays are within 2.1e-7 to 8.7e-7 from outside, and
/// within 5.5e-7 to 1.7e-6 of a falling observer. The bounds are 1.2 to 3 times as large, because
/// other drivers contract products differently.
fn check(scene: &Scene, p99: f64) {
    let place = format!("spin {} r {}", scene.hole.spin, scene.camera.r);
    let errors = errors_of(scene);
    let Quantiles {
        p99: found, max, ..
    } = errors.backward;
    println!("{place}: p99 {found:.1e} max {max:.1e}");
    assert_eq!((errors.unfinished(), errors.not_finite), (0, 0), "{place}");
    assert!(max <= tolerance(scene), "{place}: {max:e}");
    assert!(found <= p99, "{place}: {found:e}");
}

#[test]
#[ignore = "needs a graphics adapter"]
fn rays_from_outside_hold_their_bound() {
    for (spin, r, theta_deg, p99) in [
        (0.9, 20.0, 83.0, 4e-7),
        (-0.7, 30.0, 100.0, 4e-7),
        (0.5, 3.0, 70.0, 7e-7),
        (0.9, 1000.0, 80.0, 4e-7),
        (1e-3, 10.0, 75.0, 4e-7),
        // Next to the axis, where no great circle describes the latitude.
        (0.9, 4.0, 1.0, 8e-7),
        // Next to the photon orbits.
        (0.9, 1.6, 20.0, 1.2e-6),
        // Where rays turn next to the horizon.
        (0.99, 6.0, 60.0, 8e-7),
        (0.998, 6.0, 60.0, 1e-6),
        (0.9999, 5.0, 90.0, 1e-6),
        // Over the pole, and around slow holes.
        (0.7, 2.0, 0.0, 8e-7),
        (0.1, 1.3, 20.0, 6e-7),
        (1e-9, 50.0, 90.0, 4e-7),
    ] {
        check(&seen_from(spin, r, theta_deg, ObserverKind::Zamo), p99);
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn rays_of_a_falling_observer_hold_their_bound_on_both_sides_of_the_horizon() {
    for (spin, r, theta_deg) in [
        (0.9, 1.2, 70.0),
        (0.9, 0.719, 30.0),
        (0.9, 0.6, 80.0),
        (0.5, 0.4, 90.0),
        (0.998, 0.8, 60.0),
        (0.998, 0.51, 60.0),
    ] {
        check(&seen_from(spin, r, theta_deg, ObserverKind::Rain), 2e-6);
    }
}

/// A leg that ends next to the horizon has the horizon's pole close behind its end.
#[test]
#[ignore = "needs a graphics adapter"]
fn hits_next_to_a_nearly_extremal_horizon_are_where_the_reference_has_them() {
    for spin in [0.998, 0.9999, 0.999_999] {
        let mut scene = seen_from(spin, 20.0, 75.0, ObserverKind::Static);
        (scene.disk.inner, scene.disk.outer) = (0.3, 0.75);
        // The ring's image is a few degrees wide.
        let rays = rays_around(DVec3::Z, 0.08, 4000);
        let (truth, given) = answers_to(&scene, rays);
        let mut off: Vec<f64> = truth
            .traces
            .iter()
            .zip(&given)
            .filter_map(|(truth, given)| Some(wrap_angle(truth.hits[0]?.phi - given.hits[0]?.phi)))
            .map(f64::abs)
            .collect();
        off.sort_by(f64::total_cmp);
        let [most, worst] = [0.9, 0.99].map(|share| off[(share * off.len() as f64) as usize]);
        println!("spin {spin}: {} hits, {most:.1e}, {worst:.1e}", off.len());
        assert!(
            off.len() > 200 && most < 1e-4 && worst < 1e-3,
            "{spin}: {most:e}, {worst:e}"
        );
    }
}

/// Rays without a critical point that leave a nearly extremal hole's throat hundreds of times slower
/// than they arrive.
#[test]
#[ignore = "needs a graphics adapter"]
fn rays_that_leave_slowly_keep_their_digits() {
    let mut scene = seen_from(0.999_993_736_5, 0.514_950_9, 131.909_33, ObserverKind::Zamo);
    scene.disk.enabled = false;
    let from_tetrad = scene.camera.tetrad_from_camera().transpose();
    let rays = [
        DVec3::new(0.19, 0.338_913, -0.921_433),
        DVec3::new(0.254, -0.329_695, -0.909_277),
        DVec3::new(0.2231, -0.336_713, -0.914_795),
    ];
    let rays = rays.map(|direction| Ray::toward(from_tetrad * direction));
    let (truth, given) = answers_to(&scene, rays.to_vec());
    for (error, trace) in truth.judge(&given).iter().zip(&truth.traces) {
        let sky = error.sky.expect("the ray comes from the sky");
        println!("{sky:.1e} rad, {:.1e} of turn", error.backward);
        // The rounding of the spin to f32 alone moves these places by up to 1e-3 rad. About u = 0
        // they were off by 4e-3 to 8e-2.
        assert!(sky < 1e-3, "{sky:e} at {:?}", trace.sky);
    }
}

/// In a throat the critical points of U nearly meet. Their place decides how long a ray takes along its
/// way, and 36 rad of dragging multiply an error of this time.
#[test]
#[ignore = "needs a graphics adapter"]
fn rays_of_a_throat_keep_their_digits_where_critical_points_nearly_meet() {
    let mut scene = seen_from(-0.999_984_56, 0.5573, 128.03, ObserverKind::Zamo);
    scene.disk.enabled = false;
    let middle = scene.camera.tetrad_from_camera().transpose() * DVec3::new(0.458, 0.1973, 0.8668);
    let rays = rays_around(middle.normalize(), 0.1, 400);
    let (truth, given) = answers_to(&scene, rays);
    let sky = ErrorSummary::of(&truth, &given).sky;
    println!("p99 {:.1e} max {:.1e}", sky.p99, sky.max);
    // Some ten roundings of f32 in 36 rad, at an amplification of up to 11. With the place of the critical
    // points from a difference of large numbers, rays were off by up to 9e-4 rad.
    assert!(sky.max < 1e-4, "{:e}", sky.max);
    assert!(truth.traces.iter().all(|trace| trace.sky.is_some()));
}
