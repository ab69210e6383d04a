//! How far the picture of the present scene is drawn.

use bevy::prelude::*;

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
