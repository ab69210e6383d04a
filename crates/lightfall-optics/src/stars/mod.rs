//! The stars of the sky: a catalogue of bright ones, fainter ones that a seed decides, the turn of
//! the sky about the hole, and the images that a camera sees of them.
//!
//! Directions are J2000: x toward right ascension 0, z toward the celestial north pole. Light is in
//! the unit of [`crate::spectrum`]: flux is linear light times steradians.

mod catalogue;
mod counts;
mod depth;
mod faint;
mod frame;
pub mod images;
mod list;
mod photometry;

pub use catalogue::{Catalogue, CatalogueError, MAX_NAME_CHARS, MAX_STARS, NamedStar, StarFile};
pub use counts::{FAINTER_SHARE, number_brighter};
pub use depth::Depth;
pub use faint::FIRST_MAGNITUDE;
pub use frame::{celestial_direction, galactic_from_celestial, hole_from_celestial};
pub use list::{MAX_MAGNITUDE, StarList};
pub use photometry::{
    MAX_B_V, MIN_B_V, SOLAR_B_V, Star, ZERO_MAGNITUDE_FLUX, angular_radius, flux, luminance,
    temperature_from_b_v,
};
