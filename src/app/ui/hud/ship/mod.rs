//! What the ship's pilot sees: instruments, and marks of where the ship moves to.

mod dial;
mod instruments;
mod map;
mod markers;
mod mission;
mod question;
mod values;

pub(super) use instruments::show_instruments;
pub(super) use map::show_map;
pub(super) use markers::show_markers;
pub(super) use mission::show_mission;
pub(super) use question::show_question;
pub use values::{Instrument, instruments};
