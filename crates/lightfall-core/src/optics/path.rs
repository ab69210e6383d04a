//! The path of one ray, to be drawn and read: points along it, the angle it sweeps, and the time
//! the light takes.
//!
//! The path takes the same steps as the reference and uses the same series. Two quantities along it
//! are integrals over Mino time:
//!
//! * the angle swept about the hole, from dpsi = |n'| dtau with |n'|^2 = K + a^2 E^2 n_z^2 (without
//!   the azimuth due to frame dragging);
//! * the Boyer-Lindquist time that light takes, from
//!   dt = ((r^2 + a^2) (E (r^2 + a^2) - a L) / Delta + a L - a^2 E sin^2 theta) dtau (Carter 1968;
//!   Misner, Thorne & Wheeler 1973 eq. 33.32d).

use crate::geometry::kerr::Kerr;
use crate::geometry::mino::{Constants, Expansion, State};
use crate::geometry::observer::Photon;
use crate::geometry::quadrature::integral;
use crate::optics::reference::{HoleAndDisk, Reference};
use crate::optics::trace::{Outcome, Trace};
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

/// Number of points drawn per step.
const POINTS_PER_STEP: usize = 24;
/// The path of a captured ray ends at this distance from the horizon, as a share of the horizon's
/// radius, because azimuths diverge at the horizon.
const HORIZON_MARGIN: f64 = 0.02;
/// Maximum number of points of a path. The path of a ray that winds about the hole for ever is cut
/// off.
const MAX_POINTS: usize = 4000;
/// An angle that exceeds a whole number of half-turns by less than this, in radians, counts as that
/// number exactly: a camera in the disk's plane sees the disk after whole half-turns, and rounding
/// must not raise the order.
const HALF_TURN_TOLERANCE: f64 = 1e-5;

/// The path of a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Points along the backward ray, from the camera on, in r_s: r times the unit vector toward
    /// Boyer-Lindquist theta, phi. For a camera at or inside the horizon phi is Kerr's ingoing
    /// azimuth.
    pub points: Vec<DVec3>,
    /// Smallest r of the ray, in r_s; the horizon's radius for a captured ray.
    pub closest_r: f64,
    /// Angle swept about the hole up to the first hit, or else along the whole ray, in radians.
    pub swept_angle: f64,
    /// Boyer-Lindquist time from the emission at each of the disk's hits to the camera, in r_s / c.
    pub delays: [Option<f64>; 2],
    /// Constants of the motion; `None` for a straight ray, which has none.
    pub constants: Option<Invariants>,
}

/// A photon's constants of the motion, per unit energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Invariants {
    /// b = sqrt(eta + lambda^2), in r_s. Without spin it is the impact parameter at infinity.
    pub impact_parameter: f64,
    /// lambda = L/E, in r_s.
    pub lambda: f64,
    /// eta = Q/E^2, in r_s^2.
    pub eta: f64,
}

impl Path {
    /// Traces the ray that arrives from the unit direction `direction`, given on the observer's
    /// axes, and follows its path out to the radius `max_r` (r_s).
    #[must_use]
    pub fn of(reference: &Reference, direction: DVec3, max_r: f64) -> (Trace, Self) {
        let trace = reference.trace(direction);
        let photon = reference.photon(direction.normalize());
        let (r, n) = reference.camera();
        let hole_and_disk = reference.hole_and_disk();
        let path = if reference.lensing() {
            lensed_path(hole_and_disk, &photon, r, n, &trace, max_r)
        } else {
            straight_path(hole_and_disk.kerr, &photon, r, n, &trace, max_r)
        };
        (trace, path)
    }

    /// Order of the image: the number of whole half-turns about the hole in the swept angle. `None`
    /// where nothing is seen.
    #[must_use]
    pub fn order(&self, trace: &Trace) -> Option<u32> {
        let seen = trace.outcome == Outcome::Sky || trace.hits[0].is_some();
        seen.then(|| ((self.swept_angle - HALF_TURN_TOLERANCE) / PI).max(0.0) as u32)
    }
}

fn lensed_path(
    hole_and_disk: HoleAndDisk,
    photon: &Photon,
    r: f64,
    n: DVec3,
    trace: &Trace,
    max_r: f64,
) -> Path {
    let HoleAndDisk { kerr, .. } = hole_and_disk;
    let (constants, start) = Constants::of_photon(kerr, photon, r, n);
    let mut path = Path {
        points: Vec::new(),
        closest_r: r,
        swept_angle: 0.0,
        delays: [None; 2],
        constants: Some(invariants(&constants)),
    };
    let (mut angle, mut delay, mut found) = (0.0, 0.0, 0);
    let angle_within = |expansion: &Expansion, end: f64| {
        integral(0.0, end, &|t| constants.angle_rate(&expansion.at(t)))
    };
    let time_within = |expansion: &Expansion, end: f64| {
        integral(0.0, end, &|t| constants.time_rate(kerr, &expansion.at(t)))
    };
    hole_and_disk.follow(&constants, start, |_, expansion, end| {
        path.closest_r = path.closest_r.min(min_radius(expansion, end));
        // The next hit lies in the step that crosses the disk's plane at the hit's radius.
        let hit = trace.hits.get(found).copied().flatten();
        let hit_time = hit.and_then(|hit| time_of_hit(expansion, end, 1.0 / hit.r));
        if let Some(time) = hit_time {
            if found == 0 {
                path.swept_angle = angle + angle_within(expansion, time);
            }
            path.delays[found] = (!constants.ingoing).then(|| delay + time_within(expansion, time));
            found += 1;
        }
        angle += angle_within(expansion, end);
        // Only while another hit is to come: over the whole ray the time diverges.
        if trace.hits.get(found).is_some_and(Option::is_some) {
            delay += time_within(expansion, end);
        }
    });
    if trace.hits[0].is_none() {
        path.swept_angle = angle;
    }
    if trace.outcome == Outcome::Captured {
        path.closest_r = kerr.horizon().min(r);
    }
    path.points = points(hole_and_disk, &constants, start, max_r);
    path
}

/// Points along a ray to its end. The trace may end earlier, as soon as its outcome is certain.
fn points(
    hole_and_disk: HoleAndDisk,
    constants: &Constants,
    start: State,
    max_r: f64,
) -> Vec<DVec3> {
    let u_end = (1.0 - HORIZON_MARGIN) / hole_and_disk.kerr.horizon();
    // A path that begins inside the horizon, or next to it, ends there only after it has been
    // outside. Light that comes from the horizon's other branch was never outside, and its path
    // ends at that branch.
    let mut outside = start.u < u_end;
    let u_horizon = 1.0 / hole_and_disk.kerr.horizon();
    let stays_inside = constants.stays_inside(&start, u_horizon);
    let min_u = 1.0 / max_r;
    let point = |state: &State| DMat3::from_rotation_z(state.chi) * state.n / state.u;
    let mut points = vec![point(&start)];
    let mut state = start;
    while points.len() < MAX_POINTS {
        let expansion = constants.expand(&state);
        let reach = constants.reach(&expansion);
        for i in 1..=POINTS_PER_STEP {
            let next = expansion.at(reach * i as f64 / POINTS_PER_STEP as f64);
            let ended = !next.u.is_finite()
                || !next.n.is_finite()
                || (outside && next.u >= u_end && next.du > 0.0);
            outside |= next.u < u_end;
            if ended || next.u <= min_u && next.du < 0.0 || stays_inside && next.u <= u_horizon {
                return points;
            }
            points.push(point(&next));
        }
        let next = expansion.at(reach);
        if reach <= 0.0 || (!outside && next.du > 0.0) {
            return points;
        }
        state = next;
    }
    points
}

fn straight_path(kerr: Kerr, photon: &Photon, r: f64, n: DVec3, trace: &Trace, max_r: f64) -> Path {
    let start = r * n;
    let direction = (-photon.radial * n - photon.w).normalize();
    let nearest = (start - start.dot(direction) * direction).length();
    let captured = trace.outcome == Outcome::Captured;
    let closest_r = match captured {
        true => kerr.horizon(),
        false if start.dot(direction) < 0.0 => nearest,
        false => r,
    };
    // The ray ends at the horizon, or at the requested radius.
    let radius = if captured {
        kerr.horizon()
    } else {
        max_r.max(r)
    };
    let half_chord = (radius * radius - nearest * nearest).max(0.0).sqrt();
    let length = if captured {
        -start.dot(direction) - half_chord
    } else {
        -start.dot(direction) + half_chord
    };
    let hit =
        trace.hits[0].map(|hit| DVec3::new(hit.r * hit.phi.cos(), hit.r * hit.phi.sin(), 0.0));
    let swept_angle = hit.map_or(n.angle_between(direction), |hit| n.angle_between(hit));
    let delays = [hit.map(|hit| hit.distance(start)), None];
    let points = (0..=POINTS_PER_STEP)
        .map(|i| start + direction * (length * i as f64 / POINTS_PER_STEP as f64))
        .collect();
    Path {
        points,
        closest_r,
        swept_angle,
        delays,
        constants: None,
    }
}

fn invariants(constants: &Constants) -> Invariants {
    let energy = constants.energy;
    Invariants {
        impact_parameter: constants.k.max(0.0).sqrt() / energy,
        lambda: constants.angular_momentum / energy,
        eta: constants.carter_q() / energy.powi(2),
    }
}

impl Constants {
    /// |n'|, the angle swept per Mino time.
    fn angle_rate(&self, state: &State) -> f64 {
        (self.k + (self.a * self.energy * state.n.z).powi(2))
            .max(0.0)
            .sqrt()
    }

    /// dt / dtau, in r_s^2, outside the horizon.
    fn time_rate(&self, kerr: Kerr, state: &State) -> f64 {
        let (a, r) = (self.a, 1.0 / state.u);
        let r2_plus_a2 = r * r + a * a;
        let sin2 = 1.0 - state.n.z * state.n.z;
        r2_plus_a2 * (self.energy * r2_plus_a2 - a * self.angular_momentum) / kerr.delta(r)
            + a * self.angular_momentum
            - a * a * self.energy * sin2
    }
}

/// The smallest r of a step.
fn min_radius(expansion: &Expansion, end: f64) -> f64 {
    let (first, last) = (expansion.at(0.0), expansion.at(end));
    let mut u = first.u.max(last.u);
    if first.du > 0.0 && last.du < 0.0 {
        let (mut low, mut high) = (0.0, end);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if expansion.at(middle).du > 0.0 {
                low = middle
            } else {
                high = middle
            }
        }
        u = u.max(expansion.at(low).u);
    }
    1.0 / u
}

/// The Mino time within a step at which the ray crosses the disk's plane, if it does so at this u.
fn time_of_hit(expansion: &Expansion, end: f64, u: f64) -> Option<f64> {
    let (before, after) = (expansion.at(0.0).n.z, expansion.at(end).n.z);
    let crosses = before > 0.0 && after <= 0.0 || before < 0.0 && after >= 0.0;
    let time = crosses.then(|| expansion.n[2].root(end))?;
    ((expansion.at(time).u - u).abs() <= 1e-9 * u).then_some(time)
}
