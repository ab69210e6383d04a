//! The path ahead of a ship that coasts.

use super::apsides::Apsides;
use glam::{DMat3, DVec3};
use lightfall_model::geometry::kerr::MASS;
use lightfall_model::geometry::ship::Ship;
use lightfall_model::geometry::timelike::{Geodesic, ParticleState};

/// The angle of the motion between two points.
const STEP: f64 = 0.05;
/// How much of the radius the ship comes nearer or farther between two points, at most.
const RADIAL_STEP: f64 = 0.1;
/// A turning point nearer than this share of a step is where the ship is.
const AT_START: f64 = 1e-6;
/// A path that leads away ends at so many times the present radius.
const FARTHEST: f64 = 3.0;
/// The smallest radius, in r_s, from which that is counted.
const LEAST_RADIUS: f64 = 3.0;

/// A turning point of the radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Apsis {
    /// The lowest point.
    Low,
    /// The highest point.
    High,
}

/// A point of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// r times the direction of theta and Kerr's ingoing azimuth, which does not wind at the horizon;
    /// in r_s.
    pub place: DVec3,
    /// Which turning point it is. Those of a [round](Apsides::are_round) orbit are none.
    pub apsis: Option<Apsis>,
}

/// The places of a ship from now on if it only coasts, the present one first. Points are a twentieth of a
/// radian of the motion apart, and turning points come on top. The path ends after so many points, at a
/// limit of the flight, or far away.
pub fn path_ahead(ship: &Ship, max_points: usize) -> Vec<PathPoint> {
    let (start, limits) = (ship.place(), ship.limits());
    let farthest = FARTHEST * start.r.max(LEAST_RADIUS);
    let is_round = Apsides::of(ship).are_round();
    let apsis_after = |geodesic: &Geodesic| {
        let mut ahead = *geodesic;
        let is_reached = !is_round && ahead.advance_to_apsis(limits).is_none();
        is_reached.then_some(ahead)
    };
    let mut geodesic = ship.geodesic();
    // A ship that starts at a turning point, but for rounding, has it behind it.
    let is_ahead = |apsis: &Geodesic| {
        let start = &geodesic.state;
        apsis.state.proper_time - start.proper_time > AT_START * step_at(start)
    };
    let mut apsis = apsis_after(&geodesic);
    if let Some(first) = apsis.filter(|apsis| !is_ahead(apsis)) {
        apsis = apsis_after(&first);
    }
    let mut points = vec![PathPoint {
        place: start.r * start.n,
        apsis: None,
    }];
    while points.len() < max_points {
        let now = geodesic.state;
        let step = step_at(&now);
        let reached = apsis.filter(|apsis| apsis.state.proper_time <= now.proper_time + step);
        let limit = match reached {
            Some(reached) => {
                geodesic = reached;
                apsis = apsis_after(&geodesic);
                None
            }
            None => geodesic.advance(step, limits),
        };
        points.push(PathPoint {
            place: place_of(&geodesic.state),
            apsis: reached.map(|_| match now.du > 0.0 {
                true => Apsis::Low,
                false => Apsis::High,
            }),
        });
        if limit.is_some() || 1.0 / geodesic.state.u > farthest {
            break;
        }
    }
    points
}

/// The proper time to the next point.
fn step_at(state: &ParticleState) -> f64 {
    let r = 1.0 / state.u;
    let turning = (MASS / r.powi(3)).sqrt().max(state.dn.length() / (r * r));
    // dr/dtau is -u' but for the spin.
    let radial = state.du.abs() / r;
    (STEP / turning).min(RADIAL_STEP / radial)
}

/// The azimuth of the geodesic begins where the ship's is.
fn place_of(state: &ParticleState) -> DVec3 {
    DMat3::from_rotation_z(state.chi) * state.n / state.u
}
