//! The shaders of the current scene and of the pinned one: which parts each is joined from, and
//! whether its pipeline exists.

use super::pipeline::Destination;
use crate::render::chain::Chain;
use crate::render::comparison::ComparedScene;
use crate::render::current_scene::CurrentScene;
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::Variant;
use lightfall_core::scene::Scene;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The shaders that are needed now. The main world writes them, since shader assets live there.
#[derive(Resource, Clone, ExtractResource)]
pub(crate) struct GeodesicShaders {
    pub(super) current: JoinedShader,
    /// That of the pinned scene, while it is compared with the current one.
    pub(super) pinned: Option<JoinedShader>,
}

impl GeodesicShaders {
    /// Whether their pipelines exist.
    pub(crate) fn are_ready(&self) -> bool {
        let both = [Some(&self.current), self.pinned.as_ref()];
        both.into_iter().flatten().all(JoinedShader::is_ready)
    }
}

/// A shader, and what it draws to.
#[derive(Clone)]
pub(super) struct JoinedShader {
    variant: Variant,
    /// A part of its pipeline.
    pub(super) destination: Destination,
    pub(super) shader: Handle<Shader>,
    /// Whether its pipeline exists; shared by the main and the render world.
    ready: Arc<AtomicBool>,
}

impl JoinedShader {
    fn is_ready(&self) -> bool {
        self.ready.load(Ordering::Acquire)
    }

    pub(super) fn set_ready(&self, ready: bool) {
        self.ready.store(ready, Ordering::Release);
    }
}

/// The shaders joined so far, the most recently used last, so that going back to one costs nothing.
#[derive(Resource, Default)]
pub(in crate::render) struct JoinedShaders(Vec<JoinedShader>);

/// Maximum number of shaders that are kept, each with a compiled pipeline: more than a user reaches
/// in a while with keys and presets.
const MAX_SHADERS: usize = 48;

/// Selects the shaders of the current scene and of the pinned one.
pub(in crate::render) fn select_geodesic_shaders(
    mut commands: Commands,
    scene: Res<CurrentScene>,
    compared: Res<ComparedScene>,
    mut joined: ResMut<JoinedShaders>,
    mut shaders: ResMut<Assets<Shader>>,
) {
    let destination = if compared.is_difference() {
        Destination::Light
    } else {
        Destination::Picture {
            samples: Chain::of(&scene).samples,
        }
    };
    let mut select =
        |scene: &Scene| joined.select(Variant::picture(scene), destination, &mut shaders);
    let selected = GeodesicShaders {
        current: select(&scene),
        pinned: compared.drawn().map(|(pinned, _)| select(pinned)),
    };
    commands.insert_resource(selected);
}

impl JoinedShaders {
    /// A new variant is joined from its parts; once there are [`MAX_SHADERS`], it replaces the
    /// shader that has been unused for the longest time.
    fn select(
        &mut self,
        variant: Variant,
        destination: Destination,
        shaders: &mut Assets<Shader>,
    ) -> JoinedShader {
        let Self(joined) = self;
        let known = joined
            .iter()
            .position(|known| known.variant == variant && known.destination == destination);
        let selected = match known {
            Some(index) => joined.remove(index),
            None => {
                let source = Shader::from_wgsl(variant.source(), "lightfall/geodesic.wgsl");
                let shader = if joined.len() < MAX_SHADERS {
                    shaders.add(source)
                } else {
                    let JoinedShader { shader, .. } = joined.remove(0);
                    if let Err(error) = shaders.insert(shader.id(), source) {
                        error!("a shader could not be replaced: {error}");
                    }
                    shader
                };
                JoinedShader {
                    variant,
                    destination,
                    shader,
                    ready: default(),
                }
            }
        };
        joined.push(selected.clone());
        selected
    }
}
