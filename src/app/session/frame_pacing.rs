//! How often there is a new frame: as often as the monitor shows while something moves, a few a
//! second while nothing does.

use crate::app::input::gamepad::Pads;
use crate::app::input::keyboard::Typing;
use crate::app::session::window::Preferences;
use crate::render::CurrentScene;
use bevy::prelude::*;
use bevy::winit::{UpdateMode, WinitSettings};
use bevy_egui::{EguiContext, EguiInput, EguiPreUpdateSet, egui};
use std::time::{Duration, Instant};

/// What moved this recently, moves.
const MOVING: Duration = Duration::from_millis(400);
/// Time after the last input or change in which every frame is drawn: pipelines compile, overlays
/// open.
const AWAKE: Duration = Duration::from_secs(3);
/// Time between two frames while nothing happens; input ends it at once.
const RESTING: Duration = Duration::from_millis(200);
/// The same where there is a gamepad: the window system does not tell of its input, so it is looked
/// at.
const LOOKING: Duration = Duration::from_millis(33);

/// How it goes.
#[derive(Resource, Default)]
pub struct FramePacing {
    /// Whether the scene has changed just now.
    pub moving: bool,
    /// Whether frames are far apart because nothing happens.
    pub resting: bool,
    /// Frames since the movement began.
    pub frames: u32,
    /// Time of the last change of the scene, if there was one: the scene that the program starts
    /// with is none.
    changed: Option<Duration>,
    /// Time of the last sign of life.
    alive: Duration,
    /// When the last frame began, for the cap.
    began: Option<Instant>,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<FramePacing>()
        .add_systems(
            PreUpdate,
            hush.after(EguiPreUpdateSet::ProcessInput)
                .before(EguiPreUpdateSet::BeginPass),
        )
        .add_systems(PostUpdate, watch)
        .add_systems(Last, (choose, cap).chain());
}

/// Takes from egui what is no news: it is told of Shift, Ctrl and Alt in every frame, and asks for
/// another frame after whatever it is told, so that without this there would be frames without end.
fn hush(mut contexts: Query<(&mut EguiContext, &mut EguiInput)>) {
    for (mut context, mut input) in &mut contexts {
        let known = context.get_mut().input(|state| state.modifiers);
        input
            .events
            .retain(|event| *event != egui::Event::ModifiersChanged(known));
    }
}

/// Notes what changes the scene and what keeps the program awake.
fn watch(
    time: Res<Time<Real>>,
    scene: Res<CurrentScene>,
    keys: Res<ButtonInput<KeyCode>>,
    buttons: Res<ButtonInput<MouseButton>>,
    mut moves: MessageReader<CursorMoved>,
    typing: Res<Typing>,
    pads: Pads,
    mut pace: ResMut<FramePacing>,
    mut last: Local<Option<lightfall_core::scene::Scene>>,
) {
    let now = time.elapsed();
    // The size of picture and cells, which the automatic resolution sets, is no movement.
    let mut seen = scene.scene().clone();
    (seen.picture.width, seen.picture.height) = (1, 1);
    (seen.picture.grid_width, seen.picture.grid_height) = (1, 1);
    if last.as_ref() != Some(&seen) {
        if last.is_some() {
            pace.changed = Some(now);
        }
        *last = Some(seen);
    }
    let held = keys.get_pressed().next().is_some()
        || buttons.get_pressed().next().is_some()
        || pads.in_use();
    if pace.changed == Some(now) || held || typing.0 || moves.read().next().is_some() {
        pace.alive = now;
    }
    let moving = pace
        .changed
        .is_some_and(|changed| now.saturating_sub(changed) < MOVING);
    pace.frames = if moving && pace.moving {
        pace.frames + 1
    } else {
        0
    };
    pace.moving = moving;
    pace.resting = now.saturating_sub(pace.alive) > AWAKE;
}

fn choose(pace: Res<FramePacing>, pads: Pads, mut winit: ResMut<WinitSettings>) {
    let resting = if pads.any() { LOOKING } else { RESTING };
    let mode = if pace.resting {
        UpdateMode::reactive(resting)
    } else {
        UpdateMode::Continuous
    };
    if winit.focused_mode != mode {
        (winit.focused_mode, winit.unfocused_mode) = (mode, mode);
    }
}

/// Waits as long as a frame is meant to last.
fn cap(preferences: Res<Preferences>, mut pace: ResMut<FramePacing>) {
    let most = preferences.settings.most_frames;
    if most > 0.0
        && let Some(began) = pace.began
    {
        std::thread::sleep(Duration::from_secs_f64(1.0 / most).saturating_sub(began.elapsed()));
    }
    pace.began = Some(Instant::now());
}
