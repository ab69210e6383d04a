//! How a picture shows directions: which direction is seen at a place and where a direction is
//! seen, the solid angle of a pixel, and what is in view. No other Rust file has such a formula;
//! the twins in WGSL are in shaders/projection/.
//!
//! Directions are unit vectors (right, up, forward) of the camera. Places are in pixels from the
//! upper left corner of a picture, whose size is in pixels, too.

use super::tables::MAX_FIELD_OF_VIEW_DEG;
use super::{Camera, Scene};
use glam::{DVec2, DVec3};

crate::words! {
    /// How a camera's picture shows directions. The word is the name of the file in
    /// shaders/projection/.
    pub enum Projection {
        /// As a pinhole camera does: a direction is seen where it crosses a plane in front of the
        /// camera.
        Perspective = "perspective",
    }
}

impl Camera {
    /// How the picture shows directions.
    pub fn projection(&self) -> Projection {
        Projection::Perspective
    }

    /// The direction that is seen at a place.
    pub fn looking(&self, place: DVec2, size: DVec2) -> DVec3 {
        match self.projection() {
            Projection::Perspective => {
                let across = place / size * DVec2::new(2.0, -2.0) + DVec2::new(-1.0, 1.0);
                (across * self.half_extent(size)).extend(1.0).normalize()
            }
        }
    }

    /// The place at which a direction is seen; `None` behind a perspective camera. The inverse of
    /// [`looking`](Self::looking).
    pub fn pixel_of(&self, looking: DVec3, size: DVec2) -> Option<DVec2> {
        match self.projection() {
            Projection::Perspective => {
                let across = looking.truncate() / looking.z / self.half_extent(size);
                (looking.z > 0.0).then(|| 0.5 * (across * DVec2::new(1.0, -1.0) + 1.0) * size)
            }
        }
    }

    /// Whether a direction is seen within the picture.
    pub fn shows(&self, looking: DVec3, size: DVec2) -> bool {
        let place = self.pixel_of(looking, size);
        place.is_some_and(|place| place.cmpge(DVec2::ZERO).all() && place.cmplt(size).all())
    }

    /// The solid angle of the pixel with its middle at a place, in steradians.
    pub fn solid_angle(&self, place: DVec2, size: DVec2) -> f64 {
        match self.projection() {
            Projection::Perspective => {
                let cosine = self.looking(place, size).z;
                (2.0 * self.half_extent(size) / size).element_product() * cosine.powi(3)
            }
        }
    }

    /// The angle that a pixel in the middle of the picture covers, in radians.
    pub fn pixel_angle(&self, size: DVec2) -> f64 {
        self.solid_angle(0.5 * size, size).sqrt()
    }

    /// The angles from the middle of the picture to the middles of its right and its upper edge, in
    /// radians.
    pub fn half_angles(&self, size: DVec2) -> DVec2 {
        let angle_to = |place: DVec2| {
            let looking = self.looking(place, size);
            looking.truncate().length().atan2(looking.z)
        };
        DVec2::new(
            angle_to(size * DVec2::new(1.0, 0.5)),
            angle_to(size * DVec2::new(0.5, 0.0)),
        )
    }

    /// The field of view, in degrees, in which a pixel in the middle covers `factor` times the
    /// angle.
    pub fn widened_fov_deg(&self, factor: f64) -> f64 {
        match self.projection() {
            Projection::Perspective => 2.0 * (self.half_height() * factor).atan().to_degrees(),
        }
    }

    /// The numbers that the projection's shader needs; its file says what they mean.
    pub fn projection_numbers(&self, size: DVec2) -> DVec2 {
        match self.projection() {
            Projection::Perspective => self.half_extent(size),
        }
    }

    /// Half of a perspective picture's width and height at unit distance.
    fn half_extent(&self, size: DVec2) -> DVec2 {
        let up = self.half_height();
        DVec2::new(up * size.x / size.y, up)
    }

    fn half_height(&self) -> f64 {
        (self.fov_deg.to_radians() / 2.0).tan()
    }
}

impl Scene {
    /// The scene in a picture of `columns` columns that shows a field of view `factor` times as
    /// large, as far as there is one: what a pixel covers grows by this factor in both directions.
    #[must_use]
    pub fn widened(&self, factor: f64, columns: u32) -> Self {
        let mut scene = self.clone();
        let wide = self.camera.widened_fov_deg(factor);
        scene.camera.fov_deg = wide.min(MAX_FIELD_OF_VIEW_DEG);
        scene.picture.width = columns;
        scene.picture.grid_width = scene.picture.grid_width.min(columns);
        scene
    }

    /// The angle that a pixel in the middle of the scene's picture covers, in radians.
    pub fn pixel_angle(&self) -> f64 {
        self.camera.pixel_angle(self.picture.size().as_dvec2())
    }
}
