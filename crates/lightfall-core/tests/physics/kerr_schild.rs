//! A code of another kind, for comparison only: Hamilton's equations in ingoing Kerr-Schild
//! Cartesian coordinates, with derivatives by dual numbers and Dormand & Prince's adaptive
//! fifth-order method. It shares no coordinate, no constant of motion, no tetrad and no integrator
//! with the reference.

use crate::reference::directions;
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::observer::min_infall_radius;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::{ObserverKind, Scene};
use std::ops::{Add, Div, Mul, Sub};

/// A number with its gradient over (x, y, z).
#[derive(Clone, Copy)]
struct Dual(f64, DVec3);

impl Dual {
    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        Self(root, self.1 / (2.0 * root))
    }
}
impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}
impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }
}
impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0, self.1 * other.0 + other.1 * self.0)
    }
}
impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let ratio = self.0 / other.0;
        Self(ratio, (self.1 - other.1 * ratio) / other.0)
    }
}
impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self(self.0 * factor, self.1 * factor)
    }
}

/// g = eta + 2H l l with l = (1, (r x + a y)/(r^2 + a^2), (r y - a x)/(r^2 + a^2), z/r), 2H =
/// r^3/(r^4 + a^2 z^2): Kerr 1963, with r_s = 1. Everything as dual numbers.
struct Metric {
    r: Dual,
    cos: Dual,
    two_h: Dual,
    l: [Dual; 3],
}

impl Metric {
    fn at(a: f64, place: DVec3) -> Self {
        let number = |value: f64| Dual(value, DVec3::ZERO);
        let [x, y, z] = [
            (place.x, DVec3::X),
            (place.y, DVec3::Y),
            (place.z, DVec3::Z),
        ]
        .map(|(v, e)| Dual(v, e));
        let a2 = number(a * a);
        let excess = x * x + y * y + z * z - a2;
        let r2 = (excess + (excess * excess + a2 * z * z * 4.0).sqrt()) * 0.5;
        let r = r2.sqrt();
        let two_h = r * r2 / (r2 * r2 + a2 * z * z);
        let wide = r2 + a2;
        let l = [(r * x + y * a) / wide, (r * y - x * a) / wide, z / r];
        Self {
            r,
            cos: z / r,
            two_h,
            l,
        }
    }

    fn l(&self) -> DVec3 {
        DVec3::new(self.l[0].0, self.l[1].0, self.l[2].0)
    }

    /// g^(mu nu) p_mu q_nu, with (time, space) covectors.
    fn inverse(&self, p: (f64, DVec3), q: (f64, DVec3)) -> f64 {
        let along = |p: (f64, DVec3)| self.l().dot(p.1) - p.0;
        p.1.dot(q.1) - p.0 * q.0 - self.two_h.0 * along(p) * along(q)
    }

    /// The covector of a vector.
    fn lower(&self, v: (f64, DVec3)) -> (f64, DVec3) {
        let along = self.two_h.0 * (v.0 + self.l().dot(v.1));
        (along - v.0, v.1 + along * self.l())
    }
}

fn scale(p: (f64, DVec3), factor: f64) -> (f64, DVec3) {
    (p.0 * factor, p.1 * factor)
}

/// The covectors of e_t, e_r, e_theta, e_phi: u along d/dt or along d/dt + omega d/dphi; e_r and
/// e_theta along dr and dtheta, since Boyer-Lindquist's r and theta are orthogonal; e_phi what is
/// left, by the Gram-Schmidt process.
///
/// For `rain` u has E = 1, no angular momentum and no component along dtheta. So it is -dt plus a
/// multiple of dr, chosen so that its square is -1 and it points inward; e_r is the remainder of
/// dr.
fn tetrad(metric: &Metric, place: DVec3, kind: ObserverKind) -> [(f64, DVec3); 4] {
    let normal = |p: (f64, DVec3)| scale(p, 1.0 / metric.inverse(p, p).abs().sqrt());
    let rotation = (0.0, DVec3::new(-place.y, place.x, 0.0));
    let (time, turn) = (metric.lower((1.0, DVec3::ZERO)), metric.lower(rotation));
    let u = match kind {
        ObserverKind::Static => time,
        ObserverKind::Zamo => {
            let omega = -metric.inverse(time, turn) / metric.inverse(turn, turn);
            (time.0 + omega * turn.0, time.1 + omega * turn.1)
        }
        ObserverKind::Rain => {
            let (clock, dr) = ((-1.0, DVec3::ZERO), (0.0, metric.r.1));
            let [rest, mixed, radial] =
                [(clock, clock), (clock, dr), (dr, dr)].map(|(p, q)| metric.inverse(p, q));
            // rest + 2 mixed s + radial s^2 = -1; u^r = mixed + radial s is negative, which
            // radial's own zero does not disturb.
            let share = (rest + 1.0) / ((mixed * mixed - radial * (rest + 1.0)).sqrt() - mixed);
            (clock.0, share * dr.1)
        }
        ObserverKind::Orbit => panic!("not needed here"),
    };
    let without = |p: (f64, DVec3), axes: &[((f64, DVec3), f64)]| {
        let less = |p: (f64, DVec3), (axis, share): ((f64, DVec3), f64)| {
            (p.0 - share * axis.0, p.1 - share * axis.1)
        };
        axes.iter().fold(p, |rest, &(axis, sign)| {
            less(rest, (axis, sign * metric.inverse(p, axis)))
        })
    };
    let (u, e_theta) = (normal(u), normal((0.0, -metric.cos.1)));
    if kind == ObserverKind::Rain {
        let e_phi = normal(turn);
        let e_r = normal(without(
            (0.0, metric.r.1),
            &[(u, -1.0), (e_theta, 1.0), (e_phi, 1.0)],
        ));
        return [u, e_r, e_theta, e_phi];
    }
    let e_r = normal((0.0, metric.r.1));
    [
        u,
        e_r,
        e_theta,
        normal(without(
            (0.0, rotation.1),
            &[(u, -1.0), (e_r, 1.0), (e_theta, 1.0)],
        )),
    ]
}

/// The axes of an observer that moves with the velocity v: u' = gamma (u + v^i e_i), e_j' = e_j +
/// (gamma v_j) u + (gamma^2/(gamma + 1)) v_j v^i e_i.
fn boosted([u, axes @ ..]: [(f64, DVec3); 4], velocity: [f64; 3]) -> [(f64, DVec3); 4] {
    let gamma = 1.0 / (1.0 - DVec3::from_array(velocity).length_squared()).sqrt();
    let sum =
        |p: (f64, DVec3), factor: f64, q: (f64, DVec3)| (p.0 + factor * q.0, p.1 + factor * q.1);
    let along = velocity
        .into_iter()
        .zip(axes)
        .fold((0.0, DVec3::ZERO), |along, (v, axis)| sum(along, v, axis));
    let axis = |j: usize| {
        let v = velocity[j];
        sum(
            sum(axes[j], gamma * v, u),
            gamma * gamma / (gamma + 1.0) * v,
            along,
        )
    };
    [scale(sum(u, 1.0, along), gamma), axis(0), axis(1), axis(2)]
}

/// dx and dp along the backward ray, H = g^(mu nu) p_mu p_nu / 2.
fn slope(a: f64, p_t: f64, [x, p]: [DVec3; 2]) -> [DVec3; 2] {
    let metric = Metric::at(a, x);
    let along = metric.l().dot(p) - p_t;
    let gradient_along = metric.l[0].1 * p.x + metric.l[1].1 * p.y + metric.l[2].1 * p.z;
    let force = 0.5 * along * along * metric.two_h.1 + metric.two_h.0 * along * gradient_along;
    [-(p - metric.two_h.0 * along * metric.l()), -force]
}

/// Dormand & Prince 1980, table 2.
const NODES: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [
        19372.0 / 6561.0,
        -25360.0 / 2187.0,
        64448.0 / 6561.0,
        -212.0 / 729.0,
        0.0,
        0.0,
    ],
    [
        9017.0 / 3168.0,
        -355.0 / 33.0,
        46732.0 / 5247.0,
        49.0 / 176.0,
        -5103.0 / 18656.0,
        0.0,
    ],
    [
        35.0 / 384.0,
        0.0,
        500.0 / 1113.0,
        125.0 / 192.0,
        -2187.0 / 6784.0,
        11.0 / 84.0,
    ],
];
const ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339_200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// The direction in which the backward ray leaves. `None` if it comes near the horizon from
/// outside, or accumulates there from inside, which light that was never outside does in these
/// coordinates. At r = 1e8 the remaining deflection is of the order b/r^2.
fn sky(scene: &Scene, direction: DVec3, tolerance: f64) -> Option<DVec3> {
    let kerr = Kerr {
        spin: scene.hole.spin,
    };
    let (a, r, theta) = (
        kerr.a(),
        scene.camera.r,
        scene.camera.theta_deg.to_radians(),
    );
    let mut inside = r <= kerr.horizon();
    let lead = if inside {
        0.0
    } else {
        kerr.ingoing_azimuth_lead(r)
    };
    let azimuth = scene.camera.phi_deg.to_radians() + lead;
    let (sin, cos) = azimuth.sin_cos();
    let mut x = DVec3::new(
        theta.sin() * (r * cos - a * sin),
        theta.sin() * (r * sin + a * cos),
        r * theta.cos(),
    );
    let axes = boosted(
        tetrad(&Metric::at(a, x), x, scene.observer.kind),
        scene.observer.velocity,
    );
    let d = direction.normalize();
    let (p_t, mut p) = [(1, d.x), (2, d.y), (3, d.z)]
        .into_iter()
        .fold(axes[0], |p, (axis, d)| {
            (p.0 - d * axes[axis].0, p.1 - d * axes[axis].1)
        });
    let mut step = 0.01 * r;
    for _ in 0..2_000_000 {
        let here = Metric::at(a, x).r.0;
        if here > 1e8 {
            return Some(slope(a, p_t, [x, p])[0].normalize());
        }
        inside &= here < 1.03 * kerr.horizon();
        if !inside && here < 1.02 * kerr.horizon() || p.length() > 1e9 {
            return None;
        }
        let mut slopes = vec![slope(a, p_t, [x, p])];
        let mut end = [x, p];
        for weights in NODES {
            end = [x, p];
            for (weight, [dx, dp]) in weights.iter().zip(&slopes) {
                end[0] += step * *weight * *dx;
                end[1] += step * *weight * *dp;
            }
            slopes.push(slope(a, p_t, end));
        }
        let mut error = [DVec3::ZERO; 2];
        for (weight, [dx, dp]) in ERROR.iter().zip(&slopes) {
            error[0] += step * *weight * *dx;
            error[1] += step * *weight * *dp;
        }
        let size = (error[0].length() / here).max(error[1].length() / p.length()) / tolerance;
        if size <= 1.0 {
            [x, p] = end;
        }
        step *= (0.9 * size.max(1e-10).powf(-0.2)).clamp(0.2, 4.0);
    }
    None
}

/// Both codes must find the same sky. The other code's own error is measured by tightening its
/// tolerance from 1e-9 to 1e-13, which must reduce it by a factor of a hundred or more.
fn assert_same_sky(scenes: impl IntoIterator<Item = Scene>, least: u32) {
    let (mut coarse, mut fine, mut compared) = (0.0_f64, 0.0_f64, 0);
    for scene in scenes {
        let shown = format!(
            "spin {}, {:?}, {:?}",
            scene.hole.spin, scene.camera, scene.observer
        );
        let reference = Reference::new(&scene).unwrap();
        for direction in directions(24) {
            let trace = reference.trace(direction);
            let Some(tight) = sky(&scene, direction, 1e-13) else {
                assert_eq!(trace.outcome, Outcome::Captured, "{shown}, {direction}");
                continue;
            };
            let expected = trace
                .sky
                .unwrap_or_else(|| panic!("{shown}, {direction}: not captured elsewhere"));
            let loose = sky(&scene, direction, 1e-9).unwrap();
            (coarse, fine) = (
                coarse.max((loose - expected).length()),
                fine.max((tight - expected).length()),
            );
            compared += 1;
        }
    }
    println!("{compared} rays; largest difference {coarse:e} at tolerance 1e-9, {fine:e} at 1e-13");
    assert!(compared > least, "only {compared} rays reach the sky");
    assert!(fine < 1e-9, "difference {fine:e}");
    assert!(
        fine < 0.01 * coarse,
        "the difference does not shrink with the tolerance: {coarse:e} to {fine:e}"
    );
}

fn scene(spin: f64, [r, theta_deg]: [f64; 2], kind: ObserverKind, velocity: [f64; 3]) -> Scene {
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg, scene.camera.phi_deg) = (r, theta_deg, 25.0);
    (scene.observer.kind, scene.observer.velocity) = (kind, velocity);
    scene
}

#[test]
fn an_independent_code_in_kerr_schild_coordinates_sees_the_same_sky() {
    let places = [
        (0.0, [10.0, 80.0], ObserverKind::Static),
        (0.5, [3.0, 40.0], ObserverKind::Static),
        (0.9, [20.0, 85.0], ObserverKind::Static),
        (0.9, [1.3, 90.0], ObserverKind::Zamo),
        (0.998, [0.8, 90.0], ObserverKind::Zamo),
        (0.998, [20.0, 60.0], ObserverKind::Zamo),
        (-0.9, [5.0, 100.0], ObserverKind::Static),
        (0.9999, [20.0, 89.0], ObserverKind::Static),
        (-0.998, [2.0, 10.0], ObserverKind::Zamo),
    ];
    assert_same_sky(
        places.map(|(spin, place, kind)| scene(spin, place, kind, [0.0; 3])),
        120,
    );
}

#[test]
fn an_independent_code_sees_the_same_sky_from_inside_the_horizon() {
    let mut scenes = Vec::new();
    for (spin, theta_deg) in [
        (0.0, 60.0),
        (0.3, 90.0),
        (0.9, 80.0),
        (-0.9, 30.0),
        (0.998, 100.0),
        (0.9999, 90.0),
    ] {
        let kerr = Kerr { spin };
        for (depth, velocity) in [
            (1.0, [0.0; 3]),
            (0.5, [-0.2, 0.3, 0.5]),
            (0.0, [0.0, 0.0, -0.6]),
        ] {
            // From the horizon to the smallest radius of motion.
            let r = min_infall_radius(kerr) + depth * (kerr.horizon() - min_infall_radius(kerr));
            scenes.push(scene(spin, [r, theta_deg], ObserverKind::Rain, velocity));
        }
    }
    assert_same_sky(scenes, 150);
}
