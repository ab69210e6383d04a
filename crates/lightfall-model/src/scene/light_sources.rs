//! Light sources: what the disk's light is made of, and the skies.

use super::Sky;

crate::words! {
    /// Radial profile of the disk's flux.
    pub enum DiskModel {
        /// The thin disk of Newtonian gravity.
        Newtonian = "newtonian": "Newtonian",
        /// The thin disk around a spinning hole, after Page and Thorne 1974.
        PageThorne = "page-thorne": "Relativistic",
    }
}

crate::words! {
    /// Structure of the disk's light.
    pub enum DiskStructure {
        /// A smooth disk, on which nothing moves.
        None = "none": "None",
        /// Filaments that the rotation shears into trailing spirals.
        Turbulent = "turbulent": "Turbulent",
        /// Longer filaments with more contrast, as in films.
        Streaks = "streaks": "Streaks",
    }
}

crate::words! {
    /// How the brightness of the disk's surface depends on the angle at which it is seen.
    pub enum LimbDarkening {
        /// As bright from the side as from above.
        None = "none": "None",
        /// Darker from the side, as light scattered on electrons is; Chandrasekhar 1960.
        ElectronScattering = "electron-scattering": "Scattering",
    }
}

crate::words! {
    /// A hot spot in the disk.
    pub enum HotSpotKind {
        /// No hot spot.
        None = "none": "None",
        /// All of it goes round as fast as its middle.
        Rigid = "rigid": "Keeps its shape",
        /// The rotation draws it out into an arc.
        Sheared = "sheared": "Sheared",
    }
}

crate::words! {
    /// What is drawn at infinity.
    pub enum SkyMode {
        /// The stars and the Milky Way as seen from Earth.
        Stars = "stars": "Stars",
        /// Stars at random places, stretched by the bending.
        Procedural = "procedural": "The article's stars",
        /// Lines of celestial latitude and longitude.
        Grid = "grid": "Grid",
        /// A picture of the whole sky, from a file.
        Picture = "picture": "Picture",
        /// A black sky.
        Off = "off": "Off",
    }
}

crate::words! {
    /// The axes on which a picture of the sky is drawn.
    pub enum SkyFrame {
        /// Right ascension and declination (J2000).
        Equatorial = "equatorial": "Equatorial",
        /// Galactic longitude and latitude.
        Galactic = "galactic": "Galactic",
    }
}

impl SkyMode {
    /// Whether it stands still in the hole's frame, so that directions have to be turned to that
    /// frame behind a tilted disk. The others have a frame of their own, the celestial one.
    pub fn lies_in_hole_frame(self) -> bool {
        matches!(self, Self::Procedural | Self::Grid)
    }

    /// Whether it is a map on celestial axes: the Milky Way, or a picture from a file. The fields
    /// that turn the sky turn it, and its light is filtered over the footprint of a ray.
    pub fn is_map(self) -> bool {
        matches!(self, Self::Stars | Self::Picture)
    }
}

impl Sky {
    /// Whether stars of the catalogue, and fainter ones, are drawn as points.
    pub fn has_star_points(&self) -> bool {
        match self.mode {
            SkyMode::Stars => true,
            SkyMode::Picture => self.stars,
            SkyMode::Procedural | SkyMode::Grid | SkyMode::Off => false,
        }
    }

    /// Whether there are stars, of either kind.
    pub fn has_stars(&self) -> bool {
        self.mode == SkyMode::Procedural || self.has_star_points()
    }
}
