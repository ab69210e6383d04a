//! How often a new frame is drawn: as often as the monitor shows one while something moves, and a
//! few times a second while nothing does.

use crate::app::input::gamepad::Pads;
use crate::app::input::hands::Hands;
use crate::app::input::typing::Typing;
use crate::app::state::preferences::Preferences;
use bevy::platform::time::Instant;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy::winit::{UpdateMode, WinitSettings};
use bevy_egui::{EguiContext, EguiInput, EguiPreUpdateSet, egui};
use lightfall_core::scene::{Picture, Scene};
use lightfall_platform::IN_BROWSER;
use lightfall_render::{Comparison, DrawnScene, Progress};
use std::time::Duration;

/// The scene counts as moving for this long after its last change.
const MOVING_FOR: Duration = Duration::from_millis(400);
/// Every frame is drawn for this long after the last input or change, while pipelines compile and
/// overlays open.
const AWAKE_FOR: Duration = Duration::from_secs(3);
/// Time between two frames while nothing happens. Input ends it at once.
const RESTING_INTERVAL: Duration = Duration::from_millis(200);
/// Time between two frames while nothing happens, if a gamepad is connected. The window system does
/// not report a gamepad's input, so the program has to poll it.
const RESTING_INTERVAL_WITH_GAMEPAD: Duration = Duration::from_millis(33);

/// Whether the scene moves, and whether the program rests.
#[derive(Resource, Default)]
pub struct FramePacing {
    /// Whether the scene has just changed, by more than the disk's clock.
    pub moving: bool,
    /// Whether the picture is drawn again and again: the scene moves, or the disk's clock runs.
    pub running: bool,
    /// Whether frames are far apart because nothing happens.
    pub resting: bool,
    /// Frames since the picture began to run.
    pub frames: u32,
    /// When the scene last changed, as a time since the start. None before its first change.
    changed: Option<Duration>,
    /// When the disk's clock last went on.
    ticked: Option<Duration>,
    /// When something last happened, as a time since the start.
    active: Duration,
    /// When the last frame began, for the frame rate limit.
    began: Option<Instant>,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<FramePacing>()
        .add_systems(
            PreUpdate,
            drop_repeated_modifiers
                .after(EguiPreUpdateSet::ProcessInput)
                .before(EguiPreUpdateSet::BeginPass),
        )
        .add_systems(PostUpdate, watch_activity)
        .add_systems(
            Last,
            (choose_update_mode, limit_frame_rate.run_if(|| !IN_BROWSER)).chain(),
        );
}

/// Removes repeated reports of Shift, Ctrl and Alt before egui reads them. They arrive in every
/// frame, and egui requests another frame after each, so the program would never rest.
fn drop_repeated_modifiers(mut contexts: Query<(&mut EguiContext, &mut EguiInput)>) {
    for (mut context, mut input) in &mut contexts {
        let known = context.get_mut().input(|state| state.modifiers);
        input
            .events
            .retain(|event| *event != egui::Event::ModifiersChanged(known));
    }
}

/// Records changes of the scene and the input that keeps the program awake.
fn watch_activity(
    time: Res<Time<Real>>,
    scene: Res<DrawnScene>,
    comparison: Res<Comparison>,
    hands: Hands,
    mut moves: MessageReader<CursorMoved>,
    (typing, progress): (Res<Typing>, Res<Progress>),
    window: Single<&Window, With<PrimaryWindow>>,
    mut pacing: ResMut<FramePacing>,
    mut last: Local<Option<Scene>>,
    mut last_size: Local<Option<UVec2>>,
) {
    let now = time.elapsed();
    if scene.is_changed() {
        let seen = without_resolution(&scene);
        // The scene that the program starts with does not count as a change.
        if let Some(last) = last.as_ref().filter(|last| **last != seen) {
            if last.without_clock() == seen.without_clock() {
                pacing.ticked = Some(now);
            } else {
                pacing.changed = Some(now);
            }
        }
        *last = Some(seen);
    }
    // A window whose edge is dragged asks for a picture of another size in every frame.
    let size = window.physical_size();
    if last_size.replace(size).is_some_and(|last| last != size) {
        pacing.changed = Some(now);
    }
    // A divider that is dragged moves, too.
    if comparison.is_changed() && !comparison.is_added() {
        pacing.changed = Some(now);
    }
    if pacing.changed == Some(now)
        || hands.hold()
        || typing.is_on()
        || moves.read().next().is_some()
    {
        pacing.active = now;
    }
    let lately = |at: Option<Duration>| at.is_some_and(|at| now.saturating_sub(at) < MOVING_FOR);
    let moving = lately(pacing.changed);
    let running = moving || lately(pacing.ticked);
    pacing.frames = if running && pacing.running {
        pacing.frames + 1
    } else {
        0
    };
    (pacing.moving, pacing.running) = (moving, running);
    // While frames are averaged, each is drawn at once.
    let averaging = matches!(*progress, Progress::Averaging(_));
    pacing.resting = !running && !averaging && now.saturating_sub(pacing.active) > AWAKE_FOR;
}

/// The scene with the default resolution and without its texts. A change by the automatic
/// resolution does not count as movement, and neither does a new name.
fn without_resolution(scene: &Scene) -> Scene {
    let default = Picture::default();
    Scene {
        name: String::new(),
        title: String::new(),
        picture: Picture {
            width: default.width,
            height: default.height,
            grid_width: default.grid_width,
            grid_height: default.grid_height,
            ..scene.picture
        },
        ..scene.clone()
    }
}

fn choose_update_mode(pacing: Res<FramePacing>, pads: Pads, mut winit: ResMut<WinitSettings>) {
    let mode = match (pacing.resting, pads.any()) {
        (false, _) => UpdateMode::Continuous,
        (true, false) => UpdateMode::reactive(RESTING_INTERVAL),
        (true, true) => UpdateMode::reactive(RESTING_INTERVAL_WITH_GAMEPAD),
    };
    if winit.focused_mode != mode {
        (winit.focused_mode, winit.unfocused_mode) = (mode, mode);
    }
}

/// Waits until the frame has lasted as long as the settings want. A page in a browser cannot wait, so
/// the browser alone limits its frame rate.
fn limit_frame_rate(preferences: Res<Preferences>, mut pacing: ResMut<FramePacing>) {
    let limit = preferences.settings.most_frames;
    if limit > 0.0
        && let Some(began) = pacing.began
    {
        std::thread::sleep(Duration::from_secs_f64(1.0 / limit).saturating_sub(began.elapsed()));
    }
    pacing.began = Some(Instant::now());
}
