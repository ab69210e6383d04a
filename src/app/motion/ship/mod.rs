//! The ship: its controls in the pilot's hands, its motion frame by frame, and what it says.
//!
//! The ship is moved in f64 by `optics/ship`, and written into the scene as an observer and a camera
//! that looks where its pilot does. So everything that draws a scene draws what its pilot sees.

mod aboard;
#[cfg(feature = "sound")]
mod cockpit;
mod commands;
mod flown;
mod frame;
mod head;
mod mission_play;
mod mission_words;
mod nose;
mod pace;
mod quantity_words;
mod score;
mod ship_flight;
mod ship_state;
mod stick;
mod track;
mod words;

pub(super) use commands::advance_ship;
pub use flown::Flown;
pub(crate) use frame::LITTLE_FUEL;
pub use frame::{News, ShipFrame};
pub(crate) use mission_play::MissionPlay;
pub use nose::Nose;
pub use pace::{Engine, own_time_rate};
pub(crate) use quantity_words::{Measures, acceleration, fuel, quantity_name, tide};
pub use score::{lamps, solution_time};
pub use ship_flight::{HoldKind, ShipFlight};
pub use stick::Stick;
pub use track::Track;
pub(crate) use words::{heading_words, multiple};

use bevy::prelude::*;

pub(crate) fn plugin(app: &mut App) {
    #[cfg(feature = "sound")]
    app.add_plugins(cockpit::plugin);
    app.init_resource::<ShipFlight>()
        .init_resource::<MissionPlay>()
        .init_resource::<mission_play::SolutionTimes>()
        .add_systems(
            Update,
            (
                commands::take_controls,
                mission_play::start_missions,
                commands::apply_ship_commands,
                advance_ship,
                mission_play::watch_mission,
            )
                .chain()
                .after(super::pilot::grab_mouse)
                .after(crate::app::input::touch::read_fingers),
        );
}
