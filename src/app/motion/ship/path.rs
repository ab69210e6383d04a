//! The path ahead of a ship that coasts, as the map draws it.

use glam::{DMat3, DVec3};
use lightfall_core::geometry::kerr::MASS;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::geometry::timelike::ParticleState;

/// Largest number of points of the path, and the angle of the motion between two of them: two turns.
const MAX_POINTS: usize = 256;
const STEP: f64 = 0.05;
/// A path that leads away ends at so many times the present radius.
const FARTHEST: f64 = 3.0;
/// The smallest radius, in r_s, from which that is counted.
const LEAST_RADIUS: f64 = 3.0;

/// The places of a ship from now on if it only coasts, the present one first: r times the direction of
/// theta and Kerr's ingoing azimuth, which does not wind at the horizon. It ends after two turns, at a
/// limit of the flight, or far away.
#[must_use]
pub fn path_ahead(ship: &Ship) -> Vec<DVec3> {
    let mut geodesic = ship.geodesic();
    let start = ship.place();
    // The azimuth of the geodesic begins where the ship's is.
    let place_of = |state: &ParticleState| DMat3::from_rotation_z(state.chi) * state.n / state.u;
    let farthest = FARTHEST * start.r.max(LEAST_RADIUS);
    let mut points = vec![start.r * start.n];
    while points.len() < MAX_POINTS {
        let state = &geodesic.state;
        let r = 1.0 / state.u;
        let rate = (MASS / r.powi(3)).sqrt().max(state.dn.length() / (r * r));
        let limit = geodesic.advance(STEP / rate, ship.limits());
        points.push(place_of(&geodesic.state));
        if limit.is_some() || 1.0 / geodesic.state.u > farthest {
            break;
        }
    }
    points
}
