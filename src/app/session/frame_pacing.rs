//! How often a new frame is drawn: as often as the monitor shows one while something moves, and a
//! few times a second while nothing does.

use crate::app::input::gamepad::Pads;
use crate::app::input::typing::Typing;
use crate::app::state::preferences::Preferences;
use crate::render::CurrentScene;
use bevy::prelude::*;
use bevy::winit::{UpdateMode, WinitSettings};
use bevy_egui::{EguiContext, EguiInput, EguiPreUpdateSet, egui};
use lightfall_core::scene::{Picture, Scene};
use std::time::{Duration, Instant};

/// The scene counts as moving for this long after its last change.
const MOVING: Duration = Duration::from_millis(400);
/// Every frame is drawn for this long after the last input or change: pipelines compile, overlays
/// open.
const AWAKE: Duration = Duration::from_secs(3);
/// Time between two frames while nothing happens. Input ends it at once.
const RESTING: Duration = Duration::from_millis(200);
/// The same where there is a gamepad. The window system does not report its input, so the program
/// has to look.
const RESTING_WITH_GAMEPAD: Duration = Duration::from_millis(33);

/// Whether the scene moves, and whether the program rests.
#[derive(Resource, Default)]
pub struct FramePacing {
    /// Whether the scene has just changed.
    pub moving: bool,
    /// Whether frames are far apart because nothing happens.
    pub resting: bool,
    /// Frames since the movement began.
    pub frames: u32,
    /// When the scene last changed, as a time since the start. None before its first change.
    changed: Option<Duration>,
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
        .add_systems(Last, (choose_update_mode, limit_frame_rate).chain());
}

/// Takes repeated reports of Shift, Ctrl and Alt from egui. They come in every frame, and egui asks
/// for another frame after each, so that the program would never rest.
fn drop_repeated_modifiers(mut contexts: Query<(&mut EguiContext, &mut EguiInput)>) {
    for (mut context, mut input) in &mut contexts {
        let known = context.get_mut().input(|state| state.modifiers);
        input
            .events
            .retain(|event| *event != egui::Event::ModifiersChanged(known));
    }
}

/// Notes changes of the scene, and whatever else keeps the program awake.
fn watch_activity(
    time: Res<Time<Real>>,
    scene: Res<CurrentScene>,
    keys: Res<ButtonInput<KeyCode>>,
    buttons: Res<ButtonInput<MouseButton>>,
    mut moves: MessageReader<CursorMoved>,
    typing: Res<Typing>,
    pads: Pads,
    mut pacing: ResMut<FramePacing>,
    mut last: Local<Option<Scene>>,
) {
    let now = time.elapsed();
    if scene.is_changed() {
        let seen = without_resolution(&scene);
        if last.as_ref() != Some(&seen) {
            // The scene that the program starts with is no change.
            if last.is_some() {
                pacing.changed = Some(now);
            }
            *last = Some(seen);
        }
    }
    let held = keys.get_pressed().next().is_some()
        || buttons.get_pressed().next().is_some()
        || pads.in_use();
    if pacing.changed == Some(now) || held || typing.0 || moves.read().next().is_some() {
        pacing.active = now;
    }
    let moving = pacing
        .changed
        .is_some_and(|changed| now.saturating_sub(changed) < MOVING);
    pacing.frames = if moving && pacing.moving {
        pacing.frames + 1
    } else {
        0
    };
    pacing.moving = moving;
    pacing.resting = now.saturating_sub(pacing.active) > AWAKE;
}

/// The scene with a resolution that is always the same: what the automatic resolution changes is no
/// movement.
fn without_resolution(scene: &Scene) -> Scene {
    let default = Picture::default();
    Scene {
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
        (true, false) => UpdateMode::reactive(RESTING),
        (true, true) => UpdateMode::reactive(RESTING_WITH_GAMEPAD),
    };
    if winit.focused_mode != mode {
        (winit.focused_mode, winit.unfocused_mode) = (mode, mode);
    }
}

/// Waits until the frame has lasted as long as the settings want.
fn limit_frame_rate(preferences: Res<Preferences>, mut pacing: ResMut<FramePacing>) {
    let limit = preferences.settings.most_frames;
    if limit > 0.0
        && let Some(began) = pacing.began
    {
        std::thread::sleep(Duration::from_secs_f64(1.0 / limit).saturating_sub(began.elapsed()));
    }
    pacing.began = Some(Instant::now());
}
