//! Recovery after the graphics device is lost: the driver was restarted or updated, or the card was
//! removed. The scene lives in the main world and loses nothing. A new device is opened, and Bevy
//! runs `RenderStartup` of every pass again.

use crate::device::render_creation;
use crate::draw_request::DrawRequest;
use bevy::platform::time::Instant;
use bevy::prelude::*;
use bevy::render::error_handler::{ErrorType, RenderError, RenderErrorHandler, RenderErrorPolicy};
use lightfall_core::gpu::{driver_advice, working_adapter};
use lightfall_platform::IN_BROWSER;
use std::env::consts::OS;
use std::sync::{Arc, OnceLock};
use std::time::Duration;

/// The program ends when the device is lost more often than this within [`LOSS_PERIOD`]: opening it
/// again would only flicker.
const MAX_LOSSES: usize = 5;
/// See [`MAX_LOSSES`].
const LOSS_PERIOD: Duration = Duration::from_secs(60);
/// The program ends when there has been no adapter for this long.
const MAX_TIME_WITHOUT_ADAPTER: Duration = Duration::from_secs(20);
/// Time between two searches for an adapter.
const SEARCH_INTERVAL: Duration = Duration::from_millis(500);

/// Why the program ends, once it does because of the graphics device: one sentence. A clone still
/// tells it after the app is gone.
#[derive(Resource, Clone, Default)]
pub struct DeviceFailure(Arc<OnceLock<String>>);

impl DeviceFailure {
    /// The sentence, if the device has failed for good.
    #[must_use]
    pub fn sentence(&self) -> Option<&str> {
        self.0.get().map(String::as_str)
    }
}

/// The losses of the graphics device so far.
#[derive(Resource, Default)]
pub struct DeviceLosses {
    /// How many devices were lost and replaced.
    pub recovered: usize,
    /// When the devices were lost that count toward [`MAX_LOSSES`].
    recent: Vec<Instant>,
    /// Since when there is no adapter, and when one was last searched for.
    without_adapter: Option<(Instant, Instant)>,
}

/// Opens another device when the graphics device is lost. Without this plugin the app ends.
pub fn plugin(app: &mut App) {
    app.init_resource::<DeviceLosses>()
        .init_resource::<DeviceFailure>()
        .insert_resource(RenderErrorHandler(choose_error_policy));
}

/// Bevy calls this in every frame after an error, until the answer is not to wait.
fn choose_error_policy(
    error: &RenderError,
    main: &mut World,
    _render: &mut World,
) -> RenderErrorPolicy {
    if error.ty != ErrorType::DeviceLost {
        let what = if error.ty == ErrorType::OutOfMemory {
            "the graphics device has too little free memory"
        } else {
            "the graphics device reported an error"
        };
        return end(main, format!("{what}: {}", error.description));
    }
    let now = Instant::now();
    let mut losses = main.resource_mut::<DeviceLosses>();
    if losses
        .without_adapter
        .is_some_and(|(_, searched)| now.duration_since(searched) < SEARCH_INTERVAL)
    {
        return RenderErrorPolicy::StopRendering;
    }
    // A page in a browser cannot wait for the answer.
    if !IN_BROWSER && let Err(reason) = working_adapter() {
        let since = losses.without_adapter.map_or(now, |(since, _)| since);
        losses.without_adapter = Some((since, now));
        if now.duration_since(since) < MAX_TIME_WITHOUT_ADAPTER {
            return RenderErrorPolicy::StopRendering;
        }
        return end(
            main,
            format!("the graphics device was lost, and no other is available: {reason}"),
        );
    }
    losses.without_adapter = None;
    losses
        .recent
        .retain(|lost| now.duration_since(*lost) < LOSS_PERIOD);
    losses.recent.push(now);
    if losses.recent.len() > MAX_LOSSES {
        return end(
            main,
            format!(
                "the graphics device was lost more than {MAX_LOSSES} times within a minute: {}, or choose another adapter \
                 with --gpu",
                driver_advice::with_old_driver(OS)
            ),
        );
    }
    losses.recovered += 1;
    // The scene camera must be active in the first frame of the new device: Bevy's bloom expects an
    // idle camera's buffers to exist, and they are lost.
    if let Some(request) = main.get_resource::<DrawRequest>() {
        request.forget_picture();
    }
    warn!("the graphics device was lost; opening it again");
    RenderErrorPolicy::Recover(render_creation())
}

/// Ends the program, and keeps the first sentence that says why.
fn end(main: &mut World, sentence: String) -> RenderErrorPolicy {
    main.resource::<DeviceFailure>().0.get_or_init(|| sentence);
    main.write_message(AppExit::error());
    RenderErrorPolicy::StopRendering
}
