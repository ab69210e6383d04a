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
    /// Closed form, for holes that spin.
    ClosedKerr,
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
        match scene.method.resolved() {
            Method::Verlet => Self::Verlet,
            Method::Mino => Self::Mino,
            Method::KerrSchild => Self::KerrSchild,
            Method::Closed if scene.hole.spin != 0.0 => Self::ClosedKerr,
            Method::Auto | Method::Closed | Method::Reference => Self::Closed,
        }
    }

    /// The files that define `trace`: a new tracer is a new row.
    /// `throat` says whether delays need care in the throat of a nearly extremal hole.
    pub(super) fn parts(self, delay: bool, throat: bool) -> Vec<Part> {
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
            (Self::ClosedKerr, false) => closed_kerr(&[part!("delay/none/closed_kerr.wgsl")]),
            (Self::ClosedKerr, true) => closed_kerr(&[
                part!("delay/tortoise.wgsl"),
                if throat {
                    part!("delay/closed_kerr_throat.wgsl")
                } else {
                    part!("delay/closed_kerr_course.wgsl")
                },
                part!("delay/closed_kerr.wgsl"),
            ]),
            (Self::Mino, false) => vec![
                part!("method/kerr_constants.wgsl"),
                part!("method/horizon.wgsl"),
                part!("method/mino_motion.wgsl"),
                part!("method/mino_azimuth.wgsl"),
                part!("delay/none/mino.wgsl"),
                part!("method/mino.wgsl"),
            ],
            (Self::Mino, true) => vec![
                part!("method/kerr_constants.wgsl"),
                part!("method/horizon.wgsl"),
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

    /// Nodes of the integral that gives the delay, where a picture asks for it: per leg of a ray in
    /// closed form, per step of the method mino.
    pub(super) fn delay_nodes(self) -> u32 {
        match self {
            Self::Mino => 3,
            Self::ClosedKerr => 24,
            _ => 4,
        }
    }

    /// Whether the tracer's own files hold these nodes.
    pub(super) fn has_own_nodes(self) -> bool {
        self == Self::ClosedKerr
    }
}

/// The method closed around a hole that spins, with its parts for the delay.
fn closed_kerr(delay: &[Part]) -> Vec<Part> {
    let before = [
        part!("elliptic.wgsl"),
        part!("method/kerr_constants.wgsl"),
        part!("method/horizon.wgsl"),
        part!("method/closed_kerr_radial.wgsl"),
        part!("method/closed_kerr_leaving.wgsl"),
        part!("method/closed_kerr_polar.wgsl"),
        part!("method/closed_kerr_legs.wgsl"),
        part!("method/closed_kerr_azimuth.wgsl"),
    ];
    let after = [part!("method/closed_kerr.wgsl")];
    [&before, delay, &after].concat()
}
