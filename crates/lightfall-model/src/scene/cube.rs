//! The six sides of a cube about the camera, each a perspective picture of 90 degrees, and the
//! layouts in which files hold them.

use super::{Camera, Projection, Scene};
use glam::{DMat3, DVec2, DVec3, UVec2};

/// A side of the cube, with the picture's axes to the right and upward on the camera's axes (right,
/// up, forward).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubeSide {
    /// Its name, from the camera's point of view.
    pub name: &'static str,
    /// What is to the right in its picture.
    pub right: DVec3,
    /// What is up in its picture.
    pub up: DVec3,
}

/// Where a file holds the sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubeLayout {
    /// The sides, row by row.
    pub sides: [CubeSide; 6],
    /// How many of them are beside each other.
    pub columns: u32,
}

// The sides that all layouts have in the same position. Those above and below are turned.
const LEFT: CubeSide = side("left", DVec3::Z, DVec3::Y);
const RIGHT: CubeSide = side("right", DVec3::NEG_Z, DVec3::Y);
const FRONT: CubeSide = side("front", DVec3::X, DVec3::Y);
const BACK: CubeSide = side("back", DVec3::NEG_X, DVec3::Y);

const fn side(name: &'static str, right: DVec3, up: DVec3) -> CubeSide {
    CubeSide { name, right, up }
}

impl CubeLayout {
    /// Three sides beside each other, as ffmpeg's filter v360 calls c3x2.
    pub const THREE_BY_TWO: Self = Self {
        sides: [
            RIGHT,
            LEFT,
            side("up", DVec3::X, DVec3::NEG_Z),
            side("down", DVec3::X, DVec3::Z),
            FRONT,
            BACK,
        ],
        columns: 3,
    };

    /// OpenEXR's column of six (ImfEnvmap.h), whose x axis is to the left.
    pub const COLUMN: Self = Self {
        sides: [
            LEFT,
            RIGHT,
            side("up", DVec3::NEG_X, DVec3::Z),
            side("down", DVec3::NEG_X, DVec3::NEG_Z),
            FRONT,
            BACK,
        ],
        columns: 1,
    };

    /// The rows of sides.
    #[must_use]
    pub const fn rows(self) -> u32 {
        6 / self.columns
    }

    /// The size of the whole picture whose sides have this many pixels.
    #[must_use]
    pub const fn size(self, side: u32) -> UVec2 {
        UVec2::new(self.columns * side, self.rows() * side)
    }

    /// The upper left corner of a side in the whole picture, in sides.
    #[must_use]
    pub const fn corner(self, number: u32) -> UVec2 {
        UVec2::new(number % self.columns, number / self.columns)
    }

    /// The direction that is seen at a place of the whole picture, whose sides have `side` pixels, on
    /// the camera's axes; `None` outside.
    #[must_use]
    pub fn looking(self, place: DVec2, side: f64) -> Option<DVec3> {
        let at = (place / side).floor();
        let count = DVec2::new(self.columns.into(), self.rows().into());
        if at.cmplt(DVec2::ZERO).any() || at.cmpge(count).any() {
            return None;
        }
        let number = at.y as u32 * self.columns + at.x as u32;
        let across = (place / side - at - 0.5) * DVec2::new(2.0, -2.0);
        let axes = self.sides[number as usize].axes();
        Some(axes * across.extend(1.0).normalize())
    }

    /// The place of the whole picture at which a direction is seen. The inverse of
    /// [`looking`](Self::looking).
    #[must_use]
    pub fn pixel_of(self, looking: DVec3, side: f64) -> DVec2 {
        let forward = |side: &CubeSide| side.axes().z_axis.dot(looking);
        let ahead =
            |i: &usize, j: &usize| forward(&self.sides[*i]).total_cmp(&forward(&self.sides[*j]));
        let number = (0..6).max_by(ahead).unwrap_or_default();
        let seen = self.sides[number].axes().transpose() * looking;
        let across = 0.5 * (seen.truncate() / seen.z * DVec2::new(1.0, -1.0) + 1.0);
        (self.corner(number as u32).as_dvec2() + across) * side
    }
}

impl CubeSide {
    /// The axes (right, up, forward) of its picture on those of the camera, one per column.
    #[must_use]
    pub fn axes(&self) -> DMat3 {
        DMat3::from_cols(self.right, self.up, self.right.cross(self.up))
    }
}

impl Camera {
    /// The camera with another perspective picture, whose axes (right, up, forward) on this camera's
    /// axes are the columns of `axes`.
    #[must_use]
    pub fn turned_to(&self, axes: DMat3, fov_deg: f64) -> Self {
        let mut camera = Self {
            projection: Projection::Perspective,
            fov_deg,
            tilt_deg: 0.0,
            shift: [0.0; 2],
            ..*self
        };
        camera.set_orientation(self.tetrad_from_camera() * axes);
        camera
    }
}

impl Scene {
    /// The scene of a side of the cube about its camera, in a picture of `size` pixels a side. It has
    /// no bloom, which would end at the edges.
    #[must_use]
    pub fn cube_side(&self, side: &CubeSide, size: u32) -> Self {
        let mut scene = self.clone();
        scene.camera = self.camera.turned_to(side.axes(), 90.0);
        let picture = &mut scene.picture;
        (picture.width, picture.height) = (size, size);
        (picture.grid_width, picture.grid_height) = (size, size);
        (picture.bypass, picture.bloom) = (true, 0.0);
        scene
    }
}
