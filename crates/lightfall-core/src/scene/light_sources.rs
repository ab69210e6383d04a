//! Light sources: the profiles of the disk's flux, and the skies.

crate::words! {
    /// Radial profile of the disk's flux.
    #[derive(Default)]
    pub enum DiskModel {
        /// F = (r_in/r)^3 (1 - sqrt(r_in/r)).
        #[default]
        Newtonian = "newtonian",
        /// Relativistic, around Kerr: Page & Thorne 1974, with the same peak.
        PageThorne = "page-thorne",
    }
}

crate::words! {
    /// What is drawn at infinity.
    #[derive(Default)]
    pub enum SkyMode {
        /// Stars at pseudo-random places, the same for the same seed.
        #[default]
        Stars = "stars",
        /// A celestial grid.
        Grid = "grid",
        /// Nothing: the sky is black.
        Off = "off",
    }
}

impl SkyMode {
    /// The mode after this one, in the order of declaration; after the last comes the first.
    #[must_use]
    pub fn next(self) -> Self {
        Self::ALL[(self as usize + 1) % Self::ALL.len()]
    }
}
