//! How much of the sky a camera's picture shows, and how to show more or less of it.

use super::Projection;
use crate::scene::tables::{MAX_FIELD_OF_VIEW_DEG, MAX_FISHEYE_DEG};
use crate::scene::{Camera, Scene};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

impl Camera {
    /// The angles from the line of sight to the right and to the upper edge of a picture in whose
    /// middle it is, in radians.
    pub fn half_angles(&self, size: DVec2) -> DVec2 {
        match self.projection {
            Projection::Perspective | Projection::Cube => {
                let angle_to = |beside: DVec2| {
                    let looking = self.looking(self.axis(size) + beside, size);
                    looking.truncate().length().atan2(looking.z)
                };
                DVec2::new(
                    angle_to(DVec2::new(0.5 * size.x, 0.0)),
                    angle_to(DVec2::new(0.0, -0.5 * size.y)),
                )
            }
            Projection::Fisheye => {
                let circle = self.fisheye(size);
                (0.5 * size).map(|half| circle.angle_at(half))
            }
            Projection::Equirectangular => DVec2::new(PI, FRAC_PI_2),
        }
    }

    /// The field of view, in degrees, that says how much the picture shows; `None` where it shows
    /// the whole sky.
    pub fn field_deg(&self) -> Option<f64> {
        match self.projection {
            Projection::Perspective | Projection::Cube => Some(self.fov_deg),
            Projection::Fisheye => Some(self.fisheye_deg),
            Projection::Equirectangular => None,
        }
    }

    /// Sets the field of view that [`field_deg`](Self::field_deg) returns.
    pub fn set_field_deg(&mut self, degrees: f64) {
        match self.projection {
            Projection::Perspective | Projection::Cube => self.fov_deg = degrees,
            Projection::Fisheye => self.fisheye_deg = degrees,
            Projection::Equirectangular => {}
        }
    }

    /// The field of view, in degrees, in which a pixel at the line of sight covers `factor` times the
    /// angle, as far as there is one; `None` where the picture shows the whole sky.
    pub fn widened_fov_deg(&self, factor: f64) -> Option<f64> {
        match self.projection {
            Projection::Perspective | Projection::Cube => {
                let wide = 2.0 * (self.half_height() * factor).atan().to_degrees();
                Some(wide.min(MAX_FIELD_OF_VIEW_DEG))
            }
            Projection::Fisheye => Some((self.fisheye_deg * factor).min(MAX_FISHEYE_DEG)),
            Projection::Equirectangular => None,
        }
    }

    /// The direction at a share, from 0 to 1 each, of the picture's area where places are spread
    /// evenly: in a perspective picture over its plane, in others over the solid angle. `None` where
    /// the picture cuts it off, and for a cube the whole sky.
    pub fn spread(&self, share: DVec2, size: DVec2) -> Option<DVec3> {
        let around = |cosine: f64, turn: f64| {
            let sine = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
            let (up, right) = turn.sin_cos();
            DVec3::new(sine * right, sine * up, cosine)
        };
        match self.projection {
            Projection::Perspective => Some(self.looking(share * size, size)),
            // The area of a cap is proportional to one less the cosine (Archimedes).
            Projection::Fisheye => {
                let cap = 1.0 - (0.5 * self.fisheye_deg.to_radians()).cos();
                let looking = around(1.0 - share.x * cap, TAU * share.y);
                self.shows(looking, size).then_some(looking)
            }
            Projection::Equirectangular | Projection::Cube => {
                Some(around(1.0 - 2.0 * share.x, TAU * share.y))
            }
        }
    }
}

impl Scene {
    /// The scene in a picture of `columns` columns that shows a field of view `factor` times as
    /// large, as far as there is one: what a pixel covers grows by this factor in both directions.
    /// The circle of a fisheye picture and the whole sky fit into any picture.
    #[must_use]
    pub fn widened(&self, factor: f64, columns: u32) -> Self {
        let mut scene = self.clone();
        if self.camera.projection.of_picture() == Projection::Perspective {
            let wide = self.camera.widened_fov_deg(factor);
            scene.camera.fov_deg = wide.unwrap_or(self.camera.fov_deg);
        }
        scene.picture.width = columns;
        scene.picture.grid_width = scene.picture.grid_width.min(columns);
        scene
    }
}
