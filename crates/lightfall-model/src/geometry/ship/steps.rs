//! The steps of a ship's motion with its engine, and where they end.

use super::extrapolation::{MAX_ROWS, Step, evaluations, step};
use super::motion::{AXES, NUMBERS, PLACE, State};
use super::vectors::{largest, largest_of, minkowski, orthonormal};
use super::{Controls, Place, Ship, VectorConstants};
use crate::geometry::kerr::Kerr;
use crate::geometry::timelike::Limit;
use glam::{DVec3, DVec4, Vec4Swizzles};
use std::ops::Range;

/// How much longer the next step is tried where one converged before the last row.
const GROWTH: f64 = 1.5;

/// The number of rows from which on the next step is not tried longer.
const ROWS_TO_GROW: usize = 5;

/// Maximum number of halvings of one step. No motion outside the inner horizon needs as many.
const MAX_HALVINGS: u32 = 60;

/// By how much the tolerance is larger while the step to a limit is sought.
const BISECTION_TOLERANCE: f64 = 100.0;

/// Largest |u.u + 1| of a step, in units of its tolerance times the square of the largest component.
/// An error of the tolerance in one component makes it two.
const MAX_NORM: f64 = 8.0;

/// Number of halvings that find where a step meets a limit, to the last digit.
const LIMIT_HALVINGS: u32 = 60;

impl Ship {
    /// Integrates the equations of motion.
    pub(super) fn fly(&mut self, controls: &Controls, proper_time: f64) -> Option<Limit> {
        let mut left = proper_time;
        loop {
            let place = Place::new(self.kerr, self.state.place.yzw());
            if let Some(limit) = self.limit_at(&place) {
                return Some(limit);
            }
            if left <= 0.0 {
                return None;
            }
            let Some((length, step)) = self.converged_step(&place, controls, left) else {
                return Some(Limit::Lost);
            };
            if self.is_within_limits(&step) {
                self.accept(length, &step);
                left = if length < left { left - length } else { 0.0 };
            } else {
                // Where the limit is, a step of the full tolerance leads, or several.
                let reached = self.time_to_limit(controls, length).and_then(|time| {
                    let (length, step) = self.converged_step(&place, controls, time)?;
                    Some((length, step, length == time))
                });
                let Some((length, step, is_there)) = reached else {
                    return Some(Limit::Lost);
                };
                self.accept(length, &step);
                left -= length;
                if is_there {
                    let inward = step_radius(self.kerr, &step) < place.r;
                    return Some(if inward { Limit::Inner } else { Limit::Outer });
                }
            }
        }
    }

    /// The limit that the ship has reached, if it moves toward it.
    fn limit_at(&self, place: &Place) -> Option<Limit> {
        const ROUNDING: f64 = 1e-12;
        let [inner, outer] = self.limits;
        let radial = VectorConstants::new(place, self.velocity()).radial;
        if place.r <= inner * (1.0 + ROUNDING) && radial <= 0.0 {
            Some(Limit::Inner)
        } else if place.r >= outer * (1.0 - ROUNDING) && radial >= 0.0 {
            Some(Limit::Outer)
        } else {
            None
        }
    }

    fn is_within_limits(&self, step: &Step<NUMBERS>) -> bool {
        let r = step_radius(self.kerr, step);
        r >= self.limits[0] && r <= self.limits[1]
    }

    /// The longest step that converges, of those that are the next one's length or its halves.
    fn converged_step(
        &mut self,
        place: &Place,
        controls: &Controls,
        left: f64,
    ) -> Option<(f64, Step<NUMBERS>)> {
        // A sixth of the time of a turn at this radius, about.
        let most = if self.next_step.is_finite() {
            self.next_step
        } else {
            place.r * place.r.sqrt()
        };
        let mut length = most.min(left);
        for _ in 0..MAX_HALVINGS {
            if let Some(step) = self.try_step(controls, length, self.tolerance) {
                let next = if step.rows <= ROWS_TO_GROW {
                    GROWTH * length
                } else {
                    length
                };
                // A step that the end of the time made short says nothing about a longer one.
                self.next_step = if length < most.min(left) {
                    next
                } else {
                    next.max(most)
                };
                return Some((length, step));
            }
            length *= 0.5;
        }
        None
    }

    /// A step that converges: the last two entries of a row agree, and u.u is -1. The former alone
    /// may be chance in a step that is much too long.
    fn try_step(
        &mut self,
        controls: &Controls,
        length: f64,
        tolerance: f64,
    ) -> Option<Step<NUMBERS>> {
        let kerr = self.kerr;
        let size = 1.0 + largest(&self.state.frame);
        let limit = tolerance * size;
        let mut numbers = self.state.numbers();
        // No rate depends on the time, which is added without loss of its last digits.
        numbers[0] = 0.0;
        let rate =
            |numbers: &[f64; NUMBERS]| State::of_numbers(numbers).rate(kerr, controls).numbers();
        let agree = |last: &[f64; NUMBERS], before: &[f64; NUMBERS]| {
            let agree = AXES.clone().all(|i| (last[i] - before[i]).abs() < limit);
            agree && {
                let u = self.velocity() + DVec4::from_slice(&last[AXES]);
                (minkowski(u, u) + 1.0).abs()
                    < MAX_NORM * size.max(largest_of(u.to_array())) * limit
            }
        };
        let step = step(&numbers, length, rate, agree);
        let rows = step.as_ref().map_or(MAX_ROWS, |step| step.rows);
        self.evaluations += evaluations(rows);
        step
    }

    /// The time until a limit, shorter than that of a step that converged and leads past it: by
    /// bisection, on the near side. `None` if steps do not converge.
    fn time_to_limit(&mut self, controls: &Controls, length: f64) -> Option<f64> {
        // A shorter step converges too, but for rounding.
        let tolerance = BISECTION_TOLERANCE * self.tolerance;
        let (mut low, mut high) = (0.0, length);
        for _ in 0..LIMIT_HALVINGS {
            let middle = 0.5 * (low + high);
            let step = self.try_step(controls, middle, tolerance)?;
            if self.is_within_limits(&step) {
                low = middle;
            } else {
                high = middle;
            }
        }
        // Only a limit at the very start leaves nothing.
        Some(if low > 0.0 { low } else { high })
    }

    /// Takes a step, and adds up its error.
    fn accept(&mut self, length: f64, step: &Step<NUMBERS>) {
        let mut end = State::of_numbers(&step.end);
        let difference =
            |range: Range<usize>| step.difference[range].iter().copied().fold(0.0, f64::max);
        self.error.axes += difference(AXES) / largest(&end.frame);
        self.error.place += difference(PLACE) / end.place.yzw().length();
        self.error.norm += (minkowski(end.frame.x_axis, end.frame.x_axis) + 1.0).abs();
        end.place.x += self.state.place.x;
        end.frame = orthonormal(&end.frame);
        self.state = end;
        self.proper_time += length;
    }
}

fn step_radius(kerr: Kerr, step: &Step<NUMBERS>) -> f64 {
    let [x, y, z] = [1, 2, 3].map(|i| step.end[i]);
    Place::new(kerr, DVec3::new(x, y, z)).r
}
