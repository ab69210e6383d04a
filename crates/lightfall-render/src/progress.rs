//! How far the picture of the present scene is drawn.

use bevy::prelude::*;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// How far the picture of the present scene is drawn. `wake_scene_camera` writes it once a frame;
/// the program and its tests read it.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Progress {
    /// The scene's shaders are compiled. The screen shows the last picture, if there is one.
    #[default]
    Compiling,
    /// The shaders exist, and no frame is known to have drawn the scene.
    Rough,
    /// The screen shows the scene, and this many frames of its picture are drawn.
    Averaging(u32),
    /// All of the picture is drawn.
    Done,
}

impl Progress {
    /// Whether the screen shows the scene, at this or another time of the disk.
    #[must_use]
    pub fn is_shown(self) -> bool {
        matches!(self, Self::Averaging(_) | Self::Done)
    }
}

/// What the passes have drawn in the present frame.
#[derive(Resource, Default)]
pub(super) struct DrawnFrame {
    /// Whether the scenes on the GPU are the present ones.
    pub(super) is_present: bool,
    /// Whether the scenes on the GPU are drawn.
    pub(super) is_drawn: bool,
    /// Whether the frame is added to the mean.
    pub(super) is_added: bool,
}

impl DrawnFrame {
    /// Whether the present scenes are drawn.
    pub(super) fn shows_scene(&self) -> bool {
        self.is_present && self.is_drawn
    }
}

/// What the frames so far have drawn, for a request of this number.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Drawn {
    pub(super) request: u64,
    /// The look of the last scene that a frame has drawn.
    pub(super) look: Option<u64>,
    /// Whether a frame has drawn all of the request, with whatever number of rays.
    pub(super) begun: bool,
    /// How many frames in a row have drawn all of it before the first one that counts.
    pub(super) in_a_row: u32,
    /// How many frames count.
    pub(super) frames: u32,
    /// Whether there is a picture, of this or an earlier request.
    pub(super) has_picture: bool,
}

/// What is drawn, as the render world writes it and both worlds read it.
#[derive(Clone, Default)]
pub(super) struct SharedDrawn(Arc<Mutex<Drawn>>);

impl SharedDrawn {
    pub(super) fn lock(&self) -> MutexGuard<'_, Drawn> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
