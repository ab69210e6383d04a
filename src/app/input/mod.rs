//! Keyboard, gamepads, mouse and fingers: what is pressed, and whom it belongs to.

pub(crate) mod begin;
pub(crate) mod clicks;
pub(crate) mod gamepad;
pub(crate) mod gestures;
pub(crate) mod hands;
pub(crate) mod held;
pub(crate) mod key_modifiers;
pub(crate) mod keyboard;
pub(crate) mod layout;
pub(crate) mod pointer;
mod second_press;
pub(crate) mod touch;
pub(crate) mod typing;
pub(crate) mod visitor;
