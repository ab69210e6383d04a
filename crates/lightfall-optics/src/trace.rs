//! The result of tracing a ray, the same for every method on the CPU and on the GPU. The twin in
//! WGSL is `Trace` in shaders/trace.wgsl.

use glam::DVec3;
use serde::{Serialize, Serializer};

/// The outcome of a backward ray. Shaders and EXR pictures number the outcomes from 0, in this
/// order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// The ray reaches infinity: its light comes from the sky.
    Sky,
    /// The ray meets the horizon: no light comes along it.
    Captured,
    /// The method gave up; the end of the ray is unknown.
    Unfinished,
}

impl Outcome {
    /// Every outcome, in the order of their numbers.
    pub const ALL: [Self; 3] = [Self::Sky, Self::Captured, Self::Unfinished];

    /// The outcome's name in files and reports.
    pub fn word(self) -> &'static str {
        match self {
            Self::Sky => "sky",
            Self::Captured => "captured",
            Self::Unfinished => "unfinished",
        }
    }
}

impl Serialize for Outcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word())
    }
}

/// One crossing of the disk's annulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Boyer-Lindquist radius, in r_s.
    pub r: f64,
    /// Boyer-Lindquist azimuth, in (-pi, pi], in the frame where the observer is at
    /// `camera.phi_deg`. In a tilted disk it is counted from the ascending node, whose azimuth is
    /// `disk.node_deg`.
    pub phi: f64,
    /// Observed over emitted frequency of light from matter on the circular orbit there.
    pub g: f64,
    /// Time between emission and arrival, in r_s/c: Boyer-Lindquist's, or without lensing that of
    /// flat space. `None` for a camera at or inside the horizon, which Boyer-Lindquist's time does
    /// not reach, and if not requested.
    pub delay: Option<f64>,
}

/// The result of tracing a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trace {
    /// Where it ends.
    pub outcome: Outcome,
    /// Unit vector toward the source at infinity, in the hole's frame; `None` unless the outcome is
    /// the sky.
    pub sky: Option<DVec3>,
    /// The first two crossings of the disk's annulus along the backward ray.
    pub hits: [Option<Hit>; 2],
    /// Number of steps of the method.
    pub steps: u32,
    /// Largest normalized residual of the null constraint along the ray.
    pub residual: f64,
}

impl Trace {
    /// The record of a ray that has met nothing yet, with the residual at its start.
    pub(crate) fn empty(residual: f64) -> Self {
        Self {
            outcome: Outcome::Unfinished,
            sky: None,
            hits: [None; 2],
            steps: 0,
            residual,
        }
    }

    /// The record with this outcome.
    pub(crate) fn ending(self, outcome: Outcome) -> Self {
        Self { outcome, ..self }
    }
}
