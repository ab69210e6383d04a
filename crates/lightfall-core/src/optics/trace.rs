//! What became of a ray: the record that every method, on the CPU and on the GPU, answers with.

use glam::DVec3;

/// Where a backward ray ends. Shaders and EXR pictures number them from 0, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// It reaches infinity: its light comes from the sky.
    Sky,
    /// It meets the horizon: no light comes along it.
    Captured,
    /// The method gave up; nothing is known.
    Unfinished,
}

/// One crossing of the disk's annulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Boyer-Lindquist radius, in r_s.
    pub r: f64,
    /// Boyer-Lindquist azimuth, in (-pi, pi], with the observer at `camera.phi_deg`.
    pub phi: f64,
    /// Observed over emitted frequency of light from circular matter there.
    pub g: f64,
}

/// What became of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trace {
    /// Where it ends.
    pub outcome: Outcome,
    /// Unit vector toward the source at infinity, in the hole's frame; present where the outcome is
    /// the sky.
    pub sky: Option<DVec3>,
    /// The first two crossings of the disk's annulus along the backward ray.
    pub hits: [Option<Hit>; 2],
    /// Steps the method took.
    pub steps: u32,
    /// Largest normalized residual of the null constraint met on the way.
    pub residual: f64,
}
