//! The loss of the graphics device: a driver that was restarted or updated, a card that was taken
//! away. The scene lives in the main world and loses nothing; a new device is opened, and Bevy runs
//! every pass's `RenderStartup` again.

use super::wgpu_settings;
use crate::render::redraw::DrawRequest;
use bevy::prelude::*;
use bevy::render::error_handler::{ErrorType, RenderError, RenderErrorHandler, RenderErrorPolicy};
use std::time::{Duration, Instant};

/// A device that is lost this often within [`WHILE`] is not going to stay, and opening it again
/// would only flicker.
const MAX_LOSSES: usize = 5;
/// See [`MAX_LOSSES`].
const WHILE: Duration = Duration::from_secs(60);
/// An adapter that is gone for so long does not come back.
const PATIENCE: Duration = Duration::from_secs(20);
/// Time between two looks for one.
const LOOK: Duration = Duration::from_millis(500);

/// Every loss so far.
#[derive(Resource, Default)]
pub struct DeviceLosses {
    /// How many devices were lost and replaced.
    pub recovered: usize,
    /// When those were lost that still count.
    lately: Vec<Instant>,
    /// Since when there is no adapter to open, and when one was last looked for.
    without: Option<(Instant, Instant)>,
}

/// Goes on after the loss of a device with another one. Without it an app ends.
pub fn plugin(app: &mut App) {
    app.init_resource::<DeviceLosses>()
        .insert_resource(RenderErrorHandler(respond));
}

/// Asked in every frame from an error on, until it says something else than to wait.
fn respond(error: &RenderError, main: &mut World, _render: &mut World) -> RenderErrorPolicy {
    if error.ty != ErrorType::DeviceLost {
        error!(
            "the graphics device refused what it was told: {}",
            error.description
        );
        return end(main);
    }
    let now = Instant::now();
    let mut losses = main.resource_mut::<DeviceLosses>();
    if losses
        .without
        .is_some_and(|(_, looked)| now.duration_since(looked) < LOOK)
    {
        return RenderErrorPolicy::StopRendering;
    }
    if let Err(reason) = lightfall_core::gpu::check_adapter() {
        let since = losses.without.map_or(now, |(since, _)| since);
        losses.without = Some((since, now));
        if now.duration_since(since) < PATIENCE {
            return RenderErrorPolicy::StopRendering;
        }
        error!("the graphics device was lost, and there is no other: {reason}");
        return end(main);
    }
    losses.without = None;
    losses
        .lately
        .retain(|lost| now.duration_since(*lost) < WHILE);
    losses.lately.push(now);
    if losses.lately.len() > MAX_LOSSES {
        error!("the graphics device is lost again and again");
        return end(main);
    }
    losses.recovered += 1;
    // The eye must be awake when the new device meets its first frame: Bevy's bloom takes a resting
    // camera's buffers, which are gone, for granted.
    if let Some(request) = main.get_resource::<DrawRequest>() {
        request.forget();
    }
    warn!("the graphics device was lost; opening it again");
    RenderErrorPolicy::Recover(wgpu_settings().into())
}

fn end(main: &mut World) -> RenderErrorPolicy {
    main.write_message(AppExit::error());
    RenderErrorPolicy::StopRendering
}
