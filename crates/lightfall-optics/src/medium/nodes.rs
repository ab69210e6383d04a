//! The nodes at which a chunk of a way is sampled.

use lightfall_model::geometry::quadrature::gauss_legendre;

/// Gauss-Legendre nodes on [0, 1], with what they say of the integral up to each of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// The places of the nodes, in growing order.
    pub places: Vec<f64>,
    /// The weights of the integral over the whole interval.
    pub weights: Vec<f64>,
    /// Row i has the weights of the integral from 0 to node i: those of the polynomial through the
    /// values at all nodes.
    pub partial: Vec<Vec<f64>>,
}

impl Nodes {
    /// The rule with `count` nodes.
    pub fn new(count: usize) -> Self {
        let (places, weights): (Vec<f64>, Vec<f64>) = gauss_legendre(count).into_iter().unzip();
        // The rule itself integrates the polynomials, whose degree is less than `count`, exactly.
        let partial = places.iter().map(|end| {
            let share = |j: usize| {
                let inner = places.iter().zip(&weights);
                let terms = inner.map(|(place, weight)| weight * lagrange(&places, j, end * place));
                end * terms.sum::<f64>()
            };
            (0..count).map(share).collect()
        });
        Self {
            partial: partial.collect(),
            places,
            weights,
        }
    }

    /// The number of nodes.
    pub fn count(&self) -> usize {
        self.places.len()
    }
}

/// Lagrange's polynomial that is 1 at `places[j]` and 0 at the others.
fn lagrange(places: &[f64], j: usize, x: f64) -> f64 {
    let others = places.iter().enumerate().filter(|(k, _)| *k != j);
    others
        .map(|(_, place)| (x - place) / (places[j] - place))
        .product()
}
