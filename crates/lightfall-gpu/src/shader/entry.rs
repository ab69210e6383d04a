//! The entry points of shaders.

/// What a shader answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entry {
    /// The light of a pixel: entry points `vertex` and `fragment`.
    Picture,
    /// The light of the pixels at edges, each from many rays: entry point `refine`.
    Refine,
    /// Records of rays: entry point `rays`.
    Rays,
    /// One vector per pixel, for timing: entry points `timed`, `vertex` and `fragment`.
    Timed,
    /// The light of each pixel from a compute entry, for timing: entry point `timed`.
    TimedLight,
    /// The images of stars, found by inversion: entry point `solve`.
    Stars,
    /// The rays of the mesh that finds images without an inversion: entry point `trace_mesh`.
    StarMesh,
    /// The images of candidates in smooth cells, by interpolation: entry point `interpolate`.
    StarInterpolation,
    /// The images of the other candidates, by rays: entry point `refine_image`.
    StarRefinement,
    /// The dimming of images behind the disk: entry point `dim`.
    StarDimming,
}

impl Entry {
    /// The names of the shader's entry points, in their order.
    pub fn points(self) -> &'static [&'static str] {
        match self {
            Self::Picture => &["vertex", "fragment"],
            Self::Refine => &["refine"],
            Self::Rays => &["rays"],
            Self::Timed => &["vertex", "timed", "fragment"],
            Self::TimedLight => &["timed"],
            Self::Stars => &["solve"],
            Self::StarMesh => &["trace_mesh"],
            Self::StarInterpolation => &["interpolate"],
            Self::StarRefinement => &["refine_image"],
            Self::StarDimming => &["dim"],
        }
    }
}
