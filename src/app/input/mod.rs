pub(crate) mod gamepad;
pub(crate) mod key_feedback;
pub(crate) mod keyboard;
