//! Many rays' errors in a few numbers.

use super::finite::{all_finite, greater};
use super::truth::{RayError, Truth};
use crate::optics::trace::{Outcome, Trace};

/// Median, 99th percentile and largest of a set; not a number where it is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantiles {
    /// How many there are.
    pub count: usize,
    /// Half are no larger.
    pub p50: f64,
    /// 99 of 100 are no larger.
    pub p99: f64,
    /// None is larger.
    pub max: f64,
}

impl Quantiles {
    /// Of these values; what is no number counts as infinite.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values
            .map(|value| if value.is_nan() { f64::INFINITY } else { value })
            .collect();
        values.sort_by(f64::total_cmp);
        let count = values.len();
        // The smallest value that is no less than that share of all.
        let at = |share: f64| {
            let index = ((share * count as f64).ceil() as usize).clamp(1, count.max(1)) - 1;
            values.get(index).copied().unwrap_or(f64::NAN)
        };
        Self {
            count,
            p50: at(0.5),
            p99: at(0.99),
            max: at(1.0),
        }
    }
}

/// What is wrong with a method's answers.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorSummary {
    /// Number of rays.
    pub rays: usize,
    /// Rays by the reference's outcome (sky, captured) and the method's (sky, captured,
    /// unfinished).
    pub confusion: [[usize; 3]; 2],
    /// Rays whose answer holds something that is no number.
    pub not_finite: usize,
    /// Rays whose outcome or number of hits is wrong, unfinished ones aside.
    pub misclassified: usize,
    /// The backward errors of those.
    pub misclassified_backward: Quantiles,
    /// Forward: angle between the sky directions, in radians.
    pub sky: Quantiles,
    /// Forward: relative error of the radius of hits.
    pub hit_r: Quantiles,
    /// Forward: relative error of g.
    pub hit_g: Quantiles,
    /// Backward errors, in radians, of the rays that see something or should; infinite for
    /// unfinished ones.
    pub backward: Quantiles,
    /// Largest normalized residual of the null constraint.
    pub residual: f64,
    /// Steps: mean and most.
    pub steps: [f64; 2],
}

impl ErrorSummary {
    /// Of a method's answers to the rays of `truth`.
    ///
    /// # Panics
    /// If there are not as many answers as rays.
    #[must_use]
    pub fn of(truth: &Truth, given: &[Trace]) -> Self {
        let errors = truth.judge(given);
        let mut confusion = [[0; 3]; 2];
        for (truth, given) in truth.traces.iter().zip(given) {
            let column = match given.outcome {
                Outcome::Sky => 0,
                Outcome::Captured => 1,
                Outcome::Unfinished => 2,
            };
            confusion[usize::from(truth.outcome != Outcome::Sky)][column] += 1;
        }
        let seen = |trace: &Trace| trace.sky.is_some() || trace.hits[0].is_some();
        let counted = truth.traces.iter().zip(given).zip(&errors);
        let counted = counted.filter(|((truth, _), error)| seen(truth) || error.backward > 0.0);
        let wrong = |(given, error): &(&Trace, &RayError)| {
            given.outcome != Outcome::Unfinished && error.misclassified
        };
        let misclassified: Vec<f64> = given
            .iter()
            .zip(&errors)
            .filter(wrong)
            .map(|(_, error)| error.backward)
            .collect();
        let steps = given.iter().map(|trace| f64::from(trace.steps));
        Self {
            rays: given.len(),
            confusion,
            not_finite: given.iter().filter(|trace| !all_finite(trace)).count(),
            misclassified: misclassified.len(),
            misclassified_backward: Quantiles::of(misclassified.into_iter()),
            sky: Quantiles::of(errors.iter().filter_map(|error| error.sky)),
            hit_r: Quantiles::of(errors.iter().filter_map(|error| error.hit_r)),
            hit_g: Quantiles::of(errors.iter().filter_map(|error| error.hit_g)),
            backward: Quantiles::of(counted.map(|(_, error)| error.backward)),
            residual: given.iter().map(|trace| trace.residual).fold(0.0, greater),
            steps: [
                steps.clone().sum::<f64>() / given.len().max(1) as f64,
                steps.fold(0.0, f64::max),
            ],
        }
    }

    /// Rays that the method gave up.
    #[must_use]
    pub fn unfinished(&self) -> usize {
        self.confusion[0][2] + self.confusion[1][2]
    }
}
