//! The worldline of an observer that falls freely or orbits, by its proper time.
//!
//! The camera's place and the observer's motion are written back to the scene. A circular orbit
//! stays `orbit`, and free fall from rest at infinity stays `rain`. Every other observer becomes
//! `rain` with a velocity relative to it, since that frame is regular at the horizon. The camera's
//! direction is carried along the great circle between two places, so the hole keeps its place in
//! the picture, also over a pole.

use glam::{DMat3, DQuat};
use lightfall_model::geometry::kerr::{CircularOrbit, Kerr};
use lightfall_model::geometry::observer::{ObserverError, min_infall_radius};
use lightfall_model::geometry::sphere::{celestial_axes, wrap_degrees};
use lightfall_model::geometry::tetrad::{four_velocity, rotation_between, velocity_in_rain};
use lightfall_model::geometry::timelike::{Geodesic, Limit, ParticleState};
use lightfall_model::scene::{Camera, MAX_RADIUS, ObserverKind, Scene};
use std::f64::consts::TAU;

/// Rotations smaller than this, in radians, are rounding errors.
const MIN_ROTATION: f64 = 1e-12;

/// The worldline of a freely moving observer, from the moment of its release.
#[derive(Clone, Debug, PartialEq)]
pub struct Worldline {
    kerr: Kerr,
    motion: Motion,
    /// Radius at the release, in r_s.
    start_r: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Motion {
    /// A circular orbit, known in closed form.
    Circular {
        orbit: CircularOrbit,
        /// Azimuth, within one revolution so that its precision does not decrease with time.
        phi: f64,
        proper_time: f64,
    },
    Free(Box<FreeFall>),
}

#[derive(Clone, Debug, PartialEq)]
struct FreeFall {
    geodesic: Geodesic,
    /// Whether the observer is `rain` itself, whose velocity is exactly zero.
    is_rain: bool,
    /// Polar angle and azimuth psi of the axes of the camera's direction.
    axes: [f64; 2],
    /// A rotation of the axes not yet applied to the camera.
    pending_rotation: DMat3,
}

impl Worldline {
    /// Releases the scene's observer.
    ///
    /// # Errors
    /// If the scene's observer does not exist.
    pub fn start(scene: &Scene) -> Result<Self, ObserverError> {
        let (camera, observer) = (&scene.camera, &scene.observer);
        let kerr = scene.kerr();
        let [theta, phi] = camera.polar_angles();
        let matrix = scene.observer_at_camera(observer.kind, observer.velocity)?;
        let has_no_velocity = observer.velocity == [0.0; 3];
        let motion = match kerr.circular_orbit(camera.r) {
            Some(orbit) if has_no_velocity && observer.kind == ObserverKind::Orbit => {
                Motion::Circular {
                    orbit,
                    phi,
                    proper_time: 0.0,
                }
            }
            _ => {
                let is_rain = has_no_velocity && observer.kind == ObserverKind::Rain;
                let chi = kerr.camera_azimuth_lead(camera.r);
                let velocity = four_velocity(&matrix);
                let pending_rotation = if observer.kind == ObserverKind::Rain {
                    DMat3::IDENTITY
                } else {
                    let rain = velocity_in_rain(kerr, camera.r, theta, phi, &velocity);
                    let rain = scene.observer_at_camera(ObserverKind::Rain, rain.to_array())?;
                    rotation_between(&matrix, &rain, theta, phi)
                };
                let geodesic = Geodesic::new(kerr, &velocity, camera.r, camera.direction(), chi);
                Motion::Free(Box::new(FreeFall {
                    geodesic,
                    is_rain,
                    axes: [theta, phi],
                    pending_rotation,
                }))
            }
        };
        Ok(Self {
            kerr,
            motion,
            start_r: camera.r,
        })
    }

    /// Advances the observer by `proper_time` (r_s, not negative) and writes its place and motion
    /// to `scene`. The clock of a disk that moves goes on by the time of the scene's own clock,
    /// [`clock`](Self::clock). Returns the limit that ended the motion earlier, if there was one.
    pub fn advance(&mut self, proper_time: f64, scene: &mut Scene) -> Option<Limit> {
        let before = self.clock();
        let limit = self.move_on(proper_time, scene);
        if scene.disk_moves() {
            scene.disk.time += self.clock() - before;
        }
        limit
    }

    fn move_on(&mut self, proper_time: f64, scene: &mut Scene) -> Option<Limit> {
        let kerr = self.kerr;
        match &mut self.motion {
            Motion::Circular {
                orbit,
                phi,
                proper_time: passed,
            } => {
                *passed += proper_time;
                *phi = (*phi + orbit.angular_velocity * orbit.u_t * proper_time) % TAU;
                scene.camera.r = self.start_r;
                scene.camera.phi_deg = wrap_degrees(phi.to_degrees());
                scene.observer.kind = ObserverKind::Orbit;
                scene.observer.velocity = [0.0; 3];
                None
            }
            Motion::Free(fall) => {
                let limit = fall
                    .geodesic
                    .advance(proper_time, [min_infall_radius(kerr), MAX_RADIUS]);
                fall.write(kerr, scene);
                limit
            }
        }
    }

    /// Proper time since the release, in r_s.
    pub fn proper_time(&self) -> f64 {
        match &self.motion {
            Motion::Circular { proper_time, .. } => *proper_time,
            Motion::Free(fall) => fall.geodesic.state.proper_time,
        }
    }

    /// The present radius, in r_s.
    fn r(&self) -> f64 {
        match &self.motion {
            Motion::Circular { .. } => self.start_r,
            Motion::Free(fall) => 1.0 / fall.geodesic.state.u,
        }
    }

    /// Kerr's ingoing time v since the release, in r_s.
    fn advanced_time(&self) -> f64 {
        match &self.motion {
            Motion::Circular {
                orbit, proper_time, ..
            } => orbit.u_t * proper_time,
            Motion::Free(fall) => fall.geodesic.state.ingoing_time,
        }
    }

    /// Boyer-Lindquist time since the release, in r_s: the time on clocks far away. `None` unless
    /// both the release and the present place are outside the horizon.
    pub fn coordinate_time(&self) -> Option<f64> {
        let lead = |r: f64| self.kerr.ingoing_time_lead(r);
        let outside = self.r().min(self.start_r) > self.kerr.horizon();
        outside.then(|| self.advanced_time() - (lead(self.r()) - lead(self.start_r)))
    }

    /// The time of `disk.time` along the worldline, in r_s/c, from a start of its own: outside the
    /// horizon Boyer-Lindquist's t, and at and inside the horizon Kerr's ingoing time v = t + r*.
    /// There t is infinite, while v is regular all along the worldline. Light that falls in with
    /// the observer keeps v, so the picture continues without a break.
    pub fn clock(&self) -> f64 {
        self.advanced_time() - self.kerr.camera_time_lead(self.r())
    }

    /// Ingoing time since the release, in r_s: Kerr's v minus r, which far away equals t and is
    /// regular at the horizon.
    pub fn ingoing_time(&self) -> f64 {
        self.advanced_time() - (self.r() - self.start_r)
    }

    /// Whether the observer is on a circular orbit.
    pub fn is_circular(&self) -> bool {
        matches!(self.motion, Motion::Circular { .. })
    }

    /// The observer's geodesic; `None` for a circular orbit, which is known in closed form.
    pub fn geodesic(&self) -> Option<&Geodesic> {
        match &self.motion {
            Motion::Circular { .. } => None,
            Motion::Free(fall) => Some(&fall.geodesic),
        }
    }
}

impl FreeFall {
    /// Writes the present place and motion to `scene`.
    fn write(&mut self, kerr: Kerr, scene: &mut Scene) {
        let ParticleState { u, n, chi, .. } = self.geodesic.state;
        let r = 1.0 / u;
        let theta = n.truncate().length().atan2(n.z);
        // On the axis every azimuth is right, and the last one leaves the axes unchanged.
        let psi = if n.x == 0.0 && n.y == 0.0 {
            self.axes[1]
        } else {
            n.y.atan2(n.x)
        };
        let lead = kerr.camera_azimuth_lead(r);
        let velocity = if self.is_rain {
            [0.0; 3]
        } else {
            velocity_in_rain(kerr, r, theta, psi, &self.geodesic.velocity()).to_array()
        };
        let axes_at = |[theta, psi]: [f64; 2]| celestial_axes(theta, psi);
        let (before, after) = (axes_at(self.axes), axes_at([theta, psi]));
        let carried =
            DMat3::from_quat(DQuat::from_rotation_arc(before.x_axis, after.x_axis)) * before;
        let rotation = after.transpose() * carried * self.pending_rotation;
        (self.axes, self.pending_rotation) = ([theta, psi], DMat3::IDENTITY);
        let camera = &mut scene.camera;
        // At a limit of the motion, 1/(1/r) may lie outside the limit by rounding.
        camera.r = r.clamp(min_infall_radius(kerr), MAX_RADIUS);
        (camera.theta_deg, camera.phi_deg) = (
            theta.to_degrees(),
            wrap_degrees((psi + chi - lead).to_degrees()),
        );
        (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, velocity);
        rotate_camera(camera, rotation);
    }
}

/// Rotates the camera with its axes, unless the rotation is only a rounding error.
fn rotate_camera(camera: &mut Camera, rotation: DMat3) {
    let largest = (rotation - DMat3::IDENTITY)
        .to_cols_array()
        .into_iter()
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest > MIN_ROTATION {
        camera.set_orientation(rotation * camera.heading());
    }
}
