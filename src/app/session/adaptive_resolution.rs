//! Automatic resolution: while something moves, the disk too, the picture is drawn with as many
//! pixels as the wanted frame rate allows. A picture at rest is drawn in full.

use crate::app::session::canvas::{assumed_kind, measure_canvas};
use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::preferences::Preferences;
use crate::app::state::resolution::Resolution;
use crate::app::state::settings::Automatic;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_render::{CurrentScene, ShownCells};
use wgpu::DeviceType;

/// The coarsest picture, as a share of each side.
const MIN_SHARE: f64 = 0.25;
/// Shares are multiples of this, so that sizes do not change with every frame.
const STEP: f64 = 1.0 / 16.0;
/// Frames of a movement over which the frame time is averaged.
const FRAMES: u32 = 4;
/// Maximum time that counts for one frame, in seconds: a machine that slept drew nothing meanwhile.
const MAX_FRAME_SECONDS: f64 = 2.0;
/// The picture gets finer only where the frame rate exceeds the wanted one by this factor.
const REFINE_MARGIN: f64 = 1.35;

/// What the frame times of the present movement have shown so far.
#[derive(Default)]
struct Measurement {
    /// Share of each side that held the frame rate last. None before the first movement.
    share: Option<f64>,
    frames: u32,
    seconds: f64,
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, adapt_resolution.after(measure_canvas));
}

fn adapt_resolution(
    time: Res<Time<Real>>,
    pacing: Res<FramePacing>,
    preferences: Res<Preferences>,
    adapter: Option<Res<RenderAdapterInfo>>,
    mut resolution: ResMut<Resolution>,
    scene: Res<CurrentScene>,
    mut cells: ResMut<ShownCells>,
    mut measurement: Local<Measurement>,
) {
    let settings = &preferences.settings;
    let fineness = resolution.fineness(&scene.picture);
    let is_slow = |info| {
        let kind = assumed_kind(info);
        matches!(kind, DeviceType::Cpu | DeviceType::IntegratedGpu)
    };
    let wanted = match settings.automatic_resolution {
        Automatic::On => true,
        Automatic::Off => false,
        Automatic::Auto => fineness > 1.0 || adapter.as_deref().is_some_and(is_slow),
    };
    let adapts = wanted && pacing.running;
    // A first movement begins with as many pixels as the scene asks for.
    let first_share = round_share(fineness.sqrt().recip());
    let mut share = measurement.share.unwrap_or(first_share);
    // The first frames of a movement still wait for the full picture.
    if adapts && pacing.frames > 1 {
        measurement.frames += 1;
        measurement.seconds += time.delta_secs_f64().min(MAX_FRAME_SECONDS);
        if measurement.frames >= FRAMES {
            let frame = measurement.seconds / f64::from(measurement.frames);
            share = next_share(share, frame * settings.frame_rate);
            *measurement = Measurement {
                share: Some(share),
                ..default()
            };
        }
    } else {
        (measurement.frames, measurement.seconds) = (0, 0.0);
    }
    resolution.set_share(if adapts { share } else { 1.0 });
    // The cells do not get coarser with the picture.
    cells.set_if_neq(ShownCells(Some(resolution.at_rest(&scene.picture).grid())));
}

/// The next share of each side, where frames last `slowness` times as long as wanted. The time of
/// a frame is taken as proportional to the number of pixels.
fn next_share(share: f64, slowness: f64) -> f64 {
    let wanted = if slowness > 1.0 {
        share / slowness.sqrt()
    } else if slowness * REFINE_MARGIN < 1.0 {
        share + STEP
    } else {
        share
    };
    round_share(wanted)
}

fn round_share(share: f64) -> f64 {
    ((share / STEP).round() * STEP).clamp(MIN_SHARE, 1.0)
}
