//! The layers of the picture's light that are drawn.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::Layers;

/// The layers of the current scene that are drawn, with their share of each pixel in alpha. If it is
/// `None`, the picture's own shader draws all light. Only the view `colour` has layers.
#[derive(Resource, Clone, Copy, Debug, Default, ExtractResource, PartialEq)]
pub struct DrawnLayers(pub Option<Layers>);
