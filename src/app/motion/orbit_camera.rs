//! The orbit camera: the hand moves the camera around the hole at the same radius, and the camera
//! always faces the hole. It begins with the disk level, and keeps the roll that the hand gives it.

use super::facing::{Aim, Facing, aimed};
use super::steering::{Barrier, Pace, Steered, is_inside, radius_after, settled, turned};
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::history::History;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use glam::{DVec2, DVec3};
use lightfall_core::geometry::sphere::wrap_degrees;
use lightfall_core::gpu::{Drawable, Undrawable};
use lightfall_core::scene::{ObserverKind, Scene};
use lightfall_render::CurrentScene;

/// The smallest angle from the axis, in degrees: nearer to a pole no direction is level.
const MIN_AXIS_ANGLE_DEG: f64 = 1.0;

/// Whether the orbit camera is on.
#[derive(Resource, Default)]
pub(crate) struct OrbitCamera {
    /// The loaded scene when it was switched on. Another one switches it off.
    loaded: Option<Box<Scene>>,
}

impl OrbitCamera {
    /// Whether the hand moves the camera around the hole.
    pub(crate) fn is_on(&self) -> bool {
        self.loaded.is_some()
    }

    /// The mode and how to leave it, in one line. Empty while the orbit camera is off.
    pub(crate) fn status(&self, bindings: &Bindings) -> String {
        if self.is_on() {
            format!("Orbit camera · {} ends it", bindings.label("fly.orbit"))
        } else {
            String::new()
        }
    }
}

/// The user's hand on the orbit camera in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitStep {
    /// Way around the hole to the camera's right and up, in radians.
    pub around: DVec2,
    /// Thrust outward, from -1 to 1, for a time in seconds at the usual speed.
    pub rise: f64,
    /// See `rise`.
    pub time: f64,
    /// Clockwise roll, in radians.
    pub roll: f64,
}

/// Moves the camera around the hole for one frame, and faces it to the hole. Its roll against the
/// level stays as it is, but for that of the step.
///
/// As in flying by hand, the camera is taken off a circular orbit, and the nearest observer that
/// exists takes the place of one that does not.
///
/// # Errors
/// The scene cannot be drawn from there with any observer.
pub fn orbited(scene: &Drawable, step: &OrbitStep) -> Result<Steered, Undrawable> {
    let mut next = scene.scene().clone();
    if is_inside(&next) {
        return settled(next, Some(Barrier::Horizon));
    }
    if next.observer.kind == ObserverKind::Orbit {
        next.observer.kind = ObserverKind::Static;
    }
    let (r, stopped_by) = radius_after(&next, step.rise, step.time, &Pace::of(&next));
    let camera = &mut next.camera;
    camera.r = r;
    if step.around != DVec2::ZERO {
        let [right, up] = step.around.to_array().map(f64::to_degrees);
        camera.phi_deg = wrap_degrees(camera.phi_deg + right);
        camera.theta_deg =
            (camera.theta_deg - up).clamp(MIN_AXIS_ANGLE_DEG, 180.0 - MIN_AXIS_ANGLE_DEG);
    }
    let roll = roll_against_level(scene) + step.roll;
    let steered = settled(next, stopped_by)?;
    let mut facing = steered.scene.scene().clone();
    if let Some(level) = aimed(&facing, Aim::Hole) {
        facing
            .camera
            .set_orientation(level * turned(DVec3::new(0.0, 0.0, roll)));
    }
    Ok(Steered {
        scene: Drawable::new(facing)?,
        ..steered
    })
}

/// The clockwise roll, in radians, of a camera that faces the hole.
fn roll_against_level(scene: &Scene) -> f64 {
    aimed(scene, Aim::Hole).map_or(0.0, |level| {
        let up = level.transpose() * scene.camera.heading().y_axis;
        up.x.atan2(up.y)
    })
}

/// Switches the orbit camera on and off by its key, and off when another motion begins or another
/// scene is loaded.
pub(crate) fn switch_orbit_camera(
    mut commands: MessageReader<AppCommand>,
    scene: Res<CurrentScene>,
    history: Res<History>,
    bindings: Res<Bindings>,
    mut orbit: ResMut<OrbitCamera>,
    mut facing: ResMut<Facing>,
    mut toast: ResMut<Toast>,
) {
    if orbit
        .loaded
        .as_deref()
        .is_some_and(|loaded| loaded != history.loaded())
    {
        orbit.loaded = None;
    }
    for command in commands.read() {
        match command {
            AppCommand::OrbitCamera if orbit.is_on() => {
                orbit.loaded = None;
                facing.stop();
                toast.say("Free flight");
            }
            AppCommand::OrbitCamera if is_inside(&scene) => {
                toast.say("Inside the horizon nothing can go round the hole");
            }
            AppCommand::OrbitCamera => {
                orbit.loaded = Some(Box::new(history.loaded().clone()));
                facing.start(Aim::Hole, &scene);
                let [left, right, nearer, farther, end] = [
                    "fly.left",
                    "fly.right",
                    "fly.forward",
                    "fly.backward",
                    "fly.orbit",
                ]
                .map(|id| bindings.label(id));
                toast.say(format!(
                    "Orbit camera: drag or {left} {right} go round, {nearer} {farther} nearer and farther; {end} ends it"
                ));
            }
            AppCommand::Face
            | AppCommand::LetGo
            | AppCommand::TakeControls
            | AppCommand::Journey
            | AppCommand::RestartJourney => orbit.loaded = None,
            _ => {}
        }
    }
}
