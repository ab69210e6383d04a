//! The errors of many rays in a few numbers.

use super::answer::{all_finite, greater};
use super::truth::{RayError, Truth};
use lightfall_optics::trace::{Outcome, Trace};

/// Median, 99th percentile and maximum of a set of values; NaN if the set is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantiles {
    /// Number of values.
    pub count: usize,
    /// The median: half of the values are no larger.
    pub p50: f64,
    /// The 99th percentile.
    pub p99: f64,
    /// The maximum.
    pub max: f64,
}

impl Quantiles {
    /// The quantiles of a set of values. NaN counts as infinite.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values
            .map(|value| if value.is_nan() { f64::INFINITY } else { value })
            .collect();
        values.sort_by(f64::total_cmp);
        let count = values.len();
        // The smallest value that is no less than this share of all values.
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

/// The errors of a method's answers to a sample of rays.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorSummary {
    /// Number of rays.
    pub rays: usize,
    /// Numbers of rays by the reference's outcome (sky, captured) and the method's outcome (sky,
    /// captured, unfinished).
    pub confusion: [[usize; 3]; 2],
    /// Number of rays whose answer has a value that is not finite.
    pub not_finite: usize,
    /// Number of rays with a wrong outcome or number of hits. Unfinished rays do not count.
    pub misclassified: usize,
    /// Backward errors of those rays, in radians.
    pub misclassified_backward: Quantiles,
    /// Forward error: angle between the sky directions, in radians.
    pub sky: Quantiles,
    /// Forward error: relative error of the radius of hits.
    pub hit_r: Quantiles,
    /// Forward error: relative error of the g of hits.
    pub hit_g: Quantiles,
    /// Backward errors, in radians, of the rays that see something or should; infinite for
    /// unfinished rays.
    pub backward: Quantiles,
    /// Largest normalized residual of the null constraint.
    pub residual: f64,
    /// Steps: mean and maximum.
    pub steps: [f64; 2],
}

impl ErrorSummary {
    /// The errors of a method's answers to the rays of `truth`.
    ///
    /// # Panics
    /// There are not as many answers as rays.
    pub fn of(truth: &Truth, given: &[Trace]) -> Self {
        Self::of_errors(truth, given, &truth.judge(given))
    }

    /// The same, with the errors that [`Truth::judge`] has found.
    pub fn of_errors(truth: &Truth, given: &[Trace], errors: &[RayError]) -> Self {
        let mut confusion = [[0; 3]; 2];
        for (truth, given) in truth.traces.iter().zip(given) {
            let row = usize::from(truth.outcome != Outcome::Sky);
            confusion[row][given.outcome as usize] += 1;
        }
        let seen = |trace: &Trace| trace.sky.is_some() || trace.hits[0].is_some();
        let counted = truth.traces.iter().zip(given).zip(errors);
        let counted = counted.filter(|((truth, _), error)| seen(truth) || error.backward > 0.0);
        let wrong = |(given, error): &(&Trace, &RayError)| {
            given.outcome != Outcome::Unfinished && error.misclassified
        };
        let misclassified: Vec<f64> = given
            .iter()
            .zip(errors)
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

    /// Number of rays that the method gave up.
    pub fn unfinished(&self) -> usize {
        self.confusion[0][2] + self.confusion[1][2]
    }
}
