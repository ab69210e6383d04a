//! The diffuse light of the Milky Way: the stars of a galaxy like ours, seen through its dust from
//! the Sun's place in it. The disk, its arms and the bulge have the measures of the real ones; the
//! great clouds of dust near the Sun are in their places; all smaller structure is random. So it
//! has the brightness, the colours and the lanes of the Milky Way, but not its every cloud.

pub mod asset;
mod clouds;
mod dust;
mod galaxy;
mod map;
mod neighbours;
mod sight;
mod turbulence;

pub use map::MilkyWay;
pub use sight::light_from;
