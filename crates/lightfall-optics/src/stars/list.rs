//! The stars of a sky as the picture needs them: one list, brightest first.

use super::catalogue::Catalogue;
use super::faint::fainter_stars;
use super::photometry::Star;

/// The faintest V that a list goes to: 0.9 million stars.
pub const MAX_MAGNITUDE: f64 = 11.0;

/// The stars down to a magnitude, brightest first.
#[derive(Clone, Debug, PartialEq)]
pub struct StarList {
    stars: Vec<Star>,
    faintest: f64,
}

impl StarList {
    /// The stars of `catalogue` down to `faintest` V, and, beyond V = 6, those that it lacks, at
    /// places that `seed` decides. A list that goes deeper has the same stars and more. Beyond
    /// [`MAX_MAGNITUDE`] there are no stars.
    pub fn new(catalogue: &Catalogue, seed: u32, faintest: f64) -> Self {
        let faintest = faintest.min(MAX_MAGNITUDE);
        let mut stars = catalogue.stars()[..catalogue.count(faintest)].to_vec();
        stars.extend(fainter_stars(catalogue, seed, faintest));
        stars.sort_by(|a, b| a.magnitude.total_cmp(&b.magnitude));
        Self { stars, faintest }
    }

    /// The stars, brightest first.
    pub fn stars(&self) -> &[Star] {
        &self.stars
    }

    /// The V that the list goes to.
    pub fn faintest(&self) -> f64 {
        self.faintest
    }
}
