//! The methods that exist as WGSL.

use super::text::{Part, part};
use crate::scene::{Method, Scene};

/// A method that exists as WGSL.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tracer {
    /// Velocity Verlet; spin zero only.
    Verlet,
    /// Closed form; spin zero only.
    Closed,
    /// Mino time, any spin.
    Mino,
    /// Runge-Kutta in Kerr-Schild coordinates.
    KerrSchild,
    /// Straight lines: every scene without lensing uses them, whatever its method.
    Straight,
}

impl Tracer {
    /// The tracer of a scene. [`GpuScene`](crate::gpu::GpuScene) refuses what no shader can do.
    pub(super) fn of(scene: &Scene) -> Self {
        if !scene.effects.lensing {
            return Self::Straight;
        }
        match scene.method.resolved(scene.hole.spin) {
            Method::Verlet => Self::Verlet,
            Method::Mino => Self::Mino,
            Method::KerrSchild => Self::KerrSchild,
            Method::Auto | Method::Closed | Method::Reference => Self::Closed,
        }
    }

    /// The files that define `trace`: a new tracer is a new row.
    pub(super) fn parts(self) -> &'static [Part] {
        match self {
            Self::Verlet => &[part!("method/verlet.wgsl")],
            Self::Closed => &[part!("elliptic.wgsl"), part!("method/closed.wgsl")],
            Self::Mino => &[
                part!("method/mino_motion.wgsl"),
                part!("method/mino_azimuth.wgsl"),
                part!("method/mino.wgsl"),
            ],
            Self::KerrSchild => &[part!("method/kerr_schild.wgsl")],
            Self::Straight => &[part!("method/straight.wgsl")],
        }
    }

    /// Whether it has a second way to sum azimuths, for rays next to the horizon (the flag
    /// NEAR_HORIZON).
    pub(super) fn has_near_horizon(self) -> bool {
        self == Self::Mino
    }
}
