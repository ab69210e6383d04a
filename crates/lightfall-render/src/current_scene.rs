//! The scene that the passes draw.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use glam::DMat3;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Frame;

/// The scene that is being drawn.
#[derive(Resource, Clone, Deref, ExtractResource, PartialEq)]
pub struct CurrentScene(pub Drawable);

impl CurrentScene {
    /// Turns the camera at its place to these axes (right, up, forward) on the observer's axes.
    pub fn turn(&mut self, axes: DMat3) {
        let mut turned = self.0.scene().clone();
        turned.camera.set_orientation(axes);
        // A camera that is turned at its place can be drawn as before.
        if let Ok(turned) = Drawable::new(turned) {
            self.0 = turned;
        }
    }

    /// Shows the scene in this frame.
    pub fn show_in(&mut self, frame: &Frame) {
        self.0 = self.0.shown_in(frame);
    }
}
