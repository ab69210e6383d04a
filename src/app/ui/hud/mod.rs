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

pub(crate) fn plugin(app: &mut App) {
    app.add_plugins((
        presence::plugin,
        title::plugin,
        physics_off::plugin,
        read_outs::plugin,
        key_hints::plugin,
        toast::plugin,
        journey::plugin,
        comparison::plugin,
    ));
}
