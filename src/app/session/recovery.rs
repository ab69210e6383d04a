//! After the loss of the graphics device: creates the user interface's resources on the new device,
//! and reports the loss to the user.

use crate::app::state::kiosk::outside_kiosk;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy::render::render_resource::SpecializedRenderPipelines;
use bevy::render::{GpuResourceAppExt, RenderApp};
use bevy_egui::render::EguiPipeline;
use bevy_egui::render::systems::{EguiRenderData, EguiTransforms};
use lightfall_render::recovery;
use lightfall_render::recovery::DeviceLosses;

pub(crate) fn plugin(app: &mut App) {
    recovery::plugin(app);
    app.add_systems(
        Update,
        report_device_loss
            .run_if(resource_changed::<DeviceLosses>)
            // Visitors need not know.
            .run_if(outside_kiosk),
    );
    // egui's own plugin creates these only once. They would still refer to buffers and pipelines
    // of the lost device.
    if let Some(render_app) = app.get_sub_app_mut(RenderApp) {
        render_app
            .init_gpu_resource::<EguiPipeline>()
            .init_gpu_resource::<SpecializedRenderPipelines<EguiPipeline>>()
            .init_gpu_resource::<EguiTransforms>()
            .init_gpu_resource::<EguiRenderData>();
    }
}

fn report_device_loss(
    losses: Res<DeviceLosses>,
    mut toast: ResMut<Toast>,
    mut reported: Local<usize>,
) {
    if losses.recovered > *reported {
        *reported = losses.recovered;
        toast
            .say("The graphics device was lost and has been opened again. The scene is as it was.");
    }
}
