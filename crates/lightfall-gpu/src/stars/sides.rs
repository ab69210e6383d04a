//! The perspective pictures through which a mesh of rays finds the images of stars in a picture of
//! another projection: the sides of a cube about the camera, or one picture for a narrow circle.
//!
//! A mesh's cells are squares of its picture. Near the poles of an equirectangular picture such a square
//! covers almost no sky, and in a wide fisheye picture neighbouring squares have very different shapes on
//! the sky.

use super::numbers::stretch;
use glam::{DMat3, DVec3};
use lightfall_model::scene::{CubeLayout, Projection, Scene};

/// The widest circle, in degrees, that one perspective picture serves.
const MAX_CIRCLE_DEG: f64 = 100.0;

/// The widest field of view of this picture, in degrees: the circle and the images at its edge.
const MAX_FOV_DEG: f64 = 140.0;

/// The limits of the side of such a picture, in pixels. Up to the larger one, f32 resolves a hundredth
/// of a pixel.
const SIZES: [f64; 2] = [16.0, 65536.0];

/// A perspective picture through which images are found. Each keeps those within it.
#[derive(Clone, Debug, PartialEq)]
pub struct StarSide {
    /// The scene in this picture.
    pub scene: Scene,
    /// From the directions (right, up, forward) of this picture to those of the scene's own one.
    pub picture_from_side: DMat3,
}

impl StarSide {
    /// The sides of a scene, or none where a mesh through its own picture finds the images.
    pub fn all_of(scene: &Scene) -> Vec<Self> {
        let camera = &scene.camera;
        let projection = camera.projection.of_picture();
        if projection == Projection::Perspective {
            return Vec::new();
        }
        // Images reach beyond the circle by twice their stretch.
        let margin = 4.0 * stretch(scene) * scene.pixel_angle();
        let fisheye_deg = camera.fisheye_deg + margin.to_degrees();
        if projection == Projection::Fisheye && camera.fisheye_deg <= MAX_CIRCLE_DEG {
            let fov_deg = fisheye_deg.min(MAX_FOV_DEG);
            return vec![Self::new(scene, DMat3::IDENTITY, fov_deg)];
        }
        let sides = CubeLayout::THREE_BY_TWO.sides;
        let axes = sides.iter().map(|side| side.axes());
        let shown = |axes: &DMat3| {
            projection == Projection::Equirectangular
                || nearest_angle(axes.z_axis).to_degrees() < 0.5 * fisheye_deg
        };
        axes.filter(shown)
            .map(|axes| Self::new(scene, axes, 90.0))
            .collect()
    }

    /// The picture with these axes on those of the scene's camera. Its pixels cover the same angle as
    /// those of the scene.
    fn new(scene: &Scene, axes: DMat3, fov_deg: f64) -> Self {
        let mut side = scene.clone();
        side.camera = scene.camera.turned_to(axes, fov_deg);
        let [smallest, largest] = SIZES;
        let extent = 2.0 * (0.5 * fov_deg.to_radians()).tan();
        let size = (extent / scene.pixel_angle()).clamp(smallest, largest) as u32;
        (side.picture.width, side.picture.height) = (size, size);
        Self {
            scene: side,
            picture_from_side: axes,
        }
    }
}

/// The smallest angle between the camera's line of sight and a direction on the side of a cube that
/// looks along an axis, in radians: zero on the side ahead, 45 degrees beside it, and that of the
/// corners behind.
fn nearest_angle(axis: DVec3) -> f64 {
    let nearest = if axis.z > 0.5 {
        DVec3::Z
    } else if axis.z < -0.5 {
        DVec3::new(1.0, 1.0, -1.0)
    } else {
        axis + DVec3::Z
    };
    nearest.angle_between(DVec3::Z)
}
