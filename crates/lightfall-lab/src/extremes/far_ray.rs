//! The rays of a scene whose error is beyond the method's tolerance.

use super::cause::Cause;
use super::narrow_ring::is_narrow;
use lightfall_accuracy::{RayError, Truth, TurnBounds, tolerance};
use lightfall_model::scene::Scene;
use lightfall_optics::trace::Trace;
use rayon::prelude::*;

/// Number of rays that are searched thoroughly in parallel, and number of unexplained ones after
/// which the search stops, because the method is wrong. The others count as unexplained.
const RAYS_AT_ONCE: usize = 16;
const MAX_UNEXPLAINED: usize = 16;

/// A ray whose error is beyond the method's tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FarRay {
    pub(super) ray: usize,
    /// Why it is so far off, if that is known.
    pub(super) cause: Option<Cause>,
}

/// The rays of a scene beyond its tolerance.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct FarRays(Vec<FarRay>);

impl FarRays {
    /// The rays beyond the tolerance of the scene's method, after a thorough search has replaced
    /// their errors by smaller bounds.
    pub(super) fn find(
        scene: &Scene,
        truth: &Truth,
        given: &[Trace],
        errors: &mut [RayError],
    ) -> Self {
        let tolerance = tolerance(scene);
        let is_far = |ray: &usize| !is_within(errors[*ray].backward, tolerance);
        let candidates: Vec<usize> = (0..errors.len()).filter(is_far).collect();
        let mut far = Self::default();
        for rays in candidates.chunks(RAYS_AT_ONCE) {
            if far.unexplained() >= MAX_UNEXPLAINED {
                let unexplained = rays.iter().map(|ray| FarRay {
                    ray: *ray,
                    cause: None,
                });
                far.0.extend(unexplained);
                continue;
            }
            let examined: Vec<_> = rays
                .par_iter()
                .map(|ray| examine(scene, truth, (*ray, &given[*ray]), errors[*ray].backward))
                .collect();
            for (ray, (backward, cause)) in rays.iter().zip(examined) {
                errors[*ray].backward = backward;
                if !is_within(backward, tolerance) {
                    far.0.push(FarRay { ray: *ray, cause });
                }
            }
        }
        far
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Number of rays that nothing explains.
    pub(super) fn unexplained(&self) -> usize {
        self.0.iter().filter(|ray| ray.cause.is_none()).count()
    }

    pub(super) fn get(&self, ray: usize) -> Option<&FarRay> {
        self.0.iter().find(|far| far.ray == ray)
    }
}

/// Whether an error is within a tolerance. NaN is not.
fn is_within(backward: f64, tolerance: f64) -> bool {
    backward <= tolerance
}

/// The backward error of the answer to a ray by a thorough search, and its cause if it is beyond
/// the tolerance.
fn examine(
    scene: &Scene,
    truth: &Truth,
    (ray, given): (usize, &Trace),
    upper_bound: f64,
) -> (f64, Option<Cause>) {
    let tolerance = tolerance(scene);
    let bounds = TurnBounds::for_limit(tolerance, upper_bound);
    let search = truth.thorough_search(ray, bounds);
    let backward = search.judge(given, bounds);
    if is_within(backward, tolerance) {
        return (backward, None);
    }
    let cause = Cause::of_roundings(scene, truth, &search, (ray, given), backward);
    let is_unanswerable =
        || is_narrow(scene) && truth.error_without_hits(ray, given, bounds.target) <= tolerance;
    let cause = cause.or_else(|| is_unanswerable().then_some(Cause::NarrowRing));
    (backward, cause)
}
