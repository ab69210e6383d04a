//! The components by which systems find the two cameras.

use bevy::prelude::*;
use bevy::render::extract_component::ExtractComponent;

/// Marks the camera that draws the scene.
#[derive(Component, Clone, Copy, ExtractComponent)]
pub struct SceneCamera;

/// Marks the camera that shows the picture in a window or an image.
#[derive(Component, Clone, Copy, ExtractComponent)]
pub struct ScreenCamera;
