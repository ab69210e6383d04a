//! Truncated power series: values, products, roots.

/// Highest power. The cost of a step grows with the square of the order, and its length like
/// eps^(1/ORDER). The total cost is nearly constant between 18 and 26.
pub const ORDER: usize = 22;

/// Largest omitted term of a series, relative to the value of the series; well below rounding.
const TRUNCATION: f64 = 1e-18;

/// The series c_0 + c_1 t + ... + c_ORDER t^ORDER.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taylor(pub [f64; ORDER + 1]);

impl Taylor {
    /// Value and derivative at `t`.
    pub fn at(&self, t: f64) -> (f64, f64) {
        self.0.iter().rev().fold((0.0, 0.0), |(value, slope), &c| {
            (value * t + c, slope * t + value)
        })
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let mut slopes = [0.0; ORDER + 1];
        for (k, &c) in self.0.iter().enumerate().skip(1) {
            slopes[k - 1] = k as f64 * c;
        }
        Self(slopes)
    }

    /// The root of the series between 0 and `end`, where its values differ in sign or it vanishes
    /// at `end`: Newton's method, with a bisection where a step leaves the bracket.
    pub fn root(&self, end: f64) -> f64 {
        let rising = self.0[0] < 0.0;
        let (mut low, mut high) = (0.0, end);
        let mut t = 0.5 * end;
        // Newton's method takes about six iterations, bisection alone would take about sixty.
        for _ in 0..200 {
            let (value, slope) = self.at(t);
            if value == 0.0 {
                return t;
            }
            if (value < 0.0) == rising {
                low = t;
            } else {
                high = t;
            }
            let newton = t - value / slope;
            let next = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            if (next - t).abs() <= f64::EPSILON * t || next == low || next == high {
                return next;
            }
            t = next;
        }
        t
    }
}

/// The coefficient of t^k in the product of two series, of which at least the first k + 1
/// coefficients are given.
pub fn product_coefficient(left: &[f64], right: &[f64], k: usize) -> f64 {
    left[..=k]
        .iter()
        .zip(right[..=k].iter().rev())
        .map(|(l, r)| l * r)
        .sum()
}

/// The t at which the term `coefficient` t^`power` is negligible relative to `scale`.
pub fn reach_of_term(coefficient: f64, scale: f64, power: usize) -> f64 {
    if coefficient == 0.0 {
        f64::INFINITY
    } else {
        (TRUNCATION * scale.abs() / coefficient.abs()).powf(1.0 / power as f64)
    }
}
