//! Interpolation between Chebyshev's nodes.

use std::f64::consts::PI;

/// Chebyshev's nodes of the first kind on [0, 1], and the weights of the polynomial through values
/// there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chebyshev<const COUNT: usize> {
    /// The nodes sin^2(pi (k + 1/2) / (2 COUNT)), in growing order.
    pub nodes: [f64; COUNT],
    weights: [f64; COUNT],
}

impl<const COUNT: usize> Chebyshev<COUNT> {
    /// The nodes and their weights, (-1)^k sin(pi (k + 1/2) / COUNT).
    pub fn new() -> Self {
        let angle = |k: usize| PI * (k as f64 + 0.5) / COUNT as f64;
        Self {
            nodes: std::array::from_fn(|k| (0.5 * angle(k)).sin().powi(2)),
            weights: std::array::from_fn(|k| {
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                sign * angle(k).sin()
            }),
        }
    }

    /// The share that the value at each node has in the polynomial's value at `place`. Lagrange's
    /// polynomials in barycentric form, Berrut & Trefethen 2004 eqs. 4.2 and 5.3.
    pub fn shares(&self, place: f64) -> [f64; COUNT] {
        if let Some(met) = self.nodes.iter().position(|&node| node == place) {
            return std::array::from_fn(|k| f64::from(u8::from(k == met)));
        }
        let terms: [f64; COUNT] =
            std::array::from_fn(|k| self.weights[k] / (place - self.nodes[k]));
        let sum: f64 = terms.iter().sum();
        terms.map(|term| term / sum)
    }

    /// The value at `place` of the polynomial through `values` at the nodes.
    pub fn value(&self, values: &[f64; COUNT], place: f64) -> f64 {
        let shares = self.shares(place);
        shares.iter().zip(values).map(|(a, b)| a * b).sum()
    }
}

impl<const COUNT: usize> Default for Chebyshev<COUNT> {
    fn default() -> Self {
        Self::new()
    }
}
