//! Light that was drawn before, given back to the chain: a large picture is drawn part by part, and
//! developed part by part when the bloom of the whole is known.

use crate::camera_markers::SceneCamera;
use crate::capture::LIGHT_BYTES;
use crate::drawn_scene::DrawnPart;
use crate::graphics::picture_size;
use crate::progress::DrawnFrame;
use bevy::core_pipeline::core_3d::main_transparent_pass_3d;
use bevy::core_pipeline::schedule::{Core3d, Core3dSystems};
use bevy::image::ToExtents;
use bevy::prelude::*;
use bevy::render::RenderApp;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::TexelCopyBufferLayout;
use bevy::render::renderer::{RenderQueue, ViewQuery};
use bevy::render::view::ViewTarget;
use std::sync::Arc;

/// The light of the part of the picture that comes next: half floats as in
/// [`Captured`](crate::Captured), as bytes in little-endian order, in rows from the top. While there is
/// any, no ray is traced. The scene must have no foreground.
#[derive(Resource, Clone, Default, Deref, ExtractResource)]
pub struct GivenLight(Option<Arc<Vec<u8>>>);

impl GivenLight {
    /// Gives light.
    #[must_use]
    pub fn new(bytes: Vec<u8>) -> Self {
        Self(Some(Arc::new(bytes)))
    }
}

/// Whether rays are traced: the run condition of the passes that need them.
pub(super) fn traces_light(given: Res<GivenLight>) -> bool {
    given.is_none()
}

pub(super) fn plugin(app: &mut App) {
    app.add_plugins(ExtractResourcePlugin::<GivenLight>::default());
    app.sub_app_mut(RenderApp).add_systems(
        Core3d,
        upload_light
            .in_set(Core3dSystems::MainPass)
            .after(main_transparent_pass_3d)
            .run_if(not(traces_light)),
    );
}

/// Puts the given light into the picture.
fn upload_light(
    view: ViewQuery<&ViewTarget, With<SceneCamera>>,
    (given, part): (Res<GivenLight>, Res<DrawnPart>),
    mut drawn: ResMut<DrawnFrame>,
    queue: Res<RenderQueue>,
) {
    let target = view.into_inner();
    let size = picture_size(target);
    let wanted = part.in_target(size).size;
    let Some(bytes) = &given.0 else {
        return;
    };
    if wanted != size || bytes.len() != LIGHT_BYTES * size.as_usizevec2().element_product() {
        return;
    }
    queue.write_texture(
        target.main_texture().as_image_copy(),
        bytes,
        TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(size.x * LIGHT_BYTES as u32),
            rows_per_image: None,
        },
        size.to_extents(),
    );
    (drawn.is_drawn, drawn.is_added) = (true, true);
}
