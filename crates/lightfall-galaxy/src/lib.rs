//! Computes the map of the Milky Way, which the program reads as an asset: the light of the stars
//! of a galaxy like ours, seen through its dust from the Sun's place in it, and that of nebulae.
//!
//! The disk, its arms and the bulge have the measures of the real ones; the great clouds of dust
//! near the Sun and the nebulae are in their places; all smaller structure is random. So the map has the
//! brightness, the colours and the dark lanes of the Milky Way, but not each of its clouds.

mod clouds;
mod dust;
mod galaxy;
mod nebulae;
mod neighbours;
mod sight;
mod texels;
mod turbulence;

pub use sight::light_from;
pub use texels::{texel, write};
