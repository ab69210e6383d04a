//! Coordinates for the rays around one ray.

use super::edge::Edge;
use crate::ray::Ray;
use crate::reference_camera::ReferenceCamera;
use glam::{DVec2, DVec3};
use lightfall_model::geometry::sphere::{angle_between, wrap_angle};
use lightfall_optics::trace::Trace;

/// The step of finite differences, as a share of a chart's unit. The derivative is accurate to this
/// share; the reference's twelve digits leave enough digits of the difference.
pub(super) const DIFFERENCE: f64 = 1e-4;
/// The minimum difference along an edge, as a share of its radius.
const ALONG_EDGE: f64 = 1e-5;
/// The line toward an edge: the smallest and the largest step and the length, in e-folds of the
/// distance to the edge, and the maximum number of steps.
const MIN_STEP: f64 = 1e-4;
const MAX_STEP: f64 = 0.2;
const MAX_RADIUS: f64 = 12.0;
const MAX_SCANNED: u32 = 300;

/// Two coordinates for the rays around one ray, which has the coordinates zero.
///
/// Near the edge of the shadow the deflection grows with the logarithm of the distance to the edge
/// (Darwin 1959). There the first coordinate is this logarithm, so answers are nearly linear in
/// both coordinates, and Newton's method converges.
pub(super) struct Chart {
    direction: DVec3,
    kind: Kind,
    /// The unit of both coordinates, in radians: near an edge the distance to it.
    pub(super) scale: f64,
}

enum Kind {
    /// Two directions perpendicular to the ray and to each other.
    Plane([DVec3; 2]),
    /// An edge, the ray's position angle about its centre, the arc length per unit of position
    /// angle, and the ray's angle beyond the edge.
    Edge(Edge, f64, f64, f64),
}

impl Chart {
    /// The chart about a ray without an edge, with a unit in radians.
    pub(super) fn plane(ray: &Ray, scale: f64) -> Self {
        let direction = ray.direction();
        Self {
            direction,
            kind: Kind::Plane(direction.any_orthonormal_pair().into()),
            scale,
        }
    }

    pub(super) fn edge(ray: &Ray) -> Option<Self> {
        let direction = ray.direction();
        let edge = ray.edge?;
        let [position_angle, beyond] = edge.place(direction);
        let arc = edge.at(position_angle).sin();
        let kind = Kind::Edge(edge, position_angle, arc, beyond);
        (beyond != 0.0 && arc > 0.0).then(|| Self {
            direction,
            kind,
            scale: beyond.abs(),
        })
    }

    /// The charts of both sides of a ray's edge, the ray's own side first; none if it has no edge.
    pub(super) fn both_sides(ray: &Ray) -> impl Iterator<Item = Self> {
        let own = Self::edge(ray);
        let mirrored = own.as_ref().and_then(Self::mirrored);
        own.into_iter().chain(mirrored)
    }

    /// The same chart on the other side of its edge, with its origin at the same distance.
    fn mirrored(&self) -> Option<Self> {
        let Kind::Edge(edge, position_angle, arc, beyond) = self.kind else {
            return None;
        };
        Some(Self {
            kind: Kind::Edge(edge, position_angle, arc, -beyond),
            ..*self
        })
    }

    /// The angular radius of the edge, in radians; a radian on a plane.
    pub(super) fn radius(&self) -> f64 {
        match self.kind {
            Kind::Plane(_) => 1.0,
            Kind::Edge(_, _, arc, _) => arc,
        }
    }

    /// The direction at two coordinates.
    pub(super) fn at(&self, place: DVec2) -> DVec3 {
        match &self.kind {
            Kind::Plane([u, v]) => {
                (self.direction + self.scale * (place.x * *u + place.y * *v)).normalize()
            }
            Kind::Edge(edge, position_angle, arc, beyond) => edge.direction(
                position_angle + place.y * self.scale / arc,
                beyond * place.x.exp(),
            ),
        }
    }

    /// The coordinates of a direction less than a right angle from the ray. `None` on the edge and
    /// on its other side.
    pub(super) fn place_of(&self, direction: DVec3) -> Option<DVec2> {
        match &self.kind {
            Kind::Plane([u, v]) => {
                let across = DVec2::new(direction.dot(*u), direction.dot(*v));
                Some(across / (self.scale * direction.dot(self.direction)))
            }
            Kind::Edge(edge, position_angle, arc, beyond) => {
                let [angle, own] = edge.place(direction);
                let along = wrap_angle(angle - position_angle) * arc / self.scale;
                (own / beyond > 0.0).then(|| DVec2::new((own / beyond).ln(), along))
            }
        }
    }

    /// Maximum change of the coordinates in one step of Newton's method: a hundredth of a radian,
    /// but no more than a factor e of the distance to an edge.
    pub(super) fn reach(&self) -> DVec2 {
        let far = (0.01 / self.scale).max(1.0);
        if matches!(self.kind, Kind::Edge(..)) {
            DVec2::new(1.0, far)
        } else {
            DVec2::splat(far)
        }
    }

    /// The steps of finite differences in the two coordinates: a small share of the unit and, along
    /// an edge, at least a small share of its radius: close to the edge a smaller step would
    /// measure only the reference's rounding.
    pub(super) fn differences(&self) -> DVec2 {
        match self.kind {
            Kind::Plane(_) => DVec2::splat(DIFFERENCE),
            Kind::Edge(_, _, arc, _) => DVec2::new(
                DIFFERENCE,
                f64::max(DIFFERENCE, ALONG_EDGE * arc / self.scale),
            ),
        }
    }

    /// The turn from the ray to the direction at two coordinates, in radians.
    pub(super) fn turn(&self, place: DVec2) -> f64 {
        self.turn_to(self.at(place))
    }

    /// The turn from the ray to a direction, in radians.
    pub(super) fn turn_to(&self, direction: DVec3) -> f64 {
        angle_between(self.direction, direction)
    }

    /// Traces rays along the line toward the edge (`side` -1) or away from it (1), up to a turn of
    /// `max_turn`, and returns their first coordinates and answers. Steps are chosen such that
    /// `moved` of two neighbours is about `step_size`.
    pub(super) fn line(
        &self,
        camera: &ReferenceCamera,
        side: f64,
        max_turn: f64,
        step_size: f64,
        moved: impl Fn(&Trace, &Trace) -> f64,
    ) -> Vec<(f64, Trace)> {
        let (mut x, mut step) = (0.0, MIN_STEP);
        let mut line: Vec<(f64, Trace)> = Vec::new();
        for _ in 0..MAX_SCANNED {
            let place = DVec2::new(x, 0.0);
            if self.turn(place) > max_turn || x.abs() > MAX_RADIUS {
                break;
            }
            let trace = camera.trace(self.at(place));
            let moved = line.last().map_or(0.0, |(_, before)| moved(before, &trace));
            step = (step * (step_size / moved).clamp(0.5, 2.0)).clamp(MIN_STEP, MAX_STEP);
            line.push((x, trace));
            x += side * step;
        }
        line
    }
}
