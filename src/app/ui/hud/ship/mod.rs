//! What the ship's pilot sees: instruments, marks of where the ship moves to, and the path ahead.

mod dial;
mod instruments;
mod map;
mod map_view;
mod markers;
mod mission;
mod needed;
mod path_line;
mod places;
mod quantities;
mod question;
mod values;

pub(super) use instruments::show_instruments;
pub(super) use map::show_map;
pub use map_view::{map_half_width, outside_horizon};
pub(super) use markers::show_markers;
pub(super) use mission::show_mission;
pub use needed::most_rows;
pub use path_line::PathLine;
pub(super) use path_line::{path_plugin, show_path};
pub(super) use places::PlacesNow;
pub use places::{PilotNeeds, PilotPlaces, pilot_places};
pub use quantities::{Wanted, wanted};
pub(super) use question::show_question;
pub use values::{Instrument, instruments};
