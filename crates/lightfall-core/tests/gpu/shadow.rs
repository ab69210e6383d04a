//! The edge of the shadow, from the outcomes of rays alone.

use crate::direction_off_centre;
use glam::DVec3;
use lightfall_core::gpu::{Gpu, rays};
use lightfall_core::optics::trace::Outcome;
use lightfall_core::scene::Scene;
use std::f64::consts::PI;

/// The outcomes along rays at these angles from the hole's centre, in radians.
pub fn outcomes(gpu: &Gpu, scene: &Scene, angles: &[f64]) -> Vec<Outcome> {
    let directions: Vec<DVec3> = angles
        .iter()
        .map(|angle| direction_off_centre(*angle))
        .collect();
    rays::trace(gpu, scene, &directions)
        .unwrap()
        .iter()
        .map(|trace| trace.outcome)
        .collect()
}

/// The angle from the hole's centre at which rays begin to reach the sky, to 1e-9 rad.
pub fn shadow_half_angle(gpu: &Gpu, scene: &Scene) -> f64 {
    const PARTS: usize = 256;
    let (mut low, mut high) = (0.0, PI);
    for _ in 0..4 {
        let part = (high - low) / PARTS as f64;
        let angles: Vec<f64> = (0..=PARTS).map(|i| low + part * i as f64).collect();
        let first = outcomes(gpu, scene, &angles)
            .iter()
            .position(|outcome| *outcome == Outcome::Sky)
            .unwrap();
        (low, high) = (angles[first.saturating_sub(1)], angles[first]);
    }
    (low + high) / 2.0
}
