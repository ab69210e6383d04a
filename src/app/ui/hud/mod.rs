//! The head-up display: texts over the picture's edges.
//!
//! Each part has its place: the title of a scene in the upper left corner, the physics that is switched
//! off at the top, the read-outs in the lower left corner, the keys in the lower right corner, the
//! toast at the bottom, a journey's captions above it, and a comparison's labels beside its divider.
//! The read-outs and the keys disappear while nothing happens.

mod board;
mod comparison;
mod journey;
mod key_hints;
mod physics_off;
mod presence;
mod read_outs;
mod title;
mod toast;

pub use comparison::differences;
pub use physics_off::physics_off;
pub use read_outs::{ReadOut, read_outs};

use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<title::TitleBox>()
        .init_resource::<read_outs::ReadOutsWidth>()
        .add_plugins((presence::plugin, key_hints::plugin))
        .add_systems(
            EguiPrimaryContextPass,
            (
                (title::show_title, physics_off::show_physics_off).chain(),
                read_outs::show_read_outs,
                key_hints::show_key_hints,
                toast::show_toast,
                journey::show_journey,
                comparison::show_comparison,
            ),
        );
}
