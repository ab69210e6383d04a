//! The methods that exist as WGSL.

use lightfall_model::scene::{Method, Scene};

/// A file of shaders/method that traces rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Tracer {
    /// The file with the method's own name: that of `closed` is for holes without spin.
    Method(Method),
    /// The method `closed` around holes that spin.
    ClosedKerr,
    /// Straight lines: every scene without lensing uses them, whatever its method.
    Straight,
}

impl Tracer {
    /// The tracer of a scene. [`GpuScene`](crate::GpuScene) refuses what no shader can do.
    pub(super) fn of(scene: &Scene) -> Self {
        if !scene.effects.lensing {
            return Self::Straight;
        }
        match scene.resolved_method() {
            Method::Closed if scene.hole.spin != 0.0 => Self::ClosedKerr,
            Method::Reference => Self::Method(Method::Closed),
            method => Self::Method(method),
        }
    }

    /// Nodes of the integral of the delay: per leg of a ray in closed form, per step of the method
    /// mino.
    pub fn delay_nodes(self) -> u32 {
        match self {
            Self::Method(Method::Mino) => 3,
            Self::ClosedKerr => 24,
            _ => 4,
        }
    }

    /// Whether the tracer's own files hold these nodes.
    pub(super) fn has_own_nodes(self) -> bool {
        self == Self::ClosedKerr
    }
}
