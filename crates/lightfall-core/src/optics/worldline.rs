//! Real motion: an observer who falls freely, or circles, in her own time.
//!
//! The scene stays the one description: where the camera comes to, and how it moves there, is
//! written back to its fields, so that the picture is that of the moving observer. A circular orbit
//! stays `orbit`, free fall from rest at infinity stays `rain`; whatever else is let go is from
//! then on `rain` with one more velocity, a frame that knows no horizon.
//!
//! The camera keeps looking where it looks: it is carried along the great circle between two
//! places, without a turn about the hole's direction, so that the hole stays where it is in the
//! picture, over a pole as elsewhere.

use crate::geometry::kerr::{CircularOrbit, Kerr};
use crate::geometry::observer::min_infall_radius;
use crate::geometry::observer::{ObserverError, observer_matrix};
use crate::geometry::sphere::celestial_frame;
use crate::geometry::tetrad::{four_velocity, turn_between, velocity_in_rain};
use crate::geometry::timelike::{Geodesic, Limit, State};
use crate::scene::{Camera, ObserverKind, Scene};
use glam::{DMat3, DQuat};
use std::f64::consts::TAU;

/// Farthest a flight goes, in r_s: the limit of `camera.r`.
const MAX_RADIUS: f64 = 1e7;

/// Turns smaller than this, in radians, are rounding.
const NO_TURN: f64 = 1e-12;

/// An observer on her way.
#[derive(Clone, Debug, PartialEq)]
pub struct Worldline {
    kerr: Kerr,
    path: Path,
    /// Where the way began.
    start_r: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Path {
    /// The azimuth is kept within a turn: it would lose digits with time.
    Circle {
        orbit: CircularOrbit,
        phi: f64,
        own_time: f64,
    },
    Free(Box<Fall>),
}

#[derive(Clone, Debug, PartialEq)]
struct Fall {
    geodesic: Geodesic,
    /// Whether it is `rain` itself, whose velocity is zero to the last bit.
    from_rest: bool,
    /// Polar angle and azimuth psi of the frame that the camera's turns refer to.
    frame: [f64; 2],
    /// A turn of the axes that is still to be written.
    turn: DMat3,
}

impl Worldline {
    /// Lets go of the scene's observer.
    ///
    /// # ErrorSummary
    /// If the scene's observer cannot exist.
    pub fn start(scene: &Scene) -> Result<Self, ObserverError> {
        let (camera, observer) = (&scene.camera, &scene.observer);
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        let (theta, phi) = (camera.theta_deg.to_radians(), camera.phi_deg.to_radians());
        let of =
            |kind, velocity| observer_matrix(scene.hole.spin, kind, velocity, camera.r, theta, phi);
        let matrix = of(observer.kind, observer.velocity)?;
        let untouched = observer.velocity == [0.0; 3];
        let path = match kerr.circular_orbit(camera.r) {
            Some(orbit) if untouched && observer.kind == ObserverKind::Orbit => Path::Circle {
                orbit,
                phi,
                own_time: 0.0,
            },
            _ => {
                let from_rest = untouched && observer.kind == ObserverKind::Rain;
                let outside = camera.r > kerr.horizon();
                let chi = if outside {
                    kerr.ingoing_azimuth_lead(camera.r)
                } else {
                    0.0
                };
                let velocity = four_velocity(&matrix);
                let turn = if observer.kind == ObserverKind::Rain {
                    DMat3::IDENTITY
                } else {
                    let rain = velocity_in_rain(kerr, camera.r, theta, phi, &velocity);
                    turn_between(
                        &matrix,
                        &of(ObserverKind::Rain, rain.to_array())?,
                        theta,
                        phi,
                    )
                };
                let geodesic = Geodesic::new(kerr, &velocity, camera.r, camera.direction(), chi);
                Path::Free(Box::new(Fall {
                    geodesic,
                    from_rest,
                    frame: [theta, phi],
                    turn,
                }))
            }
        };
        Ok(Self {
            kerr,
            path,
            start_r: camera.r,
        })
    }

    /// Lets her own time `own_time` (r_s, not negative) pass and writes to `scene` where she is
    /// then and how she moves. Says so if a limit of the motion was met before.
    pub fn advance(&mut self, own_time: f64, scene: &mut Scene) -> Option<Limit> {
        let kerr = self.kerr;
        match &mut self.path {
            Path::Circle {
                orbit,
                phi,
                own_time: passed,
            } => {
                *passed += own_time;
                *phi = (*phi + orbit.angular_velocity * orbit.u_t * own_time) % TAU;
                scene.camera.r = self.start_r;
                scene.camera.phi_deg = degrees(*phi);
                scene.observer.kind = ObserverKind::Orbit;
                scene.observer.velocity = [0.0; 3];
                None
            }
            Path::Free(fall) => {
                let limit = fall
                    .geodesic
                    .advance(own_time, [min_infall_radius(kerr), MAX_RADIUS]);
                fall.write(kerr, scene);
                limit
            }
        }
    }

    /// Her own time since she was let go, in r_s.
    #[must_use]
    pub fn own_time(&self) -> f64 {
        match &self.path {
            Path::Circle { own_time, .. } => *own_time,
            Path::Free(fall) => fall.geodesic.state.own_time,
        }
    }

    /// The time t that passed meanwhile on clocks far away, in r_s; none where one of the two
    /// places is not outside the horizon.
    #[must_use]
    pub fn far_time(&self) -> Option<f64> {
        match &self.path {
            Path::Circle {
                orbit, own_time, ..
            } => Some(orbit.u_t * own_time),
            Path::Free(fall) => {
                let (r, horizon) = (1.0 / fall.geodesic.state.u, self.kerr.horizon());
                let lead = |r: f64| self.kerr.ingoing_time_lead(r);
                (r > horizon && self.start_r > horizon)
                    .then(|| fall.geodesic.state.ingoing_time - (lead(r) - lead(self.start_r)))
            }
        }
    }

    /// The ingoing time that passed meanwhile, in r_s: Kerr's v less r, which far away is t, and
    /// which goes on through the horizon.
    #[must_use]
    pub fn ingoing_time(&self) -> f64 {
        match &self.path {
            Path::Circle {
                orbit, own_time, ..
            } => orbit.u_t * own_time,
            Path::Free(fall) => {
                fall.geodesic.state.ingoing_time - (1.0 / fall.geodesic.state.u - self.start_r)
            }
        }
    }

    /// Whether she circles, rather than falls.
    #[must_use]
    pub fn circles(&self) -> bool {
        matches!(self.path, Path::Circle { .. })
    }

    /// Her geodesic, unless it is a circle known in closed form.
    #[must_use]
    pub fn geodesic(&self) -> Option<&Geodesic> {
        match &self.path {
            Path::Circle { .. } => None,
            Path::Free(fall) => Some(&fall.geodesic),
        }
    }
}

impl Fall {
    fn write(&mut self, kerr: Kerr, scene: &mut Scene) {
        let State { u, n, chi, .. } = self.geodesic.state;
        let r = 1.0 / u;
        let theta = n.truncate().length().atan2(n.z);
        // On the axis any azimuth will do, and the last one keeps the axes.
        let psi = if n.x == 0.0 && n.y == 0.0 {
            self.frame[1]
        } else {
            n.y.atan2(n.x)
        };
        let lead = if r > kerr.horizon() {
            kerr.ingoing_azimuth_lead(r)
        } else {
            0.0
        };
        let velocity = if self.from_rest {
            [0.0; 3]
        } else {
            velocity_in_rain(kerr, r, theta, psi, &self.geodesic.velocity()).to_array()
        };
        let axes = |[theta, psi]: [f64; 2]| {
            let [outward, theta_hat, psi_hat] = celestial_frame(theta, psi);
            DMat3::from_cols(outward, theta_hat, psi_hat)
        };
        let (before, after) = (axes(self.frame), axes([theta, psi]));
        let carried =
            DMat3::from_quat(DQuat::from_rotation_arc(before.x_axis, after.x_axis)) * before;
        let turn = after.transpose() * carried * self.turn;
        (self.frame, self.turn) = ([theta, psi], DMat3::IDENTITY);
        let camera = &mut scene.camera;
        // Where motion ends, one over one over r may be less than r.
        camera.r = r.clamp(min_infall_radius(kerr), MAX_RADIUS);
        (camera.theta_deg, camera.phi_deg) = (theta.to_degrees(), degrees(psi + chi - lead));
        (scene.observer.kind, scene.observer.velocity) = (ObserverKind::Rain, velocity);
        turn_camera(camera, turn);
    }
}

/// Turns the camera with its axes, unless the turn is none.
fn turn_camera(camera: &mut Camera, turn: DMat3) {
    let largest = (turn - DMat3::IDENTITY)
        .to_cols_array()
        .into_iter()
        .fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest > NO_TURN {
        camera.set_turns(turn * camera.tetrad_from_camera());
    }
}

/// Radians as degrees within half a turn.
fn degrees(angle: f64) -> f64 {
    let degrees = angle.to_degrees();
    degrees - 360.0 * (degrees / 360.0).round()
}
