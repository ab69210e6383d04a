//! The layers of the picture's light that are drawn.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::Layers;

/// The layers of the current scene that are drawn, each with its share of every pixel in alpha. While
/// there are `None`, the picture's own shader draws all light. It has a meaning for the view `colour`
/// alone.
#[derive(Resource, Clone, Copy, Debug, Default, ExtractResource, PartialEq)]
pub struct DrawnLayers(pub Option<Layers>);
