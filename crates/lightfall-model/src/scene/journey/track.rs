//! One quantity along a journey.

/// A function of time through given points: piecewise cubic with a continuous slope, monotone where
/// the points are monotone, and constant before the first point and after the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    knots: Vec<Knot>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    time: f64,
    value: f64,
    slope: f64,
}

impl Track {
    /// The track through these points (time, value), whose times increase; none without a point.
    ///
    /// The slope at an inner point is the harmonic mean of the slopes on both sides, weighted by
    /// their lengths, and zero where these differ in sign (Fritsch & Butland 1984).
    pub fn through(points: &[(f64, f64)]) -> Option<Self> {
        let secant = |i: usize| (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0);
        let slope = |i: usize| {
            if i == 0 || i + 1 == points.len() {
                return 0.0;
            }
            let (before, after) = (secant(i - 1), secant(i));
            if before * after <= 0.0 {
                return 0.0;
            }
            let (left, right) = (points[i].0 - points[i - 1].0, points[i + 1].0 - points[i].0);
            let (w1, w2) = (2.0 * right + left, right + 2.0 * left);
            (w1 + w2) / (w1 / before + w2 / after)
        };
        let knot = |(i, &(time, value)): (usize, &(f64, f64))| Knot {
            time,
            value,
            slope: slope(i),
        };
        (!points.is_empty()).then(|| Self {
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
        // Cubic Hermite.
        let length = end.time - start.time;
        let t = (time - start.time) / length;
        let rest = 1.0 - t;
        start.value * (1.0 + 2.0 * t) * rest * rest
            + end.value * (1.0 + 2.0 * rest) * t * t
            + length * t * rest * (start.slope * rest - end.slope * t)
    }
}
