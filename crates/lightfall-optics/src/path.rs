//! The path of one ray, to be drawn and read: points along it, and the angle it sweeps.
//!
//! The angle swept about the hole is the integral of dpsi = |n'| dtau with |n'|^2 = K + a^2 E^2
//! n_z^2, without the azimuth due to frame dragging.

use crate::reference::{HoleAndDisk, Reference, Step};
use crate::trace::{Outcome, Trace};
use glam::{DMat3, DVec3};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonState};
use lightfall_model::geometry::observer::Photon;
use lightfall_model::geometry::quadrature::integral;
use std::f64::consts::PI;

const POINTS_PER_STEP: usize = 24;
/// The path of a captured ray ends at this distance from the horizon, as a share of the horizon's
/// radius, because azimuths diverge at the horizon.
const HORIZON_MARGIN: f64 = 0.02;
/// Maximum number of points of a path. The path of a ray that winds forever is cut off.
const MAX_POINTS: usize = 4000;
/// An angle that exceeds a whole number of half-turns by less than this, in radians, counts as that
/// number exactly: a camera in the disk's plane sees the disk after whole half-turns, and rounding
/// must not raise the order.
const HALF_TURN_TOLERANCE: f64 = 1e-5;

/// The path of a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Points along the backward ray, from the camera on, in r_s: r times the unit vector toward
    /// Boyer-Lindquist theta, phi of the disk's frame. For a camera at or inside the horizon phi is
    /// Kerr's ingoing azimuth.
    pub points: Vec<DVec3>,
    /// Smallest r of the ray, in r_s; the horizon's radius for a captured ray.
    pub closest_r: f64,
    /// Angle swept about the hole up to the first hit, or else along the whole ray, in radians.
    pub swept_angle: f64,
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
    /// axes, with its delays, and follows its path out to the radius `max_r` (r_s).
    pub fn of(reference: &Reference, direction: DVec3, max_r: f64) -> (Trace, Self) {
        let trace = reference.trace_with_delays(direction);
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
    let (constants, start) = PhotonConstants::of_photon(kerr, photon, r, n);
    let mut path = Path {
        points: Vec::new(),
        closest_r: r,
        swept_angle: 0.0,
        constants: Some(invariants(&constants)),
    };
    let (mut angle, mut angle_to_hit) = (0.0, None);
    hole_and_disk.follow(&constants, start, |step| {
        path.closest_r = path.closest_r.min(min_radius(step));
        let angle_within =
            |end| integral(0.0, end, &|t| angle_rate(&constants, &step.expansion.at(t)));
        if let (None, Some(time)) = (angle_to_hit, step.hit) {
            angle_to_hit = Some(angle + angle_within(time));
        }
        angle += angle_within(step.length);
    });
    path.swept_angle = angle_to_hit.unwrap_or(angle);
    if trace.outcome == Outcome::Captured {
        path.closest_r = kerr.horizon().min(r);
    }
    path.points = points(hole_and_disk, &constants, start, max_r);
    path
}

/// Points along a ray to its end, which the trace need not reach.
fn points(
    hole_and_disk: HoleAndDisk,
    constants: &PhotonConstants,
    start: PhotonState,
    max_r: f64,
) -> Vec<DVec3> {
    let u_end = (1.0 - HORIZON_MARGIN) / hole_and_disk.kerr.horizon();
    // A path that begins inside the horizon, or next to it, ends there only after it has been
    // outside. Light through the horizon's other branch has not been outside, and its path ends at
    // that branch.
    let mut outside = start.u < u_end;
    let u_horizon = 1.0 / hole_and_disk.kerr.horizon();
    let stays_inside = constants.stays_inside(&start, u_horizon);
    let min_u = 1.0 / max_r;
    let point = |state: &PhotonState| DMat3::from_rotation_z(state.chi) * state.n / state.u;
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
    let along = start.dot(direction);
    // The ray ends at the horizon, or at the requested radius.
    let (closest_r, radius) = match captured {
        true => (kerr.horizon(), kerr.horizon()),
        false if along < 0.0 => (nearest, max_r.max(r)),
        false => (r, max_r.max(r)),
    };
    let half_chord = (radius * radius - nearest * nearest).max(0.0).sqrt();
    let length = half_chord.copysign(if captured { -1.0 } else { 1.0 }) - along;
    let hit =
        trace.hits[0].map(|hit| DVec3::new(hit.r * hit.phi.cos(), hit.r * hit.phi.sin(), 0.0));
    let swept_angle = hit.map_or(n.angle_between(direction), |hit| n.angle_between(hit));
    let points = (0..=POINTS_PER_STEP)
        .map(|i| start + direction * (length * i as f64 / POINTS_PER_STEP as f64))
        .collect();
    Path {
        points,
        closest_r,
        swept_angle,
        constants: None,
    }
}

fn invariants(constants: &PhotonConstants) -> Invariants {
    let energy = constants.energy;
    Invariants {
        impact_parameter: constants.k.max(0.0).sqrt() / energy,
        lambda: constants.angular_momentum / energy,
        eta: constants.carter_q() / energy.powi(2),
    }
}

/// |n'|, the angle swept per Mino time.
fn angle_rate(constants: &PhotonConstants, state: &PhotonState) -> f64 {
    (constants.k + (constants.a * constants.energy * state.n.z).powi(2))
        .max(0.0)
        .sqrt()
}

/// The smallest r of a step.
fn min_radius(
    Step {
        expansion, length, ..
    }: &Step,
) -> f64 {
    let (first, last) = (expansion.at(0.0), expansion.at(*length));
    let mut u = first.u.max(last.u);
    if first.du > 0.0 && last.du < 0.0 {
        let turn = expansion.u.derivative().root(*length);
        u = u.max(expansion.at(turn).u);
    }
    1.0 / u
}
