//! The rays of a scene whose error is beyond the method's tolerance.

use super::cause::Cause;
use super::tolerance::tolerance;
use crate::accuracy::{RayError, Truth};
use crate::optics::trace::Trace;
use crate::scene::Scene;

/// A ray whose error is beyond the method's tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FarRay {
    /// Its index.
    pub(super) ray: usize,
    /// The rounding that explains the error.
    pub(super) cause: Option<Cause>,
}

impl FarRay {
    /// The rays beyond the tolerance of the scene's method. An error that no rounding explains is
    /// searched for thoroughly first, and replaced by the smaller bound that is found.
    pub(super) fn all(
        scene: &Scene,
        truth: &Truth,
        given: &[Trace],
        errors: &mut [RayError],
    ) -> Vec<Self> {
        let tolerance = tolerance(scene);
        let far = |(ray, error): (usize, &mut RayError)| {
            if error.backward <= tolerance {
                return None;
            }
            let mut cause = Cause::of(scene, truth, ray, error.backward);
            if cause.is_none() {
                let bounds = [0.5 * tolerance, error.backward];
                error.backward = truth.judge_thoroughly(ray, &given[ray], bounds);
                cause = Cause::of(scene, truth, ray, error.backward);
            }
            (error.backward > tolerance).then_some(Self { ray, cause })
        };
        errors.iter_mut().enumerate().filter_map(far).collect()
    }
}
