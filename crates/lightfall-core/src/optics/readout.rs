//! Read-outs: what a scene's observer would note down about place, motion, light and strain, in
//! units of r_s and c.
//!
//! Everything here is a pure function of the [`Scene`]. [`si`] says it for a hole of some mass in
//! metres and seconds.

mod shadow;
pub mod si;
mod strain;

pub use shadow::shadow_radius;
pub use strain::{held_acceleration, tide};

use crate::geometry::kerr::Kerr;
use crate::geometry::observer::{ObserverError, observer_matrix};
use crate::geometry::tetrad::{four_velocity, relative_velocity};
use crate::optics::camera_rays::CameraRays;
use crate::optics::reference::Reference;
use crate::optics::shift::{RestFrame, Shift};
use crate::optics::trace::Outcome;
use crate::scene::{ObserverKind, Scene};

/// What an observer reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readout {
    /// Boyer-Lindquist radius, in r_s.
    pub r: f64,
    /// Boyer-Lindquist polar angle and azimuth, in degrees; at and inside the horizon Kerr's
    /// ingoing azimuth.
    pub angles_deg: [f64; 2],
    /// Speed for the observer with zero angular momentum at this place, in c; there is none at and
    /// inside the horizon.
    pub speed_for_zamo: Option<f64>,
    /// Speed for the observer at rest at this place, in c; there is none at and inside the static
    /// limit.
    pub speed_for_static: Option<f64>,
    /// d tau/dt: her own time over that of clocks far away; there is none at and inside the
    /// horizon.
    pub time_dilation: Option<f64>,
    /// Of the light from straight ahead.
    pub ahead: Option<LightAhead>,
    /// Angular radius of the hole's shadow, in radians: see [`shadow_radius`].
    pub shadow_radius: f64,
    /// Proper acceleration, in c^2/r_s: what holds `static` and `zamo` where they are. Zero in free
    /// fall, as `orbit` and `rain` are, and whatever has a velocity of its own: that coasts.
    pub acceleration: f64,
    /// Largest stretch by the tide: relative acceleration per distance, in c^2/r_s^2.
    pub tide: f64,
}

/// Light from straight ahead: from the first crossing of the disk, else from the sky.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightAhead {
    /// Whether it comes from the disk.
    pub from_disk: bool,
    /// Observed over emitted frequency.
    pub shift: f64,
    /// The share of the potentials at both ends in it; there is none at and inside the horizon.
    pub gravitational_shift: Option<f64>,
}

impl Readout {
    /// What the scene's observer reads. Effects that the scene switches off are on here: these are
    /// the numbers of the world, not of the picture.
    ///
    /// # ErrorSummary
    /// If the scene's observer cannot exist.
    pub fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let (camera, observer) = (&scene.camera, &scene.observer);
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        let (r, theta, phi) = (
            camera.r,
            camera.theta_deg.to_radians(),
            camera.phi_deg.to_radians(),
        );
        let of = |kind, velocity| observer_matrix(scene.hole.spin, kind, velocity, r, theta, phi);
        let matrix = of(observer.kind, observer.velocity)?;
        let speed = |kind| {
            of(kind, [0.0; 3])
                .ok()
                .map(|frame| relative_velocity(&matrix, &frame, theta, phi).length())
        };
        let u = four_velocity(&matrix);
        let outside = r > kerr.horizon();
        let angular_momentum = r * camera.direction().cross(u.w).z;
        let coasts = observer.velocity != [0.0; 3];
        Ok(Self {
            r,
            angles_deg: [camera.theta_deg, camera.phi_deg],
            speed_for_zamo: speed(ObserverKind::Zamo),
            speed_for_static: speed(ObserverKind::Static),
            time_dilation: outside.then(|| {
                // u^t = (E - omega L) / N^2.
                let RestFrame {
                    lapse, dragging, ..
                } = RestFrame::at(kerr, r, theta);
                lapse * lapse / (u.energy - dragging * angular_momentum)
            }),
            ahead: light_ahead(scene)?,
            shadow_radius: shadow_radius(kerr, &matrix, r, theta, phi),
            acceleration: if coasts {
                0.0
            } else {
                held_acceleration(kerr, observer.kind, r, theta)
            },
            tide: tide(kerr, r, camera.direction(), &u),
        })
    }
}

fn light_ahead(scene: &Scene) -> Result<Option<LightAhead>, ObserverError> {
    let mut scene = scene.clone();
    scene.effects = crate::scene::Effects::default();
    let direction = scene.camera.tetrad_from_camera().z_axis;
    let photon = CameraRays::new(&scene)?.photon(direction);
    let trace = Reference::new(&scene)?.trace(direction);
    let lambda = scene.camera.r * scene.camera.direction().cross(photon.w).z / photon.energy;
    scene.effects.doppler = false;
    let gravity = Shift::new(&scene);
    let outside = scene.camera.r
        > Kerr {
            spin: scene.hole.spin,
        }
        .horizon();
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
