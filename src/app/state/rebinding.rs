//! The control that waits for its new key or button.

use bevy::prelude::Resource;

/// The control that waits, by name. While one waits, keyboard and gamepad do nothing else.
#[derive(Resource, Default)]
pub(crate) struct Rebinding(Option<&'static str>);

impl Rebinding {
    /// Whether a control waits.
    pub(crate) fn is_waiting(&self) -> bool {
        self.0.is_some()
    }

    /// The control that waits.
    pub(crate) fn control(&self) -> Option<&'static str> {
        self.0
    }

    /// Lets a control wait.
    pub(crate) fn start(&mut self, control: &'static str) {
        self.0 = Some(control);
    }

    /// Lets no control wait.
    pub(crate) fn stop(&mut self) {
        self.0 = None;
    }
}
