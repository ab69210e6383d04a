//! Read-outs: what a scene's observer measures of its place, motion, light and forces, in units of
//! r_s and c.
//!
//! Every read-out is a pure function of the [`Scene`]. [`si`] converts them to metres and seconds
//! for a hole of a given mass, and [`units`] writes lengths and times.

mod shadow;
pub mod si;
mod strain;
pub mod units;

pub use shadow::{Shadow, shadow, shadow_radius};
pub use strain::{held_acceleration, held_acceleration_components, tide};

use crate::camera_rays::CameraRays;
use crate::echo::{ORDERS, echo};
use crate::hot_spot::HotSpot;
use crate::reference::Reference;
use crate::shift::{RestFrame, Shift};
use crate::trace::Outcome;
use lightfall_model::geometry::observer::{ObserverError, Photon};
use lightfall_model::geometry::tetrad::{four_velocity, relative_velocity};
use lightfall_model::scene::{Effects, ObserverKind, Scene};

/// The read-outs of a scene's observer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readout {
    /// Boyer-Lindquist radius, in r_s.
    pub r: f64,
    /// Boyer-Lindquist polar angle and azimuth, in degrees. At and inside the horizon the azimuth
    /// is Kerr's ingoing one.
    pub angles_deg: [f64; 2],
    /// Speed relative to the zero-angular-momentum observer at this place, in c; `None` at and
    /// inside the horizon.
    pub speed_for_zamo: Option<f64>,
    /// Speed relative to the observer at rest at this place, in c; `None` at and inside the static
    /// limit.
    pub speed_for_static: Option<f64>,
    /// d tau/dt: the observer's proper time over the time of clocks far away; `None` at and inside
    /// the horizon.
    pub time_dilation: Option<f64>,
    /// The light from straight ahead; `None` where it is dark.
    pub ahead: Option<LightAhead>,
    /// Angular radius of the hole's shadow, in radians; see [`shadow_radius`].
    pub shadow_radius: f64,
    /// Proper acceleration, in c^2/r_s, that holds `static` and `zamo` in place. Zero for observers
    /// in free fall: `orbit`, `rain`, and every observer with a velocity of its own.
    pub acceleration: f64,
    /// Largest tidal stretching: relative acceleration per distance, in c^2/r_s^2.
    pub tide: f64,
    /// The hot spot; `None` if the scene has none.
    pub hot_spot: Option<HotSpotReadout>,
}

/// The hot spot's motion, and the echo of its light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HotSpotReadout {
    /// How long it takes for one turn, in r_s/c.
    pub period: f64,
    /// The delays of its images of order 0, 1 and 2, in r_s/c; `None` for an image that is not
    /// known.
    pub delays: [Option<f64>; ORDERS as usize],
}

/// The light from straight ahead: from the first crossing of the disk, or else from the sky.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightAhead {
    /// Whether it comes from the disk.
    pub from_disk: bool,
    /// Observed over emitted frequency.
    pub shift: f64,
    /// The gravitational factor of the shift; `None` at and inside the horizon.
    pub gravitational_shift: Option<f64>,
}

impl Readout {
    /// The read-outs of the scene's observer. All effects are on here, whatever the scene says:
    /// these are the numbers of the world, not of the picture.
    ///
    /// # Errors
    /// If the scene's observer does not exist.
    pub fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let mut scene = scene.clone();
        scene.effects = Effects::default();
        let (camera, observer) = (&scene.camera, &scene.observer);
        let (kerr, r, [theta, phi]) = (scene.kerr(), camera.r, camera.polar_angles());
        let matrix = scene.observer_at_camera(observer.kind, observer.velocity)?;
        let speed = |kind| {
            scene
                .observer_at_camera(kind, [0.0; 3])
                .ok()
                .map(|frame| relative_velocity(&matrix, &frame, theta, phi).length())
        };
        let u = four_velocity(&matrix);
        let in_free_fall = observer.velocity != [0.0; 3];
        Ok(Self {
            r,
            angles_deg: [camera.theta_deg, camera.phi_deg],
            speed_for_zamo: speed(ObserverKind::Zamo),
            speed_for_static: speed(ObserverKind::Static),
            time_dilation: dilation(&scene, &u),
            ahead: light_ahead(&scene)?,
            shadow_radius: shadow_radius(kerr, &matrix, r, theta, phi),
            acceleration: if in_free_fall {
                0.0
            } else {
                held_acceleration(kerr, observer.kind, r, theta)
            },
            tide: tide(kerr, r, camera.direction(), &u),
            hot_spot: hot_spot(&scene)?,
        })
    }
}

/// d tau/dt of the scene's observer: the proper time over the time of clocks far away; `None` at and
/// inside the horizon.
///
/// # Errors
/// If the scene's observer does not exist.
pub fn time_dilation(scene: &Scene) -> Result<Option<f64>, ObserverError> {
    let observer = &scene.observer;
    let matrix = scene.observer_at_camera(observer.kind, observer.velocity)?;
    Ok(dilation(scene, &four_velocity(&matrix)))
}

/// The same for an observer of this four-velocity at the camera.
fn dilation(scene: &Scene, u: &Photon) -> Option<f64> {
    let camera = &scene.camera;
    let (kerr, r, [theta, _]) = (scene.kerr(), camera.r, camera.polar_angles());
    let angular_momentum = r * camera.direction().cross(u.w).z;
    (r > kerr.horizon()).then(|| {
        // u^t = (E - omega L) / N^2.
        let RestFrame {
            lapse, dragging, ..
        } = RestFrame::at(kerr, r, theta);
        lapse * lapse / (u.energy - dragging * angular_momentum)
    })
}

fn hot_spot(scene: &Scene) -> Result<Option<HotSpotReadout>, ObserverError> {
    let Some(spot) = HotSpot::new(scene) else {
        return Ok(None);
    };
    let mut delays = [None; ORDERS as usize];
    for image in echo(scene)? {
        delays[image.order as usize] = Some(image.delay);
    }
    Ok(Some(HotSpotReadout {
        period: spot.period(),
        delays,
    }))
}

fn light_ahead(scene: &Scene) -> Result<Option<LightAhead>, ObserverError> {
    let direction = scene.camera.tetrad_from_camera().z_axis;
    let photon = CameraRays::new(scene)?.photon(direction);
    let trace = Reference::new(scene)?.trace(direction);
    let lambda = scene.camera.r * scene.camera.direction().cross(photon.w).z / photon.energy;
    let mut without_motion = scene.clone();
    without_motion.effects.doppler = false;
    let gravity = Shift::new(&without_motion);
    let outside = scene.camera.r > scene.kerr().horizon();
    Ok(match (trace.hits[0], trace.outcome) {
        (Some(hit), _) => Some(LightAhead {
            from_disk: true,
            shift: hit.g,
            gravitational_shift: outside.then(|| gravity.of_disk(hit.g, hit.r, lambda)),
        }),
        (None, Outcome::Sky) => Some(LightAhead {
            from_disk: false,
            shift: 1.0 / photon.energy,
            gravitational_shift: outside.then(|| gravity.of_sky(1.0 / photon.energy, lambda)),
        }),
        _ => None,
    })
}
