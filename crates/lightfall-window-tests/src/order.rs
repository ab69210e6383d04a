//! What a test asks of the watched program and no user can.

use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// An order.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Order {
    /// Show the scene of this preset, a TOML text.
    Show(String),
    /// Let so many seconds pass in every frame, however long it takes: how far a held key moves the
    /// camera then depends on the number of frames alone.
    Step(f64),
    /// Show texts and panels at this multiple of their usual size.
    TextSize(f32),
    /// Let every frame take at least so many seconds.
    Slow(f64),
    /// Destroy the graphics device.
    LoseDevice,
    /// Connect a gamepad, or disconnect it.
    Connect(bool),
    /// Let the finger with this number do this at a place of the window, in points.
    Touch(u64, Stroke, [f32; 2]),
    /// Drop this file on the window.
    Drop(PathBuf),
    /// Push a part of the gamepad this far.
    Push(Pad, f32),
    /// Keep the window's picture, and compare the frames after the key for more light with it.
    KeepPicture,
}

/// What a finger does.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Stroke {
    Down,
    Move,
    Up,
}

/// A part of the gamepad.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names are Bevy's")]
pub enum Pad {
    LeftStickY,
    RightStickX,
    South,
    East,
    North,
    DPadLeft,
    DPadRight,
    Start,
    RightTrigger,
    RightTrigger2,
}
