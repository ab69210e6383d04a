//! The shaders of the current scene and of the pinned one: which parts each is joined from, and
//! whether its pipeline exists.

use super::pipeline::Destination;
use crate::chain::Chain;
use crate::comparison::ComparedScene;
use crate::drawn_scene::DrawnScene;
use crate::live_shaders::LiveShaders;
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use bevy::render::render_resource::ColorWrites;
use lightfall_core::gpu::stars::StarKernel;
use lightfall_core::gpu::{Entry, Variant};
use lightfall_core::scene::{Projection, Scene};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The shaders that are needed now. The main world writes them, since shader assets live there.
#[derive(Resource, Clone, ExtractResource)]
pub(crate) struct GeodesicShaders {
    pub(super) current: SceneShaders,
    /// Those of the pinned scene, while it is compared with the current one.
    pub(super) pinned: Option<SceneShaders>,
    /// How often they have been reloaded.
    pub(super) reloads: u32,
}

/// The shaders of a scene.
#[derive(Clone)]
pub(super) struct SceneShaders {
    pub(super) picture: JoinedShader,
    /// What refines its edges, where there is anything to refine.
    pub(super) refine: Option<JoinedShader>,
    /// What finds the images of its stars, where it has any.
    pub(super) stars: Vec<JoinedShader>,
}

impl GeodesicShaders {
    /// Whether their pipelines exist.
    pub(crate) fn are_ready(&self) -> bool {
        let scenes = [Some(&self.current), self.pinned.as_ref()];
        scenes.into_iter().flatten().all(SceneShaders::are_ready)
    }
}

impl SceneShaders {
    fn are_ready(&self) -> bool {
        let drawing = [Some(&self.picture), self.refine.as_ref()];
        let mut all = drawing.into_iter().flatten().chain(&self.stars);
        all.all(JoinedShader::is_ready)
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
    /// The kernel of stars that it is, if it is one.
    pub(super) fn star_kernel(&self) -> Option<StarKernel> {
        match self.variant.entry {
            Entry::Star(kernel) => Some(kernel),
            _ => None,
        }
    }

    /// How it takes a pixel to a direction and back.
    pub(super) fn projection(&self) -> Projection {
        self.variant.projection
    }

    fn is_ready(&self) -> bool {
        self.ready.load(Ordering::Acquire)
    }

    pub(super) fn set_ready(&self, ready: bool) {
        self.ready.store(ready, Ordering::Release);
    }
}

/// The shaders joined so far, the most recently used last, so that going back to one costs nothing.
#[derive(Resource, Default)]
pub(crate) struct JoinedShaders(Vec<JoinedShader>);

/// Maximum number of shaders that are kept for each destination, each with a compiled pipeline: more
/// than a user reaches in a while with keys and presets.
const MAX_SHADERS: usize = 48;

/// The name of these shaders in Bevy's messages.
const NAME: &str = "lightfall/geodesic.wgsl";

/// Selects the shaders of the current scene and of the pinned one.
pub(crate) fn select_geodesic_shaders(
    mut commands: Commands,
    scene: Res<DrawnScene>,
    compared: Res<ComparedScene>,
    mut joined: ResMut<JoinedShaders>,
    mut shaders: ResMut<Assets<Shader>>,
    mut live: ResMut<LiveShaders>,
) {
    let chain = Chain::of(&scene).comparing(&compared);
    // What is remembered here changes no shader.
    let live = live.bypass_change_detection();
    let mut select = |scene: &Scene| {
        let mut variant = Variant::picture(scene);
        variant.antialias &= chain.antialias;
        let destination = if chain.difference {
            Destination::Light
        } else {
            Destination::Picture {
                samples: chain.samples,
                traits: chain.antialias.then_some(if variant.antialias {
                    ColorWrites::ALL
                } else {
                    ColorWrites::empty()
                }),
            }
        };
        let refined = variant.refined();
        let stars = if variant.star_points {
            Variant::star_kernels(scene)
        } else {
            Vec::new()
        };
        let mut join =
            |variant, destination| joined.select(variant, destination, &mut shaders, live);
        let picture = join(variant, destination);
        let mut compute = |variant: Variant| join(variant, Destination::Compute(variant.entry));
        SceneShaders {
            picture,
            refine: refined.map(&mut compute),
            stars: stars.into_iter().map(compute).collect(),
        }
    };
    let current = select(&scene);
    let pinned = compared.drawn().map(|(pinned, _)| select(pinned));
    commands.insert_resource(GeodesicShaders {
        current,
        pinned,
        reloads: live.news().reloads,
    });
}

impl JoinedShaders {
    /// Counts no pipeline as ready until it is known again: the shaders have changed. What the
    /// render world still says of the pipelines before does not count.
    pub(crate) fn await_pipelines(&mut self) {
        for joined in &mut self.0 {
            joined.ready = default();
        }
    }

    /// A new variant is joined from its parts; once there are [`MAX_SHADERS`], it replaces the
    /// shader that has been unused for the longest time. Only shaders for the same destination
    /// replace each other, because the pipelines of a shader are kept with it.
    fn select(
        &mut self,
        variant: Variant,
        destination: Destination,
        shaders: &mut Assets<Shader>,
        live: &mut LiveShaders,
    ) -> JoinedShader {
        let Self(joined) = self;
        let known = joined
            .iter()
            .position(|known| known.variant == variant && known.destination == destination);
        let selected = match known {
            Some(index) => joined.remove(index),
            None => {
                let text = variant.text();
                let own_source = live.source(&text);
                let source = Shader::from_wgsl(own_source.clone(), NAME);
                let like = |known: &JoinedShader| known.destination == destination;
                let oldest = joined.iter().position(like).unwrap_or_default();
                let shader = if joined.iter().filter(|known| like(known)).count() < MAX_SHADERS {
                    shaders.add(source)
                } else {
                    let JoinedShader { shader, .. } = joined.remove(oldest);
                    if let Err(error) = shaders.insert(shader.id(), source) {
                        error!("a shader could not be replaced: {error}");
                    }
                    shader
                };
                live.remember(shader.id(), NAME, text, own_source);
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
