//! The shader of the current scene: which parts it is joined from, and whether its pipeline exists.

use crate::render::chain::Chain;
use crate::render::current_scene::CurrentScene;
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::Variant;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The shader that the current scene needs. The main world writes it, since shader assets live
/// there.
#[derive(Resource, Clone, ExtractResource)]
pub(in crate::render) struct GeodesicShader {
    variant: Variant,
    /// Samples per pixel, which are part of a pipeline.
    pub(super) samples: u32,
    pub(super) shader: Handle<Shader>,
    /// Whether its pipeline exists; shared by the main and the render world.
    ready: Arc<AtomicBool>,
}

impl GeodesicShader {
    /// Whether its pipeline exists.
    pub(in crate::render) fn is_ready(&self) -> bool {
        self.ready.load(Ordering::Acquire)
    }

    pub(super) fn set_ready(&self, ready: bool) {
        self.ready.store(ready, Ordering::Release);
    }
}

/// The shaders joined so far, the most recently used last, so that going back to one costs nothing.
#[derive(Resource, Default)]
pub(in crate::render) struct JoinedShaders(Vec<GeodesicShader>);

/// Maximum number of shaders that are kept, each with a compiled pipeline: more than a user reaches
/// in a while with keys and presets.
const MAX_SHADERS: usize = 48;

/// Selects the shader of the current scene. A new variant is joined from its parts; once there are
/// [`MAX_SHADERS`], it replaces the shader that has been unused for the longest time.
pub(in crate::render) fn select_geodesic_shader(
    mut commands: Commands,
    scene: Res<CurrentScene>,
    mut joined: ResMut<JoinedShaders>,
    mut shaders: ResMut<Assets<Shader>>,
) {
    let (variant, samples) = (Variant::picture(&scene), Chain::of(&scene).samples);
    let JoinedShaders(joined) = &mut *joined;
    let known = joined
        .iter()
        .position(|known| known.variant == variant && known.samples == samples);
    let selected = match known {
        Some(index) => joined.remove(index),
        None => {
            let source = Shader::from_wgsl(variant.source(), "lightfall/geodesic.wgsl");
            let shader = if joined.len() < MAX_SHADERS {
                shaders.add(source)
            } else {
                let GeodesicShader { shader, .. } = joined.remove(0);
                if let Err(error) = shaders.insert(shader.id(), source) {
                    error!("a shader could not be replaced: {error}");
                }
                shader
            };
            GeodesicShader {
                variant,
                samples,
                shader,
                ready: default(),
            }
        }
    };
    joined.push(selected.clone());
    commands.insert_resource(selected);
}
