//! One frame of flying by hand: the new camera position, in f64, and the observer there.
//!
//! Flying by hand keeps the hole in the picture. Thrust sideways leads round the hole at the same
//! radius, and the camera is carried along, so that the hole keeps its place on the screen. Thrust
//! inward slows down while the hole fills the view.

use glam::{DMat3, DVec3};
use lightfall_core::gpu::{Drawable, Undrawable};
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::scene::{MAX_RADIUS, ObserverKind, Scene};

/// Speed per second: inward as a share of the distance to the horizon, outward and sideways as a
/// share of the radius.
const SPEED: f64 = 0.4;
/// Shares of half the picture's width that the hole fills where flying inward begins to slow down,
/// and where it is slowest.
const SLOWING_SHARES: [f64; 2] = [0.35, 1.0];
/// The slowest speed inward and sideways, as shares of the usual one.
const MIN_PACE_INWARD: f64 = 0.08;
const MIN_PACE_SIDEWAYS: f64 = 0.25;
/// The speed inward, as a share of the usual one, below which thrust inward counts as faded.
const FADED_PACE: f64 = 0.3;
/// Share of half the picture's width below which the hole is small, and flying outward no longer
/// gets faster with the radius.
const SMALL_SHARE: f64 = 0.02;
/// Minimum radius that flying reaches from outside, in r_s. Without spin, a static observer there
/// is still an ordinary one.
pub(crate) const MIN_RADIUS: f64 = 1.08;
/// Share of the thrust that has to lead inward for the hand to be told that it goes no farther.
const MIN_INWARD_SHARE: f64 = 0.3;

/// The user's steering in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steering {
    /// Thrust toward the camera's right, up and forward, of length one at most.
    pub thrust: DVec3,
    /// Turns in radians: to the right, up, clockwise.
    pub turn: DVec3,
    /// Factor of the usual speed.
    pub speed: f64,
    /// Length of the frame, in seconds.
    pub seconds: f64,
}

/// The scene after a frame of flying by hand.
#[derive(Clone, Debug, PartialEq)]
pub struct Steered {
    /// The scene.
    pub scene: Drawable,
    /// The observer that was wanted there and cannot exist, and the one that took its place.
    pub replaced: Option<[ObserverKind; 2]>,
    /// What kept the thrust from leading farther.
    pub stopped_by: Option<Barrier>,
}

/// What a camera flown by hand cannot pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Barrier {
    /// The smallest radius of a camera flown by hand, from outside.
    MinRadius,
    /// The horizon, from inside: no thrust leads outward there, or holds the radius.
    Horizon,
}

/// Flies for one frame.
///
/// Thrust takes the camera off a circular orbit and brings it to rest. Where the wanted observer
/// cannot exist, as an observer at rest in the ergosphere, the nearest one that exists flies on, so
/// that the picture never stands still while the camera moves. Inside the horizon the camera turns,
/// but thrust does nothing.
///
/// # Errors
/// The scene cannot be drawn from there with any observer.
pub fn steered(scene: &Drawable, steering: &Steering) -> Result<Steered, Undrawable> {
    let mut next = scene.scene().clone();
    let camera = &mut next.camera;
    camera.set_orientation(camera.heading() * turned(steering.turn));
    let stopped_by = if steering.thrust == DVec3::ZERO {
        None
    } else {
        let thrust = camera.tetrad() * camera.heading() * steering.thrust;
        let [speed, seconds] = [steering.speed, steering.seconds];
        move_camera(&mut next, thrust, speed * seconds)
    };
    settled(next, stopped_by)
}

/// The scene with an observer that exists at its camera's place.
pub(super) fn settled(scene: Scene, stopped_by: Option<Barrier>) -> Result<Steered, Undrawable> {
    let wanted = scene.observer.kind;
    let (scene, nearest) = Drawable::with_nearest_observer(scene)?;
    Ok(Steered {
        scene,
        replaced: nearest.map(|nearest| [wanted, nearest]),
        stopped_by,
    })
}

/// Moves the camera by a thrust in the hole's frame, of length one at most, for a `time` in seconds
/// at the usual speed. Takes it off a circular orbit.
fn move_camera(scene: &mut Scene, thrust: DVec3, time: f64) -> Option<Barrier> {
    if is_inside(scene) {
        return Some(Barrier::Horizon);
    }
    if scene.observer.kind == ObserverKind::Orbit {
        scene.observer.kind = ObserverKind::Static;
    }
    let pace = Pace::of(scene);
    let camera = &mut scene.camera;
    let outward = camera.direction();
    let rise = thrust.dot(outward);
    let aside = thrust - rise * outward;
    let angle = aside.length() * SPEED * pace.sideways * time;
    let (r, stopped) = radius_after(scene, rise, time, &pace);
    let camera = &mut scene.camera;
    if let Some(axis) = outward.cross(aside).try_normalize() {
        let rotation = DMat3::from_axis_angle(axis, angle);
        let world_from_camera = camera.tetrad() * camera.heading();
        camera.set_pose(rotation * outward, rotation * world_from_camera);
    }
    camera.r = r;
    stopped.filter(|_| rise < -MIN_INWARD_SHARE * thrust.length())
}

/// The radius after rising by the share `rise` of full thrust for a `time` in seconds at the usual
/// speed, and what stopped the way inward.
pub(super) fn radius_after(
    scene: &Scene,
    rise: f64,
    time: f64,
    pace: &Pace,
) -> (f64, Option<Barrier>) {
    let camera = &scene.camera;
    let min = camera.r.min(MIN_RADIUS);
    if rise >= 0.0 {
        let speed = SPEED * camera.r * pace.outward;
        return ((camera.r + rise * speed * time).min(MAX_RADIUS), None);
    }
    let gap = camera.r - scene.kerr().horizon();
    // The distance shrinks by the same factor in every second, however long a frame is.
    let r = camera.r + gap * (rise * SPEED * pace.inward * time).exp_m1();
    if r <= min {
        (min, Some(Barrier::MinRadius))
    } else {
        (r, None)
    }
}

/// Factors of the usual speed that follow from how large the hole appears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pace {
    inward: f64,
    sideways: f64,
    outward: f64,
}

impl Pace {
    /// The factors for the scene's camera. One each where the hole's size is not known.
    pub(super) fn of(scene: &Scene) -> Self {
        let half_width = scene.camera.half_angles(scene.picture.size().as_dvec2()).x;
        let share =
            ApparentHole::new(scene).map_or(SLOWING_SHARES[0], |hole| hole.radius / half_width);
        let [from, to] = SLOWING_SHARES;
        let filled = ((share - from) / (to - from)).clamp(0.0, 1.0);
        let eased = filled * filled * (3.0 - 2.0 * filled);
        Self {
            inward: 1.0 - (1.0 - MIN_PACE_INWARD) * eased,
            sideways: 1.0 - (1.0 - MIN_PACE_SIDEWAYS) * eased,
            outward: (share / SMALL_SHARE).min(1.0),
        }
    }
}

/// Whether the hole fills so much of the view that thrust inward leads almost nowhere.
#[must_use]
pub fn thrust_fades(scene: &Scene) -> bool {
    Pace::of(scene).inward < FADED_PACE
}

/// Whether the camera is at or inside the horizon.
pub(crate) fn is_inside(scene: &Scene) -> bool {
    scene.camera.r <= scene.kerr().horizon()
}

/// The turn to the right, then up, then clockwise, as a matrix of the camera's own axes (right, up,
/// forward).
pub(super) fn turned(turn: DVec3) -> DMat3 {
    // Right, up, forward is a left-handed triple, so glam's positive turns go the opposite way.
    DMat3::from_rotation_y(turn.x)
        * DMat3::from_rotation_x(-turn.y)
        * DMat3::from_rotation_z(-turn.z)
}
