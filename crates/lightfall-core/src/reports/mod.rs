//! Reports: what was computed, in forms that other programs read.

pub mod bench;
pub mod extremes;
pub mod inspection;
pub mod rays;
pub mod steps;
