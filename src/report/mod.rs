//! Reports: what was computed, in forms that other programs read.

pub mod error;
pub mod inspection;
pub mod rays;
