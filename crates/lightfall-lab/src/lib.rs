//! Reports: measurements and traces in forms that people and other programs read.

pub mod bench;
pub mod circumstances;
pub mod export;
pub mod extremes;
pub mod import;
pub mod medium;
pub mod table;
pub mod work;
