//! What the ship's pilot sees: instruments, and marks of where the ship moves to.

mod dial;
mod instruments;
mod markers;
mod values;

pub(super) use instruments::show_instruments;
pub(super) use markers::show_markers;
pub use values::{Instrument, instruments};
