//! The guides that are traced through bent light.

use super::outline::outline;
use super::sky::{Place, Sky};
use crate::critical_curve::CriticalCurve;
use crate::reference::{HoleAndDisk, time_to_plane};
use crate::trace::{Outcome, Trace};
use glam::DVec3;
use lightfall_model::geometry::mino::PhotonConstants;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::Scene;
use std::f64::consts::{FRAC_PI_2, TAU};

/// A camera closer to the disk's plane than this, in radians, sees an orbit in the plane as from
/// this height: from within the plane the near half of the orbit is a line.
const MIN_HEIGHT: f64 = 2e-3;
const EDGE_POINTS: usize = 256;
/// Number of points at which a step of a ray is compared with the ergosphere.
const SAMPLES_PER_STEP: u32 = 12;
/// Far outside every orbit that a guide shows, in r_s.
const FAR: f64 = 1e9;

/// The edge of the shadow: the directions of light that grazes the photon orbits.
pub(super) fn shadow_edge(scene: &Scene) -> Result<Vec<DVec3>, ObserverError> {
    let place = Place::of(scene);
    let sky = Sky::bent(scene, &place)?;
    let kerr = scene.kerr();
    let curve = CriticalCurve::new(kerr, sky.r, place.theta, place.phi);
    let angle = |i: usize| TAU * (i as f64 + 0.5) / EDGE_POINTS as f64;
    Ok(sky.curve_seen((0..EDGE_POINTS).map(|i| curve.at(angle(i)))))
}

/// The image of the circle of radius `radius` (r_s) in the disk's plane after `crossing` - 1 other
/// crossings of the plane: 1 for the first image. `None` where the camera has no such image.
pub(super) fn orbit_image(
    scene: &Scene,
    radius: f64,
    crossing: u32,
) -> Result<Option<Vec<DVec3>>, ObserverError> {
    let own = Place::of(scene);
    let height = own.theta - FRAC_PI_2;
    let place = Place {
        theta: FRAC_PI_2 + height.abs().max(MIN_HEIGHT).copysign(height),
        ..own
    };
    let sky = Sky::bent(scene, &place)?;
    let hole = HoleAndDisk {
        kerr: scene.kerr(),
        // Rays are followed at least to this radius.
        annulus: Some([radius, FAR]),
    };
    // Positive for rays that cross the plane within the circle, or end at the hole before.
    let value = |direction: DVec3| {
        let (mut crossings, mut u) = (0, None);
        let trace = follow(&sky, &hole, direction, |expansion, end| {
            let z_end = expansion.n[2].at(end).0;
            if u.is_none()
                && let Some(time) = time_to_plane(expansion, z_end, end)
            {
                crossings += 1;
                u = (crossings == crossing).then(|| expansion.u.at(time).0);
            }
        });
        match (u, trace.outcome) {
            (Some(u), _) => (u * radius - 1.0).min(1.0),
            (None, Outcome::Sky) => -1.0,
            (None, _) => 1.0,
        }
    };
    Ok(outline(value).map(|curve| sky.curve_seen(curve)))
}

/// The outline of the ergosphere: the edge of the directions whose rays pass through it. This
/// includes rays that end at the hole. `None` without spin, and for a camera inside.
pub(super) fn ergosphere(scene: &Scene) -> Result<Option<Vec<DVec3>>, ObserverError> {
    let sky = Sky::bent(scene, &Place::of(scene))?;
    let kerr = scene.kerr();
    if kerr.spin == 0.0 || sky.r <= kerr.static_limit(sky.n.z) {
        return Ok(None);
    }
    let hole = HoleAndDisk {
        kerr,
        annulus: None,
    };
    let value = |direction: DVec3| {
        let mut deepest = -1.0_f64;
        let trace = follow(&sky, &hole, direction, |expansion, end| {
            for i in 0..=SAMPLES_PER_STEP {
                let state = expansion.at(end * f64::from(i) / f64::from(SAMPLES_PER_STEP));
                deepest = deepest.max(state.u * kerr.static_limit(state.n.z) - 1.0);
            }
        });
        if trace.outcome == Outcome::Sky {
            deepest
        } else {
            1.0
        }
    };
    Ok(outline(value).map(|curve| sky.curve_seen(curve)))
}

/// Follows the ray that arrives from a direction of the sky's frame, and calls `visit` with the
/// series and the length of every step.
fn follow(
    sky: &Sky,
    hole: &HoleAndDisk,
    direction: DVec3,
    mut visit: impl FnMut(&lightfall_model::geometry::mino::PhotonSeries, f64),
) -> Trace {
    let photon = sky.frame.photon(direction);
    let (constants, start) = PhotonConstants::of_photon(hole.kerr, &photon, sky.r, sky.n);
    hole.follow(&constants, start, |step| visit(step.expansion, step.length))
}
