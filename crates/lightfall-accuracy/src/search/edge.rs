//! The edge of the shadow: rays close to it are the hardest to trace.

use crate::camera_tracer::CameraTracer;
use glam::DVec3;
use lightfall_model::geometry::observer::Photon;
use lightfall_model::geometry::sphere::{angle_between, celestial_frame};
use lightfall_model::scene::Scene;
use lightfall_optics::camera_rays::CameraRays;
use lightfall_optics::trace::Outcome;
use std::f64::consts::TAU;

/// Maximum number of bisections of the logarithm of the edge's angle: enough for all digits of f64.
const BISECTIONS: u32 = 64;
/// Distance, in radians of position angle, for the finite differences of the edge.
const NEIGHBOURHOOD: f64 = 2e-3;

/// The shadow on the observer's sky: the inside of an edge about a centre, or the outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shadow {
    /// A direction, (right, up, forward) of the camera.
    pub centre: DVec3,
    /// Whether the centre lies in the shadow; otherwise it lies in the sky.
    pub captured: bool,
}

impl Shadow {
    /// The shadow of a scene. `None` without lensing, or if no edge separates opposite directions.
    pub(crate) fn of(scene: &Scene, tracer: &CameraTracer) -> Option<Self> {
        if !scene.effects.lensing {
            return None;
        }
        // Light along the principal null directions has L = a E sin^2(theta), Q = -(a E
        // cos(theta))^2, Sigma p^r = +- E Sigma: for any spin, one of the two directions comes
        // straight from the hole and the other straight from the sky. In r_s, a = chi/2.
        let matrix = CameraRays::new(scene).ok()?.matrix;
        let camera = &scene.camera;
        let [n, _, phi_hat] =
            celestial_frame(camera.theta_deg.to_radians(), camera.phi_deg.to_radians());
        let (a, r) = (scene.hole.spin / 2.0, camera.r);
        let from_camera = scene.camera.tetrad_from_camera();
        let direction = |sign: f64| {
            let photon = Photon {
                energy: 1.0,
                radial: sign * (1.0 + (a * n.z / r).powi(2)),
                w: a * n.x.hypot(n.y) / r * phi_hat,
            };
            Some(from_camera.transpose() * matrix.direction_of(&photon, n)?)
        };
        let class = |direction: DVec3| tracer.trace(direction).outcome;
        let about = |sign: f64, captured: bool| {
            let (own, opposite) = if captured {
                (Outcome::Captured, Outcome::Sky)
            } else {
                (Outcome::Sky, Outcome::Captured)
            };
            let centre = direction(sign)?;
            (class(centre) == own && class(-centre) == opposite)
                .then_some(Self { centre, captured })
        };
        about(1.0, true).or_else(|| about(-1.0, false))
    }

    /// The direction at an angle from the centre and a position angle about it.
    pub fn direction(&self, position_angle: f64, angle: f64) -> DVec3 {
        let (u, v) = self.centre.any_orthonormal_pair();
        let (sin, cos) = position_angle.sin_cos();
        angle.cos() * self.centre + angle.sin() * (cos * u + sin * v)
    }

    pub(crate) fn edge(&self, tracer: &CameraTracer, position_angle: f64) -> Edge {
        let whole = [-46.0, 46.0];
        let t = self.bisected(tracer, position_angle, whole);
        let neighbour = |side: f64| {
            let near = [t - NEIGHBOURHOOD, t + NEIGHBOURHOOD];
            let found = self.bisected(tracer, position_angle + side * NEIGHBOURHOOD, near);
            // At a corner of the edge the neighbour lies outside this bracket.
            let cut_off = (found - t).abs() > 0.99 * NEIGHBOURHOOD;
            angle(if cut_off {
                self.bisected(tracer, position_angle + side * NEIGHBOURHOOD, whole)
            } else {
                found
            })
        };
        let (before, here, after) = (neighbour(-1.0), angle(t), neighbour(1.0));
        let slope = (after - before) / (2.0 * NEIGHBOURHOOD);
        let curvature = (after - 2.0 * here + before) / (2.0 * NEIGHBOURHOOD.powi(2));
        Edge {
            centre: self.centre,
            along: self.direction(position_angle, 0.25 * TAU),
            angle: [here, slope, curvature],
        }
    }

    /// The edge around the position angle of a direction.
    pub(crate) fn edge_toward(&self, tracer: &CameraTracer, direction: DVec3) -> Edge {
        let (u, v) = self.centre.any_orthonormal_pair();
        self.edge(tracer, direction.dot(v).atan2(direction.dot(u)))
    }

    /// The angle from the centre at which the outcome changes, as the logarithm of the tangent of
    /// its half.
    fn bisected(&self, tracer: &CameraTracer, position_angle: f64, mut bracket: [f64; 2]) -> f64 {
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (bracket[0] + bracket[1]);
            if middle <= bracket[0] || middle >= bracket[1] {
                break;
            }
            let captured = tracer
                .trace(self.direction(position_angle, angle(middle)))
                .outcome
                == Outcome::Captured;
            bracket[usize::from(captured != self.captured)] = middle;
        }
        bracket[0]
    }
}

/// The angle, given the logarithm of the tangent of its half.
fn angle(t: f64) -> f64 {
    2.0 * t.exp().atan()
}

/// The edge of the shadow near one position angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Edge {
    pub(crate) centre: DVec3,
    /// The direction of position angle zero, perpendicular to the centre.
    along: DVec3,
    /// Angle of the edge from the centre in radians, as coefficients of a polynomial in the
    /// position angle, from the constant up.
    angle: [f64; 3],
}

impl Edge {
    /// Angle of the edge from the centre at position angle zero, in radians.
    pub(crate) fn middle(&self) -> f64 {
        self.angle[0]
    }

    /// Angle of the edge from the centre at a position angle, in radians.
    pub(crate) fn at(&self, position_angle: f64) -> f64 {
        let [here, slope, curvature] = self.angle;
        here + position_angle * (slope + position_angle * curvature)
    }

    /// Position angle of a direction, and its angle beyond the edge, in radians.
    pub(crate) fn place(&self, direction: DVec3) -> [f64; 2] {
        let across = self.centre.cross(self.along);
        let position_angle = direction.dot(across).atan2(direction.dot(self.along));
        [
            position_angle,
            angle_between(self.centre, direction) - self.at(position_angle),
        ]
    }

    /// The direction at a position angle and an angle `beyond` the edge.
    pub(crate) fn direction(&self, position_angle: f64, beyond: f64) -> DVec3 {
        let angle = self.at(position_angle) + beyond;
        let (sin, cos) = position_angle.sin_cos();
        angle.cos() * self.centre
            + angle.sin() * (cos * self.along + sin * self.centre.cross(self.along))
    }
}
