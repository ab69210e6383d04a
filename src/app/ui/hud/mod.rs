//! The head-up display: what lies over the picture's edges while nothing else is open.
//!
//! Each part has its place: the title of a scene in the upper left corner, what is switched off in
//! the physics at the top, the read-outs in the lower left corner, the keys in the lower right one,
//! the toast at the bottom, a journey's captions above it, and the words of a comparison beside its
//! divider. The read-outs and the keys go away while nothing happens.

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
