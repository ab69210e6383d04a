//! Flying by hand: keys, mouse and gamepad move and turn the camera; the result is written to the
//! scene, in f64.

use super::{MAX_FRAME_SECONDS, MIN_FLIGHT_RADIUS};
use crate::app::controls::table::{Command, FlightInput};
use crate::app::input::keyboard::Held;
use crate::app::state::toast::Toast;
use crate::app::ui::dock::{look, over_picture};
use crate::render::CurrentScene;
use bevy::input::mouse::{AccumulatedMouseMotion, AccumulatedMouseScroll, MouseScrollUnit};
use bevy::math::{DMat3, DVec2, DVec3};
use bevy::prelude::*;
use bevy::window::{CursorGrabMode, CursorOptions, PrimaryWindow};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::gpu::{Drawable, Undrawable};
use lightfall_core::scene::{MAX_RADIUS, ObserverKind};

/// How the hand is on the stick.
#[derive(Resource)]
pub(crate) struct Pilot {
    /// Multiplies the speed, set by the wheel.
    pub(crate) throttle: f64,
    /// Whether the mouse looks around without a button being held.
    free_look: bool,
}

/// Speed, as a share of the distance to the horizon, per second.
const SPEED: f64 = 0.4;
/// Shift flies faster, Alt slower, by this factor.
const GEAR: f64 = 4.0;
/// Speed changes by this factor per notch of the wheel, within a range.
const THROTTLE_NOTCH: f64 = 1.15;
const THROTTLE_RANGE: [f64; 2] = [0.02, 50.0];
/// Pixels of a touchpad's scroll that count as one notch.
const PIXELS_PER_NOTCH: f32 = 40.0;
/// Radians a second about the line of sight.
const ROLL_SPEED: f64 = 0.9;
/// Share of the vertical field of view that one pixel of mouse motion turns.
const LOOK_SHARE: f64 = 1.0 / 500.0;
/// Share of it that a stick turns in a second.
const STICK_SHARE: f64 = 1.0;

pub(crate) fn plugin(app: &mut App) {
    app.insert_resource(Pilot {
        throttle: 1.0,
        free_look: false,
    })
    .add_systems(
        Update,
        (
            set_throttle.after(look).run_if(over_picture),
            hold_mouse,
            steer,
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

/// A key takes and gives back the mouse, another and losing the focus give it back.
fn hold_mouse(
    mut commands: MessageReader<Command>,
    buttons: Res<ButtonInput<MouseButton>>,
    mut pilot: ResMut<Pilot>,
    window: Single<(&Window, &mut CursorOptions), With<PrimaryWindow>>,
) {
    let (window, mut cursor) = window.into_inner();
    for command in commands.read() {
        match command {
            Command::MouseLook => pilot.free_look = !pilot.free_look,
            Command::Escape => pilot.free_look = false,
            _ => {}
        }
    }
    if !window.focused {
        pilot.free_look = false;
    }
    let held = window.focused && (pilot.free_look || buttons.pressed(MouseButton::Right));
    let mode = if held {
        CursorGrabMode::Locked
    } else {
        CursorGrabMode::None
    };
    if cursor.grab_mode != mode || cursor.visible == held {
        cursor.grab_mode = mode;
        cursor.visible = !held;
    }
}

fn steer(
    held: Held,
    buttons: Res<ButtonInput<MouseButton>>,
    motion: Res<AccumulatedMouseMotion>,
    time: Res<Time>,
    pilot: Res<Pilot>,
    mut scene: ResMut<CurrentScene>,
    mut toast: ResMut<Toast>,
) {
    let seconds = time.delta_secs_f64().min(MAX_FRAME_SECONDS);
    let (left, right) = (held.pads.left_stick(), held.pads.right_stick());
    // Camera frame: right, up, forward.
    let thrust = DVec3::new(
        held.axis(FlightInput::Right, FlightInput::Left) + left.x,
        held.axis(FlightInput::Up, FlightInput::Down),
        held.axis(FlightInput::Forward, FlightInput::Backward) + left.y,
    );
    let gear = GEAR.powf(held.axis(FlightInput::Faster, FlightInput::Slower));
    let roll = held.axis(FlightInput::RollRight, FlightInput::RollLeft) * ROLL_SPEED * seconds;
    let looking = !held.typing.0 && (pilot.free_look || buttons.pressed(MouseButton::Right));
    let mouse = if looking {
        motion.delta.as_dvec2()
    } else {
        DVec2::ZERO
    };
    // Right and up, as shares of the field of view.
    let look = mouse * DVec2::new(LOOK_SHARE, -LOOK_SHARE) + right * STICK_SHARE * seconds;
    if thrust == DVec3::ZERO && roll == 0.0 && look == DVec2::ZERO {
        return;
    }
    let input = Steering {
        thrust: thrust.clamp_length_max(1.0),
        turn: (look * scene.camera.fov_deg.to_radians()).extend(roll),
        speed: gear * pilot.throttle,
        seconds,
    };
    match steered(&scene, &input) {
        Ok((next, replaced)) => {
            if let Some(kind) = replaced {
                toast.say(format!(
                    "No observer {} can exist here: the camera flies on as {}",
                    scene.observer.kind.word(),
                    kind.word()
                ));
            }
            scene.0 = next;
        }
        Err(reason) => toast.say(format!("The camera cannot fly there: {reason}")),
    }
}

/// What the hand asks for in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steering {
    /// Toward the camera's right, up and forward; of length one at most.
    pub thrust: DVec3,
    /// Turns in radians: to the right, up, clockwise.
    pub turn: DVec3,
    /// Factor of the usual speed.
    pub speed: f64,
    /// Length of the frame, in seconds.
    pub seconds: f64,
}

/// The scene after a frame of flying by hand. Thrust takes the camera off a circular orbit: it is
/// then at rest, or, where nothing can be at rest, the nearest observer that exists. The second
/// value is the kind of observer that had to take the place of another.
///
/// # Errors
/// Why the scene cannot be drawn with the camera there.
pub fn steered(
    scene: &Drawable,
    steering: &Steering,
) -> Result<(Drawable, Option<ObserverKind>), Undrawable> {
    let Steering {
        thrust,
        turn,
        speed,
        seconds,
    } = *steering;
    let mut scene = scene.scene().clone();
    if thrust != DVec3::ZERO && scene.observer.kind == ObserverKind::Orbit {
        scene.observer.kind = ObserverKind::Static;
    }
    let kerr = Kerr {
        spin: scene.hole.spin,
    };
    let horizon = kerr.horizon();
    let camera = &mut scene.camera;
    let mut world_from_camera = camera.tetrad() * camera.tetrad_from_camera();
    world_from_camera *= turned(turn.x, turn.y, turn.z);
    let speed = SPEED * (camera.r - horizon).max(MIN_FLIGHT_RADIUS - 1.0) * speed;
    let moved = camera.direction() * camera.r + world_from_camera * thrust * speed * seconds;
    let position = if thrust == DVec3::ZERO {
        camera.direction() * camera.r
    } else {
        kept_outside(moved, camera.direction(), camera.r.min(MIN_FLIGHT_RADIUS))
    };
    let was_inside = camera.r <= horizon;
    camera.set_pose(position, world_from_camera);
    // Outside, the azimuth is Boyer-Lindquist's and no more the ingoing one; the picture stays.
    if was_inside && camera.r > horizon {
        camera.phi_deg =
            (camera.phi_deg - kerr.ingoing_azimuth_lead(camera.r).to_degrees()) % 360.0;
    }
    Drawable::with_nearest_observer(scene)
}

/// Turning the camera right, then up, then clockwise, as a matrix of its own axes (right, up,
/// forward).
fn turned(right: f64, up: f64, clockwise: f64) -> DMat3 {
    // Right, up, forward is a left-handed triple, so a positive turn of glam's is the other way
    // round about each axis.
    DMat3::from_rotation_y(right) * DMat3::from_rotation_x(-up) * DMat3::from_rotation_z(-clockwise)
}

/// The allowed place nearest to `position`: not within `nearest`, which is where the camera is if
/// it began within the usual limit. A camera that would fly through the centre stays on its side.
fn kept_outside(position: DVec3, side: DVec3, nearest: f64) -> DVec3 {
    let distance = position.length();
    if distance > 0.0 {
        position / distance * distance.clamp(nearest, MAX_RADIUS)
    } else {
        side * nearest
    }
}
