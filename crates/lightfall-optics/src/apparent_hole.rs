//! The hole as a scene's camera sees it: its direction, its size and its share of the picture. The
//! window uses them to keep users from getting lost; they are cheap enough for every frame.

use crate::camera_rays::CameraRays;
use crate::readout::shadow;
use crate::reference::Reference;
use crate::shift::RestFrame;
use crate::trace::Outcome;
use glam::{DMat3, DVec2, DVec3, DVec4, Vec4Swizzles};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::geometry::tetrad::{four_velocity, rotation_between, velocity_in_rain};
use lightfall_model::scene::{ObserverKind, Scene};

/// Rays across and down the picture that measure its dark share.
const RAYS: [u32; 2] = [16, 9];

/// The hole as a scene's camera sees it, with the scene's effects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ApparentHole {
    /// Unit vector toward its middle, on the observer's axes (outward, toward growing theta, toward
    /// growing phi), with aberration.
    pub direction: DVec3,
    /// Angular radius of the black disc, in radians. With spin, the radius of the circle with the
    /// same solid angle.
    pub radius: f64,
}

impl ApparentHole {
    /// The hole as the scene's camera sees it.
    ///
    /// # Errors
    /// If the scene's observer does not exist.
    pub fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let (kerr, r) = (scene.kerr(), scene.camera.r);
        let [theta, phi] = scene.camera.polar_angles();
        let rays = CameraRays::new(scene)?;
        if !scene.effects.lensing {
            return Ok(Self::without_lensing(kerr, &rays, r, theta));
        }
        let seen = shadow(kerr, &rays.matrix, r, theta, phi);
        // Boosts along different directions turn the axes: those of `rain`, carried to another
        // observer by a boost of their own, are not that observer's axes.
        let is_rain = scene.effects.aberration && scene.observer.kind == ObserverKind::Rain;
        let rotation = if is_rain {
            DMat3::IDENTITY
        } else {
            let velocity = velocity_in_rain(kerr, r, theta, phi, &four_velocity(&rays.matrix));
            let boosted = scene.observer_at_camera(ObserverKind::Rain, velocity.to_array())?;
            rotation_between(&boosted, &rays.matrix, theta, phi)
        };
        let direction = (rotation * seen.middle).try_normalize();
        Ok(Self {
            // At the horizon itself the rotation is not defined.
            direction: direction.unwrap_or(DVec3::NEG_X),
            radius: seen.radius,
        })
    }

    /// The black ball of a picture without lensing. For the ZAMO it is a circle about the inward
    /// direction, with radial = cos(radius) energy / lapse on its edge. This is linear in (1, d),
    /// so the ball is a circle for every observer: the edge of the cap where a + B.d > 0.
    fn without_lensing(kerr: Kerr, rays: &CameraRays, r: f64, theta: f64) -> Self {
        let sine = (kerr.horizon() / r).min(1.0);
        let cosine = ((1.0 - sine) * (1.0 + sine)).sqrt();
        let lapse = RestFrame::at(kerr, r, theta).lapse;
        let [energy, radial] = [0, 1].map(|row: usize| DVec4::from_array(rays.matrix.rows[row]));
        let margin = radial - cosine / lapse * energy;
        let slope = margin.yzw();
        Self {
            direction: slope.try_normalize().unwrap_or(DVec3::NEG_X),
            radius: (-margin.x / slope.length()).clamp(-1.0, 1.0).acos(),
        }
    }

    /// The direction toward the middle of the hole on the camera's own axes (right, up, forward).
    pub fn from_camera(&self, scene: &Scene) -> DVec3 {
        scene.camera.tetrad_from_camera().transpose() * self.direction
    }

    /// Whether any part of the black disc is in the picture, to the accuracy of a twentieth of the
    /// picture's width.
    pub fn is_in_picture(&self, scene: &Scene) -> bool {
        let middle = self.from_camera(scene);
        let middle_is_in = scene.camera.shows(middle, scene.picture.size().as_dvec2());
        let cosine = self.radius.cos();
        middle_is_in || picture_directions(scene).any(|direction| direction.dot(middle) > cosine)
    }
}

/// The share of the picture, from 0 to 1, that is dark because its light would have to come out of
/// the hole. Light of the disk in front of the hole is not dark.
///
/// # Errors
/// If the scene's observer does not exist.
pub fn dark_share(scene: &Scene) -> Result<f64, ObserverError> {
    let reference = Reference::new(scene)?;
    let axes = scene.camera.tetrad_from_camera();
    let (mut dark, mut all) = (0_u32, 0_u32);
    for direction in picture_directions(scene) {
        let trace = reference.trace(axes * direction);
        let is_dark = trace.outcome == Outcome::Captured && trace.hits[0].is_none();
        dark += u32::from(is_dark);
        all += 1;
    }
    // A circle that lies beside its picture shows nothing.
    Ok(f64::from(dark) / f64::from(all.max(1)))
}

/// Unit looking directions (right, up, forward) evenly spread over the picture, within the circle of
/// a fisheye one.
fn picture_directions(scene: &Scene) -> impl Iterator<Item = DVec3> {
    let [across, down] = RAYS;
    let grid = DVec2::new(across.into(), down.into());
    let (camera, size) = (scene.camera, scene.picture.size().as_dvec2());
    (0..across * down).filter_map(move |i| {
        let cell = DVec2::new((i % across).into(), (i / across).into());
        let place = (cell + 0.5) / grid * size;
        (camera.coverage(place, size) > 0.0).then(|| camera.looking(place, size))
    })
}
