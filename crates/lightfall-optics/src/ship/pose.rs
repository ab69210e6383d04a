//! From a scene's observer to a ship, and back.

use glam::{DMat3, DMat4, DVec3, DVec4, Vec4Swizzles};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::{ObserverError, min_infall_radius};
use lightfall_model::geometry::ship::{
    Place, Ship, ShipError, boost, components, rain_axes, zamo_axes,
};
use lightfall_model::geometry::sphere::{celestial_frame, wrap_degrees};
use lightfall_model::geometry::tetrad::transformation;
use lightfall_model::scene::{MAX_RADIUS, ObserverKind, Scene};
use thiserror::Error;

/// How near to the horizon a radius counts as the horizon's, as a share of it. A place that is
/// written and read again differs by rounding, and at the horizon itself the scene's azimuth is
/// another one than just outside.
const HORIZON_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// How a camera is mounted on a ship: its axes right, up and forward on the ship's axes, one per
/// column. The ship's axes are right-handed, and those of a camera are not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mount(pub DMat3);

impl Mount {
    /// Looks along the nose, which is the ship's first axis; its third axis is up.
    pub const NOSE: Self = Self(DMat3::from_cols(DVec3::NEG_Y, DVec3::Z, DVec3::X));
}

/// Why a scene's observer cannot become a ship.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum BoardError {
    /// There is no such observer.
    #[error(transparent)]
    Observer(#[from] ObserverError),
    /// There is no such ship.
    #[error(transparent)]
    Ship(#[from] ShipError),
}

/// The ship that moves as the scene's observer and turns the camera as the scene does. Its clock and
/// its disk's clock stand at zero: T is `camera_time_lead(r)` minus r.
///
/// # Errors
/// The scene's observer does not exist, or is where no flight is followed.
pub fn board(scene: &Scene, mount: &Mount) -> Result<Ship, BoardError> {
    let (kerr, camera, observer) = (scene.kerr(), &scene.camera, &scene.observer);
    scene.observer_at_camera(observer.kind, observer.velocity)?;
    let (r, [theta, phi]) = (camera.r, camera.polar_angles());
    let azimuth = phi + kerr.camera_azimuth_lead(r);
    let [n, ..] = celestial_frame(theta, azimuth);
    let place = Place::at(kerr, r, n);
    let axes = kind_axes(scene, &place, azimuth)? * boost(momentum(observer.velocity));
    let time = kerr.camera_time_lead(r) - r;
    let mut ship = Ship::new(&place, time, &axes, [min_infall_radius(kerr), MAX_RADIUS])?;
    ship.turn(camera.heading() * mount.0.transpose());
    Ok(ship)
}

/// The axes of the observer of the scene's kind, without the velocity of its own.
fn kind_axes(scene: &Scene, place: &Place, azimuth: f64) -> Result<DMat4, ObserverError> {
    let kind = scene.observer.kind;
    let (ObserverKind::Static | ObserverKind::Zamo | ObserverKind::Orbit, Some(zamo)) =
        (kind, zamo_axes(place, azimuth))
    else {
        return Ok(rain_axes(place, azimuth));
    };
    let [theta, phi] = scene.camera.polar_angles();
    let matrix = |kind| scene.observer_at_camera(kind, [0.0; 3]);
    let (from, to) = (matrix(kind)?, matrix(ObserverKind::Zamo)?);
    // Each of these observers is boosted along phi alone.
    let along_phi = -transformation(&from, &to, theta, phi).x_axis.w;
    Ok(zamo * boost(along_phi * DVec3::Z))
}

/// gamma v.
fn momentum(velocity: [f64; 3]) -> DVec3 {
    let velocity = DVec3::from_array(velocity);
    let speed = velocity.length();
    velocity / ((1.0 - speed) * (1.0 + speed)).sqrt()
}

/// Writes the ship's place, motion and turn to the scene: `rain` with a velocity, and the camera that
/// is mounted so. The scene's disk keeps its time.
///
/// # Errors
/// The ship is so fast, relative to `rain`, that its velocity rounds to that of light. The scene is
/// not changed then.
pub fn write_scene(ship: &Ship, mount: &Mount, scene: &mut Scene) -> Result<(), ObserverError> {
    let (kerr, place) = (ship.kerr(), ship.place());
    let r = radius(kerr, place.r);
    let lead = kerr.camera_azimuth_lead(r);
    // On the axis every azimuth is right, and the last one leaves the axes unchanged.
    let azimuth = place
        .azimuth()
        .unwrap_or(scene.camera.phi_deg.to_radians() + lead);
    let rain = rain_axes(&place, azimuth);
    let on_rain = components(&rain, ship.velocity());
    let momentum = on_rain.yzw();
    let velocity = (momentum / (1.0 + momentum.length_squared()).sqrt()).to_array();
    if DVec3::from_array(velocity).length() >= 1.0 {
        return Err(ObserverError::Velocity { velocity });
    }
    let observer = rain * boost(momentum);
    let frame = ship.frame();
    let on_observer = |axis: DVec4| components(&observer, axis).yzw();
    let rotation = DMat3::from_cols(
        on_observer(frame.y_axis),
        on_observer(frame.z_axis),
        on_observer(frame.w_axis),
    );
    let camera = &mut scene.camera;
    camera.r = r;
    camera.theta_deg = place.theta().to_degrees();
    if place.azimuth().is_some() {
        camera.phi_deg = wrap_degrees((azimuth - lead).to_degrees());
    }
    camera.set_orientation(rotation * mount.0);
    (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, velocity);
    Ok(())
}

/// The radius as a scene has it: within the limits of motion, and exactly the horizon's where it
/// differs from it by rounding.
pub(super) fn radius(kerr: Kerr, r: f64) -> f64 {
    let horizon = kerr.horizon();
    if (r / horizon - 1.0).abs() <= HORIZON_ROUNDING {
        horizon
    } else {
        r.clamp(min_infall_radius(kerr), MAX_RADIUS)
    }
}
