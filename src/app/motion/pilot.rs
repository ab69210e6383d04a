//! Flying by hand: keys, mouse and gamepad move and turn the camera.

use super::MAX_FRAME_SECONDS;
use super::steering::{Steered, Steering, steered};
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::{AppCommand, FlightInput};
use crate::app::input::held::HeldControls;
use crate::app::input::pointer::{locate_pointer, pointer_over_picture};
use crate::app::state::toast::Toast;
use crate::render::CurrentScene;
use bevy::input::mouse::{AccumulatedMouseMotion, AccumulatedMouseScroll, MouseScrollUnit};
use bevy::math::{DVec2, DVec3};
use bevy::prelude::*;
use bevy::window::{CursorGrabMode, CursorOptions, PrimaryWindow};
use lightfall_core::scene::ObserverKind;

/// What the mouse has set.
#[derive(Resource)]
pub(crate) struct Pilot {
    /// Factor of the speed, set by the wheel.
    pub(crate) throttle: f64,
    /// Whether the mouse looks around without a button being held.
    pub(crate) free_look: bool,
}

/// Shift flies faster and Alt slower by this factor.
pub(crate) const GEAR: f64 = 4.0;
/// One notch of the wheel changes the speed by this factor, within a range.
const THROTTLE_NOTCH: f64 = 1.15;
const THROTTLE_RANGE: [f64; 2] = [0.02, 50.0];
/// Pixels of a touchpad's scroll that count as one notch.
const PIXELS_PER_NOTCH: f32 = 40.0;
/// Roll about the line of sight, in radians per second.
const ROLL_SPEED: f64 = 0.9;
/// Turn per pixel of mouse motion, as a share of the vertical field of view.
const MOUSE_TURN: f64 = 1.0 / 500.0;
/// Turn per second by a stick, as a share of the vertical field of view.
const STICK_TURN: f64 = 1.0;

pub(crate) fn plugin(app: &mut App) {
    app.insert_resource(Pilot {
        throttle: 1.0,
        free_look: false,
    })
    .add_systems(
        Update,
        (
            set_throttle
                .after(locate_pointer)
                .run_if(pointer_over_picture),
            grab_mouse,
            steer_camera,
        )
            .chain(),
    );
}

fn set_throttle(scroll: Res<AccumulatedMouseScroll>, mut pilot: ResMut<Pilot>) {
    let notches = match scroll.unit {
        MouseScrollUnit::Line => scroll.delta.y,
        MouseScrollUnit::Pixel => scroll.delta.y / PIXELS_PER_NOTCH,
    };
    if notches != 0.0 {
        let [slowest, fastest] = THROTTLE_RANGE;
        pilot.throttle =
            (pilot.throttle * THROTTLE_NOTCH.powf(f64::from(notches))).clamp(slowest, fastest);
    }
}

/// One key grabs and frees the mouse. Another key, and losing the focus, free it.
pub(crate) fn grab_mouse(
    mut commands: MessageReader<AppCommand>,
    buttons: Res<ButtonInput<MouseButton>>,
    bindings: Res<Bindings>,
    mut pilot: ResMut<Pilot>,
    mut toast: ResMut<Toast>,
    window: Single<(&Window, &mut CursorOptions), With<PrimaryWindow>>,
) {
    let (window, mut cursor) = window.into_inner();
    for _ in commands
        .read()
        .filter(|command| **command == AppCommand::MouseLook)
    {
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
    let grabbed = window.focused && (pilot.free_look || buttons.pressed(MouseButton::Right));
    let mode = if grabbed {
        CursorGrabMode::Locked
    } else {
        CursorGrabMode::None
    };
    if cursor.grab_mode != mode || cursor.visible == grabbed {
        cursor.grab_mode = mode;
        cursor.visible = !grabbed;
    }
}

fn steer_camera(
    held: HeldControls,
    buttons: Res<ButtonInput<MouseButton>>,
    motion: Res<AccumulatedMouseMotion>,
    time: Res<Time>,
    pilot: Res<Pilot>,
    mut scene: ResMut<CurrentScene>,
    mut toast: ResMut<Toast>,
) {
    let seconds = time.delta_secs_f64().min(MAX_FRAME_SECONDS);
    let (left, right) = (held.pads.left_stick(), held.pads.right_stick());
    let thrust = DVec3::new(
        held.axis(FlightInput::Right, FlightInput::Left) + left.x,
        held.axis(FlightInput::Up, FlightInput::Down),
        held.axis(FlightInput::Forward, FlightInput::Backward) + left.y,
    );
    let gear = GEAR.powf(held.axis(FlightInput::Faster, FlightInput::Slower));
    let roll = held.axis(FlightInput::RollRight, FlightInput::RollLeft) * ROLL_SPEED * seconds;
    let looks = !held.typing.0 && (pilot.free_look || buttons.pressed(MouseButton::Right));
    let mouse = if looks {
        motion.delta.as_dvec2()
    } else {
        DVec2::ZERO
    };
    // Right and up, as shares of the field of view.
    let look = mouse * DVec2::new(MOUSE_TURN, -MOUSE_TURN) + right * STICK_TURN * seconds;
    if thrust == DVec3::ZERO && roll == 0.0 && look == DVec2::ZERO {
        return;
    }
    let steering = Steering {
        thrust: thrust.clamp_length_max(1.0),
        turn: (look * scene.camera.fov_deg.to_radians()).extend(roll),
        speed: gear * pilot.throttle,
        seconds,
    };
    match steered(&scene, &steering) {
        Ok(Steered {
            scene: next,
            replaced,
        }) => {
            if let Some(kinds) = replaced {
                toast.say(observer_change(kinds));
            }
            scene.0 = next;
        }
        Err(reason) => toast.say(format!("The camera cannot fly there: {reason}")),
    }
}

/// Says that another observer has taken the place of one that cannot exist.
fn observer_change(kinds: [ObserverKind; 2]) -> String {
    let [wanted, nearest] = kinds.map(|kind| kind.properties().motion);
    format!("Observer: {nearest}, for {wanted} is not possible here")
}
