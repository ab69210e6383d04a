//! How wrong a method is: its answers beside those of the f64 reference, on rays that look for
//! trouble.
//!
//! Close to the critical curve every half-turn multiplies an error by e^pi whatever the method, so
//! three things are said side by side: the forward error, which is what the picture shows; the
//! backward error, which is the method's own: by how much the ray would have to be turned for the
//! reference to give that answer, up to an angle no greater than the turn; and the confusion matrix
//! of outcomes.

mod backward;
mod chart;
mod class;
mod edge;
mod picture;
mod sample;
mod summary;

pub use edge::Shadow;
pub use picture::over_picture;
pub use sample::{Ray, critical, everywhere, on_picture};
pub use summary::{ErrorSummary, Quantiles};

use crate::geometry::observer::ObserverError;
use crate::optics::reference::Reference;
use crate::optics::trace::{Outcome, Trace};
use crate::scene::Scene;
use glam::{DMat3, DVec3};
use rayon::prelude::*;

/// Rays of a scene's camera and what the reference says of them.
pub struct Truth {
    pub(super) eye: ReferenceCamera,
    /// The rays, in order.
    pub rays: Vec<Ray>,
    /// The reference's answers.
    pub traces: Vec<Trace>,
}

/// The reference behind the scene's camera: directions are (right, up, forward).
pub(super) struct ReferenceCamera {
    reference: Reference,
    shadow: Option<Shadow>,
    /// Whether orbits leave their plane.
    spinning: bool,
    tetrad_from_camera: DMat3,
    /// Scale of turns that matter, in radians: a thousandth of the picture's half height, but no
    /// less than f32 tells apart.
    scale: f64,
}

impl ReferenceCamera {
    /// The eye of a scene's camera.
    pub(super) fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let mut eye = Self {
            reference: Reference::new(scene)?,
            shadow: None,
            spinning: scene.hole.spin != 0.0 && scene.effects.lensing,
            tetrad_from_camera: scene.camera.tetrad_from_camera(),
            scale: (1e-3 * scene.camera.half_height()).clamp(1e-7, 1e-3),
        };
        eye.shadow = Shadow::of(scene, &eye);
        Ok(eye)
    }

    /// The same ray, with the edge of the shadow on its side, if there is one.
    pub(super) fn with_edge(&self, ray: &Ray) -> Ray {
        let edge = ray.edge.or_else(|| {
            self.shadow
                .map(|shadow| shadow.edge_toward(self, ray.direction()))
        });
        Ray { edge, ..*ray }
    }

    /// What becomes of the ray that arrives from a direction of the camera's.
    pub(super) fn trace(&self, direction: DVec3) -> Trace {
        self.reference.trace(self.tetrad_from_camera * direction)
    }
}

/// What is wrong with one answer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RayError {
    /// Angle between the sky directions, in radians, where both answers are the sky.
    pub sky: Option<f64>,
    /// Largest relative error of the radius of the hits that both answers have.
    pub hit_r: Option<f64>,
    /// Largest relative error of their g.
    pub hit_g: Option<f64>,
    /// The turn of the ray that explains the answer, in radians: zero where there is nothing to
    /// explain, infinite where no turn does (an unfinished ray, a number that is none).
    pub backward: f64,
    /// Whether outcome or number of hits differ.
    pub misclassified: bool,
}

impl Truth {
    /// Traces the rays by the reference.
    ///
    /// # ErrorSummary
    /// If the scene's observer cannot exist.
    pub fn of(scene: &Scene, rays: Vec<Ray>) -> Result<Self, ObserverError> {
        let eye = ReferenceCamera::new(scene)?;
        let traces = rays
            .par_iter()
            .map(|ray| eye.trace(ray.direction()))
            .collect();
        Ok(Self { eye, rays, traces })
    }

    /// Judges a method's answers to the same rays, ray by ray.
    ///
    /// # Panics
    /// If there are not as many answers as rays.
    #[must_use]
    pub fn judge(&self, given: &[Trace]) -> Vec<RayError> {
        self.judge_beyond(0.0, given)
    }

    /// As [`Truth::judge`], but where an answer is off by less than `fine` radians, that itself is
    /// its backward error: it bounds it, and a search for what is worse than that has no need of
    /// more.
    ///
    /// # Panics
    /// If there are not as many answers as rays.
    #[must_use]
    pub fn judge_beyond(&self, fine: f64, given: &[Trace]) -> Vec<RayError> {
        assert_eq!(given.len(), self.rays.len(), "one answer a ray");
        let known = self.rays.par_iter().zip(&self.traces);
        known
            .zip(given)
            .map(|((ray, truth), given)| self.judge_ray(ray, truth, given, fine))
            .collect()
    }

    /// The backward error, in radians, of what another scene's reference answers to one of the
    /// rays.
    #[must_use]
    pub fn error_of(&self, ray: usize, other: &Reference) -> f64 {
        let given = other.trace(self.eye.tetrad_from_camera * self.rays[ray].direction());
        self.judge_ray(&self.rays[ray], &self.traces[ray], &given, 0.0)
            .backward
    }

    fn judge_ray(&self, ray: &Ray, truth: &Trace, given: &Trace, fine: f64) -> RayError {
        let misclassified = given.outcome != truth.outcome || hits(given) != hits(truth);
        let pairs = || {
            truth
                .hits
                .iter()
                .zip(&given.hits)
                .filter_map(|(truth, given)| truth.zip(*given))
        };
        let largest = |of: fn((f64, f64)) -> f64, pairs: &mut dyn Iterator<Item = (f64, f64)>| {
            pairs.map(of).fold(None, |most: Option<f64>, error| {
                Some(most.map_or(error, |most| greater(most, error)))
            })
        };
        let relative = |(truth, given): (f64, f64)| (given / truth - 1.0).abs();
        let mut error = RayError {
            sky: truth
                .sky
                .zip(given.sky)
                .map(|(truth, given)| angle_between(truth, given)),
            hit_r: largest(
                relative,
                &mut pairs().map(|(truth, given)| (truth.r, given.r)),
            ),
            hit_g: largest(
                relative,
                &mut pairs().map(|(truth, given)| (truth.g, given.g)),
            ),
            backward: 0.0,
            misclassified,
        };
        error.backward = if given.outcome == Outcome::Unfinished || !all_finite(given) {
            f64::INFINITY
        } else if misclassified {
            class::of_class(&self.eye, ray, given, fine)
        } else {
            backward::of_answer(&self.eye, ray, truth, given, fine)
        };
        error
    }
}

/// How many hits an answer has.
fn hits(trace: &Trace) -> usize {
    trace.hits.iter().flatten().count()
}

/// Whether every number of an answer is one.
pub(super) fn all_finite(trace: &Trace) -> bool {
    let hits = trace
        .hits
        .iter()
        .flatten()
        .all(|hit| (hit.r * hit.phi * hit.g).is_finite());
    hits && trace.sky.is_none_or(DVec3::is_finite) && trace.residual.is_finite()
}

/// The greater of two numbers; what is no number is greater than any.
fn greater(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// The angle between two directions, to f64's digits however small it is.
pub(super) fn angle_between(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}
