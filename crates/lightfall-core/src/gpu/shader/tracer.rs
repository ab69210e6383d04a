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
    pub(super) fn parts(self, delay: bool) -> Vec<Part> {
        match (self, delay) {
            (Self::Verlet, _) => vec![part!("method/verlet.wgsl")],
            (Self::Closed, false) => vec![
                part!("elliptic.wgsl"),
                part!("method/closed_orbit.wgsl"),
                part!("delay/none/closed.wgsl"),
                part!("method/closed.wgsl"),
            ],
            (Self::Closed, true) => vec![
                part!("elliptic.wgsl"),
                part!("method/closed_orbit.wgsl"),
                part!("delay/tortoise.wgsl"),
                part!("delay/closed.wgsl"),
                part!("method/closed.wgsl"),
            ],
            (Self::Mino, false) => vec![
                part!("method/mino_motion.wgsl"),
                part!("method/mino_azimuth.wgsl"),
                part!("delay/none/mino.wgsl"),
                part!("method/mino.wgsl"),
            ],
            (Self::Mino, true) => vec![
                part!("method/mino_motion.wgsl"),
                part!("method/mino_azimuth.wgsl"),
                part!("delay/tortoise.wgsl"),
                part!("delay/mino.wgsl"),
                part!("method/mino.wgsl"),
            ],
            (Self::KerrSchild, _) => {
                vec![
                    part!("delay/tortoise.wgsl"),
                    part!("method/kerr_schild.wgsl"),
                ]
            }
            (Self::Straight, _) => vec![part!("method/straight.wgsl")],
        }
    }

    /// Nodes of the integral that gives the delay, where a picture asks for it: per leg of a ray of
    /// the method closed, per step of the method mino.
    pub(super) fn delay_nodes(self) -> u32 {
        if self == Self::Mino { 3 } else { 4 }
    }

    /// Whether it has a second way to sum azimuths, for rays next to the horizon (the flag
    /// NEAR_HORIZON).
    pub(super) fn has_near_horizon(self) -> bool {
        self == Self::Mino
    }
}
