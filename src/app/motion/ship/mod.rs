//! The ship: its controls in the pilot's hands, its motion frame by frame, and what it says.
//!
//! The ship is moved in f64 by `optics/ship`, and written into the scene as an observer and a camera
//! that looks along its nose. So everything that draws a scene draws what its pilot sees.

mod commands;
mod flown;
mod frame;
mod nose;
mod pace;
mod ship_flight;
mod stick;
mod words;

pub(super) use commands::advance_ship;
pub(crate) use flown::tide_of;
pub use flown::{Flown, Records};
pub use frame::{News, ShipFrame};
pub use nose::{HEADINGS, Nose};
pub use pace::{Engine, own_time_rate};
pub use ship_flight::{HoldKind, ShipFlight};
pub use stick::Stick;
pub(crate) use words::heading_words;

use bevy::prelude::*;

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<ShipFlight>().add_systems(
        Update,
        (
            commands::take_controls,
            commands::apply_ship_commands,
            advance_ship,
        )
            .chain()
            .after(super::pilot::grab_mouse)
            .after(crate::app::input::touch::read_fingers),
    );
}
