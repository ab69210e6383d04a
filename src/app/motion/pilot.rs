//! Flying by hand: keys, mouse, gamepad and fingers move and turn the camera, freely or around the hole.

use super::crossing::announce_crossing;
use super::facing::{Facing, start_facing, turn_camera};
use super::free_fall::FreeFall;
use super::hand::{HandInputs, looks};
use super::orbit_camera::{OrbitCamera, orbited, switch_orbit_camera};
use super::steering::{Barrier, MIN_RADIUS, Steered, steered, thrust_fades};
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::input::pointer::{locate_pointer, pointer_over_picture};
use crate::app::input::touch::read_fingers;
use crate::app::state::helm::Helm;
use crate::app::state::kiosk::HiddenPointer;
use crate::app::state::overlays::Overlays;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::toast::Toast;
use bevy::input::mouse::{AccumulatedMouseScroll, MouseScrollUnit};
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy::window::{CursorGrabMode, CursorOptions, PrimaryWindow};
use lightfall_core::scene::{ObserverKind, Scene};
use lightfall_platform::IN_BROWSER;

/// The state of the mouse's controls.
#[derive(Resource)]
pub(crate) struct Pilot {
    /// Factor of the speed, set by the wheel.
    pub(crate) throttle: f64,
    /// Whether the mouse looks around without a button being held.
    pub(crate) free_look: bool,
    /// Whether the left button was pressed over the picture and is still held.
    pub(super) drags: bool,
    /// Whether the browser held the mouse for the page in the last frame.
    #[cfg(target_arch = "wasm32")]
    was_locked: bool,
    /// Notches of the wheel in this frame that move the orbit camera or set the ship's thrust.
    pub(super) notches: f64,
}

impl Pilot {
    /// Frees the mouse, and flies at the usual speed again.
    pub(super) fn let_go(&mut self) {
        (self.throttle, self.notches) = (1.0, 0.0);
        (self.free_look, self.drags) = (false, false);
    }
}

/// One notch of the wheel changes the speed by this factor, within a range.
const THROTTLE_NOTCH: f64 = 1.15;
const THROTTLE_RANGE: [f64; 2] = [0.02, 50.0];
/// Pixels of a touchpad's scroll that count as one notch.
const PIXELS_PER_NOTCH: f32 = 40.0;

pub(crate) fn plugin(app: &mut App) {
    app.insert_resource(Pilot {
        #[cfg(target_arch = "wasm32")]
        was_locked: false,
        throttle: 1.0,
        free_look: false,
        drags: false,
        notches: 0.0,
    })
    .init_resource::<Facing>()
    .init_resource::<OrbitCamera>()
    .add_systems(
        Update,
        (
            (switch_orbit_camera, start_facing).chain(),
            (use_wheel, start_drag)
                .after(locate_pointer)
                .run_if(pointer_over_picture),
            grab_mouse,
            steer_camera.after(read_fingers),
            turn_camera,
            announce_crossing,
        )
            .chain(),
    );
}

/// The wheel sets the speed or the ship's thrust, or moves the orbit camera in and out.
fn use_wheel(
    scroll: Res<AccumulatedMouseScroll>,
    (orbit, helm): (Res<OrbitCamera>, Res<Helm>),
    mut pilot: ResMut<Pilot>,
) {
    let notches = match scroll.unit {
        MouseScrollUnit::Line => scroll.delta.y,
        MouseScrollUnit::Pixel => scroll.delta.y / PIXELS_PER_NOTCH,
    };
    if notches == 0.0 {
        return;
    }
    if orbit.is_on() || helm.has_ship() {
        pilot.notches += f64::from(notches);
        return;
    }
    let [slowest, fastest] = THROTTLE_RANGE;
    pilot.throttle =
        (pilot.throttle * THROTTLE_NOTCH.powf(f64::from(notches))).clamp(slowest, fastest);
}

/// The left button over the picture looks around as the right one does, unless it inspects rays.
fn start_drag(
    buttons: Res<ButtonInput<MouseButton>>,
    overlays: Res<Overlays>,
    mut pilot: ResMut<Pilot>,
) {
    if buttons.just_pressed(MouseButton::Left) && !overlays.shows_inspector() {
        pilot.drags = true;
    }
}

/// Grabs or frees the mouse when its key is pressed, and frees it when the window loses the focus.
pub(crate) fn grab_mouse(
    mut commands: MessageReader<AppCommand>,
    buttons: Res<ButtonInput<MouseButton>>,
    bindings: Res<Bindings>,
    mut pilot: ResMut<Pilot>,
    (mut toast, hidden): (ResMut<Toast>, Res<HiddenPointer>),
    window: Single<(&Window, &mut CursorOptions), With<PrimaryWindow>>,
) {
    let (window, mut cursor) = window.into_inner();
    for _ in 0..AppCommand::MouseLook.count(&mut commands) {
        pilot.free_look = !pilot.free_look;
        toast.say(if pilot.free_look {
            format!(
                "Mouse look: on, {} frees the mouse",
                bindings.label("fly.mouse")
            )
        } else {
            "Mouse look: off".into()
        });
    }
    if !window.focused {
        pilot.free_look = false;
    }
    pilot.drags &= window.focused && buttons.pressed(MouseButton::Left);
    let grabbed = window.focused && looks(&pilot, &buttons);
    #[cfg(target_arch = "wasm32")]
    follow_pointer_lock(&mut pilot, &cursor);
    // A browser announces at length that a page holds the mouse, too often for every drag.
    let locks = grabbed && (pilot.free_look || !IN_BROWSER);
    let mode = if locks {
        CursorGrabMode::Locked
    } else {
        CursorGrabMode::None
    };
    let visible = !locks && !hidden.0;
    if cursor.grab_mode != mode || cursor.visible != visible {
        cursor.grab_mode = mode;
        cursor.visible = visible;
    }
}

/// Ends the mouse look when the browser has freed the mouse, which the key Esc makes it do without
/// telling the page of the key.
#[cfg(target_arch = "wasm32")]
fn follow_pointer_lock(pilot: &mut Pilot, cursor: &CursorOptions) {
    let locked = lightfall_platform::browser::pointer_is_locked();
    if pilot.was_locked && !locked && cursor.grab_mode == CursorGrabMode::Locked {
        pilot.free_look = false;
    }
    pilot.was_locked = locked;
}

pub(super) fn steer_camera(
    inputs: HandInputs,
    bindings: Res<Bindings>,
    (orbit, free_fall, helm): (Res<OrbitCamera>, Res<FreeFall>, Res<Helm>),
    mut pilot: ResMut<Pilot>,
    mut facing: ResMut<Facing>,
    mut editor: SceneEditor,
) {
    if helm.has_ship() {
        return;
    }
    let seconds = inputs.seconds();
    let hand = inputs.hand(&pilot);
    let notches = std::mem::take(&mut pilot.notches);
    let scene = editor.drawn_scene();
    let (flown, moves) = if orbit.is_on() {
        let Some(step) = hand.orbit_step(notches, seconds) else {
            return;
        };
        // The orbit camera turns to the hole before it moves.
        if facing.is_turning() {
            return;
        }
        (orbited(&scene, &step), true)
    } else {
        let Some(steering) = hand.steering(&scene, pilot.throttle, seconds) else {
            return;
        };
        if steering.turn != DVec3::ZERO {
            facing.stop();
        }
        (steered(&scene, &steering), steering.thrust != DVec3::ZERO)
    };
    let flown = match flown {
        Ok(flown) => flown,
        Err(reason) => {
            editor.say(format!("The camera cannot fly there: {reason}"));
            return;
        }
    };
    if moves && flown.stopped_by != Some(Barrier::Horizon) {
        editor.note_departure_by_hand();
    }
    editor.fly(&flown.scene);
    let is_over = free_fall.is_over(&scene);
    for words in news(&scene, &flown, is_over, &bindings)
        .into_iter()
        .flatten()
    {
        editor.say(words);
    }
}

/// Messages about a frame of flying by hand: a change of the observer, and what stopped or slowed the
/// camera. `is_over` says whether a fall came to its end here.
fn news(
    before: &Scene,
    flown: &Steered,
    is_over: bool,
    bindings: &Bindings,
) -> [Option<String>; 2] {
    let [back, fall] = ["scene.undo", "motion.let_go"].map(|id| bindings.label(id));
    let [was, is] = [before, flown.scene.scene()].map(|scene| scene.observer.kind);
    let observer = if was == ObserverKind::Orbit && is != ObserverKind::Orbit {
        let motion = is.properties().motion;
        Some(format!(
            "Thrust ends the orbit: {motion} now; {back} returns"
        ))
    } else {
        let replaced = flown.replaced.map(observer_change);
        replaced.map(|change| format!("{change}; {back} returns"))
    };
    let barrier = flown.stopped_by.map(|barrier| match barrier {
        Barrier::MinRadius => {
            format!("You can fly no closer than {MIN_RADIUS} r_s by hand: {fall} lets you fall in")
        }
        Barrier::Horizon if is_over => {
            format!("The fall is over: {back} goes back to where you let go")
        }
        Barrier::Horizon => {
            format!("Inside the horizon every way leads inward: {fall} falls on, {back} returns")
        }
    });
    let inward = flown.scene.camera.r < before.camera.r;
    let faded = (barrier.is_none() && inward && thrust_fades(before))
        .then(|| format!("So close, thrust inward fades: {fall} lets go and falls in"));
    [observer, barrier.or(faded)]
}

/// The message that another observer replaces one that cannot exist.
fn observer_change(kinds: [ObserverKind; 2]) -> String {
    let [wanted, nearest] = kinds.map(|kind| kind.properties().motion);
    format!("Observer: {nearest}, for {wanted} is not possible here")
}
