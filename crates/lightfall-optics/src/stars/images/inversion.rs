//! The images of stars for a camera around a hole without spin, by the table, and for every camera
//! without lensing.

use super::StarImage;
use super::caustic::{MIN_SOURCE_RADIUS, inverse_sine};
use super::table::{ImageTable, ORDERS};
use crate::camera_rays::CameraRays;
use crate::shift::Shift;
use glam::{DMat3, DMat4, DVec3, DVec4};
use lightfall_model::geometry::observer::{ObserverError, ObserverKind, boost};
use lightfall_model::geometry::sphere::angle_between;
use lightfall_model::geometry::tetrad::transformation;
use lightfall_model::scene::Scene;
use std::f64::consts::{PI, TAU};
use thiserror::Error;

/// Where sin(alpha)/sin(psi) of a star straight overhead is 0/0, dalpha/dpsi takes its place: for
/// psi below this, in radians. They differ by psi^2 there.
const OVERHEAD: f64 = 3e-3;

/// The distance from a caustic at which [`Inversion::max_gain`] is measured, in radians: one star
/// in a million is closer to one.
const NEAR_CAUSTIC: f64 = 1e-3;

/// Number of directions about the hole in which [`Inversion::max_gain`] is measured.
const AZIMUTHS: u32 = 64;

/// Why the images of stars cannot be found by inversion.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum InversionError {
    /// The camera's observer does not exist.
    #[error(transparent)]
    Observer(#[from] ObserverError),
    /// The hole spins.
    #[error(
        "images of stars are found by inversion around a hole without spin only; the spin is {0}"
    )]
    Spin(f64),
}

/// The camera of a scene, for which the images of stars are found without tracing a ray.
#[derive(Clone, Debug)]
pub struct Inversion {
    rays: CameraRays,
    /// Unit vector from the hole to the camera.
    n: DVec3,
    /// The observer's axes as columns in the hole's frame.
    axes: DMat3,
    /// Takes (1, d) of the observer in whose frame images are found to (frequency, frequency times
    /// d) of the camera.
    to_camera: DMat4,
    lens: Lens,
    r: f64,
    shift: Shift,
}

/// The rays from the sky to the observer in whose frame images are found.
#[derive(Clone, Debug)]
enum Lens {
    /// Bent by a hole without spin; the observer is `rain`.
    Table(Box<ImageTable>),
    /// Along straight lines, where a ball of this angular radius hides the sky; the observer is the
    /// one with zero angular momentum.
    Straight { ball: f64 },
}

impl Inversion {
    /// The camera of `scene`.
    ///
    /// # Errors
    /// The observer does not exist, or light is bent by a hole with spin.
    pub fn new(scene: &Scene) -> Result<Self, InversionError> {
        let camera = &scene.camera;
        let rays = CameraRays::new(scene)?;
        let lens = if scene.effects.lensing {
            if scene.hole.spin != 0.0 {
                return Err(InversionError::Spin(scene.hole.spin));
            }
            Lens::Table(Box::new(ImageTable::new(camera.r)))
        } else {
            let kerr = scene.kerr();
            Lens::Straight {
                ball: (kerr.horizon() / camera.r).min(1.0).asin(),
            }
        };
        Ok(Self {
            rays,
            n: camera.direction(),
            axes: camera.tetrad(),
            to_camera: to_camera(scene, &rays)?,
            lens,
            r: camera.r,
            shift: Shift::new(scene),
        })
    }

    /// The table; `None` along straight rays.
    pub fn table(&self) -> Option<&ImageTable> {
        match &self.lens {
            Lens::Table(table) => Some(table),
            Lens::Straight { .. } => None,
        }
    }

    /// Takes (1, d) of the observer in whose frame images are found, d being on its axes (outward,
    /// toward growing theta, toward growing phi), to (frequency, frequency times d) of the camera,
    /// on the same axes.
    pub fn camera_from_frame(&self) -> DMat4 {
        self.to_camera
    }

    /// The largest gain of an image of this order, other than of the few stars within a thousandth
    /// of a radian of a caustic. Zero if there are no such images.
    ///
    /// The magnification is largest where an order begins or ends, next to the caustics.
    pub fn max_gain(&self, order: u32) -> f64 {
        let star = |azimuth: u32, angle: f64| {
            let turn = TAU * f64::from(azimuth) / f64::from(AZIMUTHS);
            let across = turn.cos() * self.axes.y_axis + turn.sin() * self.axes.z_axis;
            angle.cos() * self.n + angle.sin() * across
        };
        (0..AZIMUTHS)
            .flat_map(|azimuth| [NEAR_CAUSTIC, PI - NEAR_CAUSTIC].map(|angle| star(azimuth, angle)))
            .filter_map(|star| self.image(star, order))
            .fold(0.0, |largest, image| image.gain.max(largest))
    }

    /// The star's image of this order, for a star in the unit direction `star` of the hole's frame;
    /// `None` if there is none. The magnification is that of a star with the radius
    /// [`MIN_SOURCE_RADIUS`].
    pub fn image(&self, star: DVec3, order: u32) -> Option<StarImage> {
        let (direction, magnification) = match &self.lens {
            Lens::Table(table) => self.bent(table, star, order)?,
            Lens::Straight { ball } => {
                let hidden = angle_between(star, -self.n) <= *ball;
                (order == 0 && !hidden).then_some((star, 1.0))?
            }
        };
        let [frequency, rest @ ..] =
            (self.to_camera * DVec4::from((1.0, self.axes.transpose() * direction))).to_array();
        let direction = DVec3::from_array(rest).try_normalize()?;
        let magnification = magnification / (frequency * frequency);
        let shift = self.sky_shift(direction);
        Some(StarImage {
            direction,
            order,
            magnification,
            shift,
            gain: magnification * self.shift.beaming_factor(shift),
        })
    }

    /// All images of a star, by increasing order.
    pub fn images(&self, star: DVec3) -> impl Iterator<Item = StarImage> {
        (0..ORDERS).filter_map(move |order| self.image(star, order))
    }

    /// The shift of the sky's light that arrives from a unit direction on the observer's axes, with
    /// the scene's effects.
    fn sky_shift(&self, direction: DVec3) -> f64 {
        let photon = self.rays.photon(direction);
        let lambda = self.r * self.n.cross(photon.w).z / photon.energy;
        self.shift.of_sky(1.0 / photon.energy, lambda)
    }

    /// The direction, in the hole's frame, in which `rain` sees the image, and its magnification.
    ///
    /// With beta the star's angle from the line behind the hole, the light of even orders comes on
    /// the star's side after the angle psi = (order + 1) pi - beta, that of odd orders on the other
    /// side after order pi + beta. The magnification is sin(alpha) dalpha / (sin(psi) dpsi).
    fn bent(&self, table: &ImageTable, star: DVec3, order: u32) -> Option<(DVec3, f64)> {
        if order >= ORDERS {
            return None;
        }
        let behind = angle_between(star, -self.n);
        let overhead = angle_between(star, self.n);
        let even = order.is_multiple_of(2);
        let beyond = if even {
            f64::from(order) * PI - behind
        } else {
            f64::from(order - 1) * PI + behind
        };
        let across = star.reject_from_normalized(self.n);
        let side = across
            .try_normalize()
            .unwrap_or_else(|| self.n.any_orthonormal_vector());
        let arrival = table.arrival(beyond);
        let theta = table.sky().shadow_half_angle() + arrival.off_edge;
        let (sin, cos) = theta.sin_cos();
        let tangential = if order == 0 && overhead < OVERHEAD {
            arrival.slope
        } else {
            // A star overhead is on a caustic too, except for its image of order 0.
            let from_caustic = if order == 0 {
                behind
            } else {
                behind.min(overhead)
            };
            sin * inverse_sine(from_caustic, MIN_SOURCE_RADIUS)
        };
        let direction = -cos * self.n + if even { sin } else { -sin } * side;
        Some((direction, tangential * arrival.slope))
    }
}

/// From (1, d) of the observer in whose frame images are found to the camera's (frequency,
/// frequency times d).
fn to_camera(scene: &Scene, rays: &CameraRays) -> Result<DMat4, ObserverError> {
    let [theta, phi] = scene.camera.polar_angles();
    if !scene.effects.lensing {
        let mut at_rest = scene.clone();
        at_rest.effects.aberration = false;
        let frame = CameraRays::new(&at_rest)?.matrix;
        return Ok(transformation(&frame, &rays.matrix, theta, phi));
    }
    if scene.observer.kind == ObserverKind::Rain && scene.effects.aberration {
        // The general way fails on the horizon, where this observer alone exists.
        let back = boost(scene.observer.velocity.map(|v| -v))?;
        return Ok(DMat4::from_cols_array_2d(&back).transpose());
    }
    let rain = scene.observer_at_camera(ObserverKind::Rain, [0.0; 3])?;
    Ok(transformation(&rain, &rays.matrix, theta, phi))
}
