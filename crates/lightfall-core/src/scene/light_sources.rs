//! Light sources: what the disk's light is made of, and the skies.

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
    /// Structure of the disk's light.
    #[derive(Default)]
    pub enum DiskStructure {
        /// None: a smooth disk.
        #[default]
        None = "none",
        /// Turbulence, sheared into trailing spirals.
        Turbulent = "turbulent",
        /// The same drawn out along the orbits, with more contrast, as in films.
        Streaks = "streaks",
    }
}

crate::words! {
    /// How the brightness of the disk's surface depends on the angle at which it is seen.
    #[derive(Default)]
    pub enum LimbDarkening {
        /// It does not.
        #[default]
        None = "none",
        /// As that of an atmosphere that scatters light on electrons: Chandrasekhar 1960.
        ElectronScattering = "electron-scattering",
    }
}

crate::words! {
    /// A hot spot in the disk.
    #[derive(Default)]
    pub enum HotSpotKind {
        /// None.
        #[default]
        None = "none",
        /// One that keeps its shape: all of it has the angular velocity of its middle.
        Rigid = "rigid",
        /// One that the disk's rotation draws out into an arc.
        Sheared = "sheared",
    }
}

crate::words! {
    /// What is drawn at infinity.
    #[derive(Default)]
    pub enum SkyMode {
        /// The stars of a catalogue, each image a point with its exact light, and the Milky Way.
        #[default]
        Stars = "stars",
        /// Stars at pseudo-random places, looked up by each pixel, as in the article.
        Procedural = "procedural",
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

    /// Whether it stands still in the hole's frame, so that directions have to be turned to that
    /// frame behind a tilted disk. The stars have a frame of their own, the celestial one.
    #[must_use]
    pub fn lies_in_hole_frame(self) -> bool {
        !matches!(self, Self::Stars | Self::Off)
    }

    /// Whether there are stars, of either kind.
    #[must_use]
    pub fn has_stars(self) -> bool {
        matches!(self, Self::Stars | Self::Procedural)
    }
}
