//! The reference's answers to a set of rays, and the errors of a method's answers.

use super::answer::{greater, is_complete, is_same_class};
use super::ray::Ray;
use super::reference_camera::ReferenceCamera;
use super::search::backward::backward_error;
use super::search::class::class_backward_error;
use super::search::thorough::ThoroughSearch;
use super::search::turns::TurnBounds;
use lightfall_model::geometry::observer::{ObserverError, Photon};
use lightfall_model::geometry::sphere::angle_between;
use lightfall_model::scene::Scene;
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::{Hit, Trace};
use rayon::prelude::*;

/// Rays of a scene's camera and the reference's answers to them.
pub struct Truth {
    camera: ReferenceCamera,
    /// The rays, in order.
    pub rays: Vec<Ray>,
    /// The reference's answers.
    pub traces: Vec<Trace>,
}

/// The errors of one answer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RayError {
    /// Angle between the sky directions, in radians, where both answers are the sky.
    pub sky: Option<f64>,
    /// Largest relative error of the radius of the hits that both answers have.
    pub hit_r: Option<f64>,
    /// Largest relative error of their g.
    pub hit_g: Option<f64>,
    /// The turn of the ray that explains the answer, in radians: zero where there is nothing to
    /// explain, infinite where no turn explains it (an unfinished ray, or a NaN).
    pub backward: f64,
    /// Whether outcome or number of hits differ.
    pub misclassified: bool,
}

impl Truth {
    /// Traces the rays with the reference.
    ///
    /// # Errors
    /// The scene's observer cannot exist.
    pub fn of(scene: &Scene, rays: Vec<Ray>) -> Result<Self, ObserverError> {
        let camera = ReferenceCamera::new(scene)?;
        let traces = rays
            .par_iter()
            .map(|ray| camera.trace(ray.direction()))
            .collect();
        Ok(Self {
            camera,
            rays,
            traces,
        })
    }

    /// The errors of a method's answers to the same rays, ray by ray.
    ///
    /// # Panics
    /// There are not as many answers as rays.
    pub fn judge(&self, given: &[Trace]) -> Vec<RayError> {
        self.judge_to_precision(0.0, given)
    }

    /// As [`Truth::judge`], but faster: a search ends once the backward error is known to be below
    /// `precision` radians, so errors below it are only upper bounds.
    ///
    /// # Panics
    /// There are not as many answers as rays.
    pub fn judge_to_precision(&self, precision: f64, given: &[Trace]) -> Vec<RayError> {
        assert_eq!(given.len(), self.rays.len(), "one answer per ray");
        let known = self.rays.par_iter().zip(&self.traces);
        known
            .zip(given)
            .map(|((ray, truth), given)| self.judge_ray(ray, truth, given, precision))
            .collect()
    }

    /// As [`Truth::judge`], but with a [`Truth::thorough_search`] for errors beyond `limit`
    /// radians, some of which the usual search overstates next to the edge of the shadow.
    ///
    /// # Panics
    /// There are not as many answers as rays.
    pub fn judge_to_limit(&self, limit: f64, given: &[Trace]) -> Vec<RayError> {
        let mut errors = self.judge(given);
        let judged = errors.par_iter_mut().zip(given).enumerate();
        let is_within = |error: &RayError| error.backward <= limit;
        judged
            .filter(|(_, (error, given))| !is_within(error) && is_complete(given))
            .for_each(|(ray, (error, given))| {
                let bounds = TurnBounds::for_limit(limit, error.backward);
                error.backward = self.thorough_search(ray, bounds).judge(given, bounds);
            });
        errors
    }

    /// A search around the ray of index `ray` that is a hundred times slower than [`Truth::judge`],
    /// and finds smaller turns next to the edge of the shadow.
    pub fn thorough_search(&self, ray: usize, bounds: TurnBounds) -> ThoroughSearch<'_> {
        ThoroughSearch::new(&self.camera, &self.rays[ray], &self.traces[ray], bounds)
    }

    /// The backward error, in radians, of an answer to the ray of index `ray`. A bound below
    /// `precision` ends the search.
    pub fn error_of(&self, ray: usize, given: &Trace, precision: f64) -> f64 {
        self.backward(&self.rays[ray], &self.traces[ray], given, precision)
    }

    /// The backward error, in radians, of the outcome and the sky of an answer to the ray of index
    /// `ray`, without its hits. Infinite for another outcome.
    pub fn error_without_hits(&self, ray: usize, given: &Trace, precision: f64) -> f64 {
        let truth = &self.traces[ray];
        if given.outcome != truth.outcome {
            return f64::INFINITY;
        }
        let given = Trace {
            hits: truth.hits,
            ..*given
        };
        self.backward(&self.rays[ray], truth, &given, precision)
    }

    /// The answer of another scene's reference to the ray of index `ray`.
    pub fn trace_by(&self, ray: usize, other: &Reference) -> Trace {
        let axes = self.camera.tracer.tetrad_from_camera;
        other.trace(axes * self.rays[ray].direction())
    }

    /// The reference's answer to the ray of index `ray` with its photon changed by `change`, and
    /// the angle in radians between this ray and the one that has the changed photon. `None` if
    /// there is no such photon.
    pub fn trace_changed(&self, ray: usize, change: impl Fn(&mut Photon)) -> Option<(Trace, f64)> {
        self.camera
            .tracer
            .trace_changed(self.rays[ray].direction(), change)
    }

    fn judge_ray(&self, ray: &Ray, truth: &Trace, given: &Trace, precision: f64) -> RayError {
        let largest_error = |part: fn(&Hit) -> f64| {
            let pairs = truth.hits.iter().zip(&given.hits);
            let errors = pairs.filter_map(|(truth, given)| {
                Some((part(given.as_ref()?) / part(truth.as_ref()?) - 1.0).abs())
            });
            errors.reduce(greater)
        };
        let skies = truth.sky.zip(given.sky);
        RayError {
            sky: skies.map(|(truth, given)| angle_between(truth, given)),
            hit_r: largest_error(|hit| hit.r),
            hit_g: largest_error(|hit| hit.g),
            backward: self.backward(ray, truth, given, precision),
            misclassified: !is_same_class(truth, given),
        }
    }

    fn backward(&self, ray: &Ray, truth: &Trace, given: &Trace, precision: f64) -> f64 {
        if !is_complete(given) {
            f64::INFINITY
        } else if is_same_class(truth, given) {
            backward_error(&self.camera, ray, truth, given, precision)
        } else {
            class_backward_error(&self.camera, ray, given, precision)
        }
    }
}
