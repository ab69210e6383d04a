//! The diffuse light of the Milky Way, as the map that `lightfall-galaxy` has computed: the light of
//! stars and of nebulae.

pub mod asset;
mod map;
pub mod nebular;
mod photograph;

pub use map::MilkyWay;
