//! What the hand does in a frame: the keys, the mouse, a gamepad and fingers together.

use super::orbit_camera::OrbitStep;
use super::pilot::Pilot;
use super::ship::Stick;
use super::steering::Steering;
use crate::app::controls::control::FlightInput;
use crate::app::input::held::HeldControls;
use crate::app::input::touch::Fingers;
use crate::app::state::MAX_FRAME_SECONDS;
use crate::app::state::helm::FingerPushes;
use crate::app::state::preferences::Preferences;
use bevy::ecs::system::SystemParam;
use bevy::input::mouse::AccumulatedMouseMotion;
use bevy::prelude::*;
use glam::{DVec2, DVec3};
use lightfall_core::scene::Scene;
use std::f64::consts::PI;

/// Roll about the line of sight, in radians per second.
const ROLL_SPEED: f64 = 0.9;
/// Turn per pixel of mouse motion, as a share of the vertical field of view.
const MOUSE_TURN: f64 = 1.0 / 500.0;
/// Turn per second by a stick or a key, as a share of the vertical field of view.
const STICK_TURN: f64 = 1.0;
/// Way of the orbit camera around the hole, in radians: per pixel of mouse motion, and per second
/// by a key or a stick.
const ORBIT_TURN: f64 = 0.005;
const ORBIT_SPEED: f64 = 0.7;
/// Seconds of flight by which one notch of the wheel moves the orbit camera in or out.
const ORBIT_NOTCH_SECONDS: f64 = 0.25;
/// Way of the orbit camera around the hole, in radians, by a finger that is dragged over the whole
/// height of the window.
const ORBIT_DRAG: f64 = PI;
/// Seconds of flight by which two fingers that are spread by a factor of e move the orbit camera in:
/// its distance then shrinks by about that factor.
const ORBIT_SPREAD_SECONDS: f64 = 2.5;
/// Shift flies faster and Alt slower by this factor.
pub(crate) const GEAR: f64 = 4.0;

/// What the hand's input is read from.
#[derive(SystemParam)]
pub(super) struct HandInputs<'w, 's> {
    held: HeldControls<'w, 's>,
    buttons: Res<'w, ButtonInput<MouseButton>>,
    motion: Res<'w, AccumulatedMouseMotion>,
    fingers: Res<'w, Fingers>,
    finger_pushes: Res<'w, FingerPushes>,
    preferences: Res<'w, Preferences>,
    time: Res<'w, Time>,
}

impl HandInputs<'_, '_> {
    /// The seconds that count for this frame.
    pub(super) fn seconds(&self) -> f64 {
        self.time.delta_secs_f64().min(MAX_FRAME_SECONDS)
    }

    /// The input in this frame.
    pub(super) fn hand(&self, pilot: &Pilot) -> Hand {
        let (held, fingers) = (&self.held, &self.fingers);
        let settings = &self.preferences.settings;
        let (left, right) = (held.pads.left_stick(), held.pads.right_stick());
        let thrust = DVec3::new(
            held.axis(FlightInput::Right, FlightInput::Left) + left.x,
            held.axis(FlightInput::Up, FlightInput::Down),
            held.axis(FlightInput::Forward, FlightInput::Backward) + left.y,
        );
        let arrows = DVec2::new(
            held.axis(FlightInput::LookRight, FlightInput::LookLeft),
            held.axis(FlightInput::LookUp, FlightInput::LookDown),
        );
        let up = DVec2::new(1.0, if settings.invert_y { -1.0 } else { 1.0 });
        let mouse = if !held.typing.is_on() && looks(pilot, &self.buttons) {
            self.motion.delta.as_dvec2() * DVec2::new(1.0, -1.0) * settings.mouse_sensitivity
        } else {
            DVec2::ZERO
        };
        let [faster, slower] = [FlightInput::Faster, FlightInput::Slower];
        Hand {
            thrust: thrust.clamp_length_max(1.0),
            stick: right * up + arrows,
            mouse: mouse * up,
            finger: fingers.drag,
            spread: fingers.spread,
            turn: fingers.turn,
            roll: held.axis(FlightInput::RollRight, FlightInput::RollLeft),
            gear: GEAR.powf(held.axis(faster, slower)),
            key_gear: GEAR.powf(held.key_axis(faster, slower)),
            pushes: held.pads.strength(faster) - held.pads.strength(slower)
                + f64::from(u8::from(self.finger_pushes.0)),
        }
    }
}

/// Whether the mouse moves the camera.
pub(super) fn looks(pilot: &Pilot, buttons: &ButtonInput<MouseButton>) -> bool {
    pilot.free_look || pilot.drags || buttons.pressed(MouseButton::Right)
}

/// The user's input to flying in one frame.
pub(super) struct Hand {
    /// Thrust toward the camera's right, up and forward, of length one at most.
    thrust: DVec3,
    /// Turn to the right and up by sticks and keys, and motion of the mouse in pixels, up being positive.
    stick: DVec2,
    mouse: DVec2,
    /// Way of a dragging finger to the right and up, as a share of the window's height; power of e by
    /// which two fingers are spread, and their clockwise turn in radians.
    finger: DVec2,
    spread: f64,
    turn: f64,
    roll: f64,
    /// Factor of the speed by keys and a gamepad's triggers, and by keys alone.
    gear: f64,
    key_gear: f64,
    /// Thrust along the ship's nose by the right trigger against the left one, and by the finger's button.
    pushes: f64,
}

impl Hand {
    /// The steering in free flight. `None` if there is no input.
    pub(super) fn steering(&self, scene: &Scene, throttle: f64, seconds: f64) -> Option<Steering> {
        let turn = self.look(scene, seconds);
        (self.thrust != DVec3::ZERO || turn != DVec3::ZERO).then_some(Steering {
            thrust: self.thrust,
            turn,
            speed: self.gear * throttle,
            seconds,
        })
    }

    /// The turn to the right, up and clockwise, in radians.
    fn look(&self, scene: &Scene, seconds: f64) -> DVec3 {
        // Right and up, as shares of the field of view. The picture follows fingers, so the camera turns
        // the other way.
        let look = self.mouse * MOUSE_TURN + self.stick * STICK_TURN * seconds - self.finger;
        let roll = self.roll * ROLL_SPEED * seconds - self.turn;
        let half_height = scene.camera.half_angles(scene.picture.size().as_dvec2()).y;
        (look * 2.0 * half_height).extend(roll)
    }

    /// What the hand does at the ship's controls.
    pub(super) fn stick(&self, scene: &Scene, seconds: f64) -> Stick {
        let [right, up, forward] = self.thrust.to_array();
        let [turn_right, turn_up, roll] = self.look(scene, seconds).to_array();
        let thrust = DVec3::new(forward + self.pushes, -right, up);
        Stick {
            thrust: thrust.clamp_length_max(1.0),
            turn: DVec3::new(roll, -turn_up, -turn_right),
            gear: self.key_gear,
        }
    }

    /// The step of the orbit camera, or `None` without input. The mouse and a finger drag the picture,
    /// so the camera goes the other way.
    pub(super) fn orbit_step(&self, notches: f64, seconds: f64) -> Option<OrbitStep> {
        let keys = self.thrust.truncate() + self.stick;
        let drag = self.mouse * ORBIT_TURN + self.finger * ORBIT_DRAG;
        let around = keys * ORBIT_SPEED * self.gear * seconds - drag;
        let approach = notches * ORBIT_NOTCH_SECONDS + self.spread * ORBIT_SPREAD_SECONDS;
        let rise = -(self.thrust.z * self.gear * seconds + approach);
        let roll = self.roll * ROLL_SPEED * seconds;
        (around != DVec2::ZERO || rise != 0.0 || roll != 0.0).then_some(OrbitStep {
            around,
            rise: rise.signum(),
            time: rise.abs(),
            roll,
        })
    }
}
