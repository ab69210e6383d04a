//! The control that waits for its new key or button.

use bevy::prelude::Resource;

/// The control that waits, by name. While one waits, keyboard and gamepad do nothing else.
#[derive(Resource, Default)]
pub(crate) struct Rebinding(pub(crate) Option<&'static str>);
