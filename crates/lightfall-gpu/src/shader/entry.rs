//! The entry points of shaders.

use crate::stars::StarKernel;
use std::slice::from_ref;

/// The entry points of the kernels of stars.
const KERNELS: &[&str] = &StarKernel::WORDS;

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
    /// What reaches the camera through matter with depth, for single rays: entry point `passages`.
    Passages {
        /// Whether structure is filtered by the distance to the next pixels' rays. Otherwise a ray
        /// sees points, as its twin in f64 does.
        filters: bool,
    },
    /// A kernel of point stars: its own entry point.
    Star(StarKernel),
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
            Self::Passages { .. } => &["passages"],
            Self::Star(kernel) => from_ref(&KERNELS[kernel as usize]),
        }
    }
}
