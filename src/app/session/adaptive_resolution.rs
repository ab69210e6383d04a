//! Automatic resolution: while something moves, the disk too, the picture is drawn with as many
//! pixels as the frame rate that the movement needs allows. A picture at rest is drawn in full.

use crate::app::session::canvas::{assumed_kind, measure_canvas};
use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::preferences::Preferences;
use crate::app::state::resolution::Resolution;
use crate::app::state::settings::Automatic;
use crate::app::state::view_point::ViewPoint;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_render::{CurrentScene, PictureArea, RestingSizes};
use wgpu::DeviceType;

/// The coarsest picture, as a share of each side.
const MIN_SHARE: f64 = 0.25;
/// Shares are multiples of this, so that sizes do not change with every frame.
const STEP: f64 = 1.0 / 16.0;
/// Frames of a movement over which the frame time is averaged.
const FRAMES: u32 = 4;
/// Maximum time that counts for one frame, in seconds: a machine that slept drew nothing meanwhile.
const MAX_FRAME_SECONDS: f64 = 2.0;
/// The frame rate of the slowest movement, and of a disk that turns before a camera at rest, as a share
/// of the wanted one. Fine pixels are worth more there than many frames.
const SLOWEST_RATE: f64 = 1.0 / 3.0;
/// The share of its height by which the picture moves between two frames at most, where the machine is
/// fast enough.
const MAX_JUMP: f64 = 0.005;

/// What the frames of the present movement have shown so far.
#[derive(Default)]
struct Measurement {
    /// Share of each side that held the frame rate last. None before the first movement.
    share: Option<f64>,
    frames: u32,
    seconds: f64,
    /// By how much of its height the picture has moved.
    moved: f64,
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
    mut area: ResMut<PictureArea>,
    (mut measurement, mut last): (Local<Measurement>, Local<Option<ViewPoint>>),
) {
    let settings = &preferences.settings;
    let fineness = resolution.fineness(&scene.shown_picture());
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
    let view_point = ViewPoint::from(scene.scene());
    let moved = last.map_or(0.0, |last| last.picture_motion(&view_point));
    *last = Some(view_point);
    // The first frames of a movement still wait for the full picture.
    if adapts && pacing.frames > 1 {
        measurement.frames += 1;
        measurement.seconds += time.delta_secs_f64().min(MAX_FRAME_SECONDS);
        measurement.moved += moved;
        if measurement.frames >= FRAMES {
            let frame = measurement.seconds / f64::from(measurement.frames);
            let speed = measurement.moved / measurement.seconds;
            share = next_share(share, frame * wanted_rate(speed, settings.frame_rate));
            *measurement = Measurement {
                share: Some(share),
                ..default()
            };
        }
    } else {
        *measurement = Measurement {
            share: measurement.share,
            ..default()
        };
    }
    resolution.set_share(if adapts { share } else { 1.0 });
    let at_rest = resolution.at_rest(&scene.shown_picture());
    area.set_if_neq(PictureArea {
        at_rest: Some(RestingSizes {
            size: at_rest.size(),
            grid: at_rest.grid(),
        }),
        ..*area
    });
}

/// The frame rate that a movement needs, where the picture moves by `speed` times its height in a
/// second, and fast movements are wanted at the rate `fast`.
#[must_use]
pub fn wanted_rate(speed: f64, fast: f64) -> f64 {
    (speed / MAX_JUMP).clamp(SLOWEST_RATE * fast, fast)
}

/// The next share of each side, where frames last `slowness` times as long as wanted. The time of
/// a frame is taken as proportional to the number of pixels. Some of it is not, so that a finer
/// picture by this rule holds the frame rate, too, and the share does not go up and down.
#[must_use]
pub fn next_share(share: f64, slowness: f64) -> f64 {
    let fitting = share / slowness.max(1e-3).sqrt();
    if slowness > 1.0 {
        round_share(fitting)
    } else {
        round_share(share.max((fitting / STEP).floor() * STEP))
    }
}

fn round_share(share: f64) -> f64 {
    ((share / STEP).round() * STEP).clamp(MIN_SHARE, 1.0)
}
