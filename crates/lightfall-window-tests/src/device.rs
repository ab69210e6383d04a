//! Destroys the graphics device when ordered to.

use crate::orders::Orders;
use bevy::prelude::*;
use bevy::render::extract_resource::{ExtractResource, ExtractResourcePlugin};
use bevy::render::render_resource::PollType;
use bevy::render::renderer::RenderDevice;
use bevy::render::{Render, RenderApp, RenderSystems};
use watched::Order;

/// Whether the device is to be destroyed in this frame.
#[derive(Resource, Clone, Default, ExtractResource)]
struct Destroy(bool);

pub fn plugin(app: &mut App) {
    app.init_resource::<Destroy>()
        .add_plugins(ExtractResourcePlugin::<Destroy>::default())
        .add_systems(Update, order_destruction);
    app.sub_app_mut(RenderApp)
        .add_systems(Render, destroy.in_set(RenderSystems::Cleanup));
}

fn order_destruction(orders: Res<Orders>, mut destroy: ResMut<Destroy>) {
    let ordered = |order| matches!(order, &Order::LoseDevice);
    destroy.0 = orders.new.iter().any(ordered);
}

fn destroy(wanted: If<Res<Destroy>>, device: Res<RenderDevice>) {
    if wanted.0.0 {
        // Between two frames, and after every buffer that Bevy is reading has been read: a buffer
        // that a loss takes away stays readable, one that is destroyed does not.
        let _ = device.poll(PollType::wait_indefinitely());
        device.wgpu_device().destroy();
        // What this answers is the loss itself.
        let _ = device.poll(PollType::wait_indefinitely());
    }
}
