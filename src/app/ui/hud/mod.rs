//! The head-up display: texts over the picture's edges.
//!
//! Each part has a wish where the [layout](super::layout) places it: the title of a scene in the upper
//! left corner, the physics that is switched off at the top, the read-outs in the lower left corner, the
//! keys in the lower right corner, the toast at the bottom, a journey's captions above it, and a
//! comparison's labels beside its divider. At the ship's controls its instruments take the place of the
//! read-outs, and these and the map have places of their own. The read-outs and the keys disappear while
//! nothing happens.

mod board;
mod comparison;
mod journey;
mod key_hints;
mod physics_off;
mod presence;
mod question_field;
mod read_outs;
mod ship;
mod stop;
mod title;
mod toast;

pub use comparison::differences;
pub use physics_off::physics_off;
pub use read_outs::{ReadOut, read_outs};
pub use ship::{
    Instrument, PathLine, PilotNeeds, PilotPlaces, Wanted, instruments, map_half_width, most_rows,
    outside_horizon, pilot_places, wanted,
};

use crate::app::ui::layout::Importance;
use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<ship::PlacesNow>()
        .add_plugins((presence::plugin, key_hints::plugin, ship::path_plugin))
        .add_systems(
            EguiPrimaryContextPass,
            (
                journey::show_journey.in_set(Importance::Words),
                stop::show_stop.in_set(Importance::Cards),
                ship::show_question.in_set(Importance::Cards),
                (read_outs::show_read_outs, ship::show_instruments).in_set(Importance::Instruments),
                ship::show_mission.in_set(Importance::Words),
                toast::show_toast.in_set(Importance::Message),
                physics_off::show_physics_off.in_set(Importance::Warning),
                comparison::show_comparison.in_set(Importance::Sides),
                ship::show_map.in_set(Importance::Map),
                (ship::show_markers, ship::show_path)
                    .chain()
                    .in_set(Importance::Guides),
                title::show_title.in_set(Importance::Title),
                key_hints::show_key_hints.in_set(Importance::KeyHints),
            ),
        );
}
