//! The rays of a scene whose error is beyond the method's tolerance.

use super::cause::Cause;
use super::tolerance::tolerance;
use crate::accuracy::{RayError, Truth};
use crate::optics::trace::Trace;
use crate::scene::Scene;
use rayon::prelude::*;

/// A ray whose error is beyond the method's tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FarRay {
    /// Its index.
    pub(super) ray: usize,
    /// The rounding that explains the error.
    pub(super) cause: Option<Cause>,
}

impl FarRay {
    /// The rays beyond the tolerance of the scene's method. Their errors are searched for thoroughly
    /// first, and replaced by the smaller bounds that are found.
    pub(super) fn all(
        scene: &Scene,
        truth: &Truth,
        given: &[Trace],
        errors: &mut [RayError],
    ) -> Vec<Self> {
        let tolerance = tolerance(scene);
        let far = |(ray, error): (usize, &mut RayError)| {
            if error.backward > tolerance {
                let bounds = [0.5 * tolerance, error.backward];
                error.backward = truth.judge_thoroughly(ray, &given[ray], bounds);
            }
            (error.backward > tolerance).then(|| Self {
                ray,
                cause: Cause::of(scene, truth, ray, error.backward),
            })
        };
        errors.par_iter_mut().enumerate().filter_map(far).collect()
    }
}
