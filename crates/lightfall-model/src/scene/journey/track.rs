//! One quantity along a journey.

use super::ease::Ease;

/// A function of time through given points: piecewise cubic, monotone where the points are monotone, and
/// constant before the first point and after the last. Its slope is continuous where every stretch is
/// smooth.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    knots: Vec<Knot>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    time: f64,
    value: f64,
    /// The slope before it.
    arrives: f64,
    /// The slope after it.
    leaves: f64,
    /// Whether the value stays until the next knot.
    holds: bool,
}

impl Track {
    /// The smooth track through these points (time, value), whose times increase, at rest at both ends;
    /// none without a point.
    pub fn through(points: &[(f64, f64)]) -> Option<Self> {
        Self::eased(points, |_| Ease::Smooth)
    }

    /// As [`Track::through`], with each stretch as the ease at its first point says.
    pub fn eased(points: &[(f64, f64)], ease: impl Fn(usize) -> Ease) -> Option<Self> {
        Self::with_ends(points, ease, |_| 0.0)
    }

    /// As [`Track::through`], but moving at both ends as between the points there: a camera path that
    /// another program drew need not rest.
    pub fn along(points: &[(f64, f64)]) -> Option<Self> {
        Self::with_ends(points, |_| Ease::Smooth, |secant| secant)
    }

    /// The track through points. `end` gives the slope at an end from that of the stretch there.
    ///
    /// The slope at a point between two smooth stretches is the harmonic mean of the slopes on both sides,
    /// weighted by their lengths, and zero where these differ in sign (Fritsch & Butland 1984). Beside
    /// another stretch it is that stretch's own, as far as the smooth one stays monotone.
    fn with_ends(
        points: &[(f64, f64)],
        ease: impl Fn(usize) -> Ease,
        end: impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let last = points.len().checked_sub(1)?;
        let secant = |i: usize| (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0);
        let own = |i: usize| ease(i).slopes(secant(i));
        let mean = |i: usize| {
            let (before, after) = (secant(i - 1), secant(i));
            if before * after <= 0.0 {
                return 0.0;
            }
            let (left, right) = (points[i].0 - points[i - 1].0, points[i + 1].0 - points[i].0);
            let (w1, w2) = (2.0 * right + left, right + 2.0 * left);
            (w1 + w2) / (w1 / before + w2 / after)
        };
        // The slope before a point, of the stretch from the point before.
        let arrives = |i: usize| match i.checked_sub(1) {
            None => 0.0,
            Some(before) => match own(before) {
                Some([_, slope]) => slope,
                None if i == last => end(secant(before)),
                None => match own(i) {
                    Some([slope, _]) => monotone(slope, secant(before)),
                    None => mean(i),
                },
            },
        };
        let leaves = |i: usize| {
            if i == last {
                return 0.0;
            }
            match own(i) {
                Some([slope, _]) => slope,
                None => match i.checked_sub(1).map(&own) {
                    None => end(secant(i)),
                    Some(Some([_, slope])) => monotone(slope, secant(i)),
                    Some(None) => mean(i),
                },
            }
        };
        let knot = |(i, &(time, value)): (usize, &(f64, f64))| Knot {
            time,
            value,
            arrives: arrives(i),
            leaves: leaves(i),
            holds: ease(i) == Ease::Hold,
        };
        Some(Self {
            knots: points.iter().enumerate().map(knot).collect(),
        })
    }

    /// The value at a time.
    pub fn at(&self, time: f64) -> f64 {
        let after = self.knots.partition_point(|knot| knot.time <= time);
        let Some(end) = self.knots.get(after) else {
            return self.knots[self.knots.len() - 1].value;
        };
        let Some(start) = after.checked_sub(1).map(|before| self.knots[before]) else {
            return end.value;
        };
        if start.holds {
            return start.value;
        }
        // Cubic Hermite.
        let length = end.time - start.time;
        let t = (time - start.time) / length;
        let rest = 1.0 - t;
        start.value * (1.0 + 2.0 * t) * rest * rest
            + end.value * (1.0 + 2.0 * rest) * t * t
            + length * t * rest * (start.leaves * rest - end.arrives * t)
    }
}

/// A slope at the end of a cubic whose mean slope is `secant`, limited so that the cubic stays monotone:
/// up to three times the mean (de Boor & Swartz 1977), and zero where the signs differ.
fn monotone(slope: f64, secant: f64) -> f64 {
    if slope * secant <= 0.0 {
        0.0
    } else {
        slope.signum() * slope.abs().min(3.0 * secant.abs())
    }
}
