//! The scene that the passes draw.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::Drawable;

/// The scene that is being drawn.
#[derive(Resource, Clone, Deref, ExtractResource)]
pub struct CurrentScene(pub Drawable);
