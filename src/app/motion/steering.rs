//! One frame of flying by hand: the new camera position, in f64, and the observer there.

use glam::{DMat3, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::gpu::{Drawable, Undrawable};
use lightfall_core::scene::{Camera, MAX_RADIUS, ObserverKind, Scene};

/// Speed per second, as a share of the distance to the horizon.
const SPEED: f64 = 0.4;
/// Minimum radius that flying reaches from outside, in r_s. Without spin, a static observer there
/// is still an ordinary one.
const MIN_RADIUS: f64 = 1.08;

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
}

/// Flies for one frame.
///
/// Thrust takes the camera off a circular orbit and brings it to rest. Where the wanted observer
/// cannot exist, as an observer at rest in the ergosphere, the nearest one that exists flies on, so
/// that the picture never stands still while the camera moves.
///
/// # Errors
/// The scene cannot be drawn from there with any observer.
pub fn steered(scene: &Drawable, steering: &Steering) -> Result<Steered, Undrawable> {
    let mut scene = scene.scene().clone();
    if steering.thrust == DVec3::ZERO {
        let camera = &mut scene.camera;
        camera.set_orientation(camera.tetrad_from_camera() * turned(steering.turn));
    } else {
        if scene.observer.kind == ObserverKind::Orbit {
            scene.observer.kind = ObserverKind::Static;
        }
        thrust(&mut scene, steering);
    }
    let wanted = scene.observer.kind;
    let (scene, nearest) = Drawable::with_nearest_observer(scene)?;
    Ok(Steered {
        scene,
        replaced: nearest.map(|nearest| [wanted, nearest]),
    })
}

/// Moves and turns the camera.
fn thrust(scene: &mut Scene, steering: &Steering) {
    let kerr = Kerr {
        spin: scene.hole.spin,
    };
    let horizon = kerr.horizon();
    let camera = &mut scene.camera;
    let world_from_camera = camera.tetrad() * camera.tetrad_from_camera() * turned(steering.turn);
    let speed = SPEED * (camera.r - horizon).max(MIN_RADIUS - 1.0) * steering.speed;
    let moved = camera.direction() * camera.r
        + world_from_camera * steering.thrust * speed * steering.seconds;
    let was_inside = camera.r <= horizon;
    put_at_nearest_place(camera, moved, world_from_camera);
    // Outside the horizon phi is the Boyer-Lindquist azimuth, inside it is Kerr's ingoing azimuth.
    // The picture stays as it is.
    if was_inside && camera.r > horizon {
        camera.phi_deg =
            (camera.phi_deg - kerr.ingoing_azimuth_lead(camera.r).to_degrees()) % 360.0;
    }
}

/// Puts the camera at the allowed place nearest to `position`: not nearer to the hole than
/// [`MIN_RADIUS`], or than it was if it was nearer. A camera that would fly through the centre
/// stays on its side.
fn put_at_nearest_place(camera: &mut Camera, position: DVec3, world_from_camera: DMat3) {
    let (min, side) = (camera.r.min(MIN_RADIUS), camera.direction());
    let distance = position.length();
    let position = if distance > 0.0 {
        position / distance * distance.clamp(min, MAX_RADIUS)
    } else {
        side * min
    };
    camera.set_pose(position, world_from_camera);
    // The length of the position is rounded, and the limits hold to the last bit.
    camera.r = camera.r.clamp(min, MAX_RADIUS);
}

/// The turn to the right, then up, then clockwise, as a matrix of the camera's own axes (right, up,
/// forward).
fn turned(turn: DVec3) -> DMat3 {
    // Right, up, forward is a left-handed triple, so glam's positive turns go the opposite way.
    DMat3::from_rotation_y(turn.x)
        * DMat3::from_rotation_x(-turn.y)
        * DMat3::from_rotation_z(-turn.z)
}
