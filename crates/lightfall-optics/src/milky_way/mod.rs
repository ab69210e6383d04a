//! The diffuse light of the Milky Way, as the map that `lightfall-galaxy` has computed.

pub mod asset;
mod map;

pub use map::MilkyWay;
