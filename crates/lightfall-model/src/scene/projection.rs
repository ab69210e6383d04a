//! How a picture shows directions: which direction is seen at a place and where a direction is
//! seen, the solid angle of a pixel, and what is in view. No other Rust file has such a formula;
//! the twins in WGSL are in shaders/projection/.
//!
//! Directions are unit vectors (right, up, forward) of the camera. Places are in pixels from the
//! upper left corner of a picture, whose size is in pixels, too.

mod circle;
mod view;

use super::{Camera, Scene};
use circle::Circle;
use glam::{DVec2, DVec3, UVec2};
use std::f64::consts::{PI, TAU};

crate::words! {
    /// How a camera's picture shows directions. The word is the name of the file in
    /// shaders/projection/.
    pub enum Projection {
        /// As a pinhole camera does: a direction is seen where it crosses a plane in front of the
        /// camera.
        Perspective = "perspective": "Perspective",
        /// A circle in which the distance from the middle is proportional to the angle from the
        /// line of sight, as domes show it.
        Fisheye = "fisheye": "Fisheye",
        /// The whole sky, with a column for each longitude and a row for each latitude.
        Equirectangular = "equirectangular": "Whole sky",
        /// The six sides of a cube about the camera, which `render` writes; a window shows the scene
        /// in perspective.
        Cube = "cube": "Cube",
    }
}

impl Projection {
    /// The projection of a single picture: a cube is six of them, in perspective.
    #[must_use]
    pub const fn of_picture(self) -> Self {
        match self {
            Self::Cube => Self::Perspective,
            other => other,
        }
    }

    /// Whether the columns go around the whole sky, so that the first one is the neighbour of the last.
    #[must_use]
    pub const fn goes_around(self) -> bool {
        matches!(self, Self::Equirectangular)
    }

    /// Why no picture file of this size is written, as a clause; `None` if one is.
    #[must_use]
    pub fn refused_size(self, size: UVec2) -> Option<String> {
        let UVec2 { x, y } = size;
        match self {
            Self::Perspective | Self::Fisheye => None,
            Self::Equirectangular => (x != 2 * y).then(|| {
                format!("an equirectangular picture is twice as wide as it is high, such as 2048x1024, and not {x}x{y}")
            }),
            Self::Cube => (2 * x != 3 * y || x % 3 != 0).then(|| {
                format!("the six sides of a cube are three beside each other and two above each other, such as 3072x2048, and not {x}x{y}")
            }),
        }
    }
}

impl Camera {
    /// The direction that is seen at a place. Outside a fisheye picture's circle the same formula goes
    /// on.
    pub fn looking(&self, place: DVec2, size: DVec2) -> DVec3 {
        match self.projection {
            Projection::Perspective | Projection::Cube => {
                let across = place / size * DVec2::new(2.0, -2.0) + DVec2::new(-1.0, 1.0);
                let across = across - self.axis_across(size);
                (across * self.half_extent(size)).extend(1.0).normalize()
            }
            Projection::Fisheye => {
                let off = (place - self.axis(size)) * DVec2::new(1.0, -1.0);
                let distance = off.length();
                let (sine, cosine) = (distance * self.fisheye(size).angle_per_pixel).sin_cos();
                let toward = if distance > 0.0 { off / distance } else { off };
                (sine * toward).extend(cosine)
            }
            Projection::Equirectangular => {
                let (longitude, latitude) = angles_at(place, size);
                let (sine, cosine) = latitude.sin_cos();
                DVec3::new(cosine * longitude.sin(), sine, cosine * longitude.cos())
            }
        }
    }

    /// The place at which a direction is seen; `None` behind a perspective camera. The inverse of
    /// [`looking`](Self::looking).
    pub fn pixel_of(&self, looking: DVec3, size: DVec2) -> Option<DVec2> {
        match self.projection {
            Projection::Perspective | Projection::Cube => {
                let across = looking.truncate() / looking.z / self.half_extent(size);
                let across = across + self.axis_across(size);
                (looking.z > 0.0).then(|| 0.5 * (across * DVec2::new(1.0, -1.0) + 1.0) * size)
            }
            Projection::Fisheye => {
                let aside = looking.truncate();
                let distance = aside.length().atan2(looking.z) / self.fisheye(size).angle_per_pixel;
                // Straight back is the whole edge of a circle of 360 degrees: any place of it will do.
                let toward = aside.try_normalize().unwrap_or(DVec2::X);
                Some(self.axis(size) + distance * toward * DVec2::new(1.0, -1.0))
            }
            Projection::Equirectangular => {
                let longitude = looking.x.atan2(looking.z);
                let latitude = looking.y.atan2(looking.x.hypot(looking.z));
                let share = DVec2::new(0.5 + longitude / TAU, 0.5 - latitude / PI);
                Some(share * size)
            }
        }
    }

    /// Whether a direction is seen within the picture and, in a fisheye one, within its circle.
    pub fn shows(&self, looking: DVec3, size: DVec2) -> bool {
        let Some(place) = self.pixel_of(looking, size) else {
            return false;
        };
        match self.projection {
            // The columns go around the whole sky.
            Projection::Equirectangular => true,
            _ => {
                let within = place.cmpge(DVec2::ZERO).all() && place.cmplt(size).all();
                within && self.coverage(place, size) > 0.0
            }
        }
    }

    /// The share of the pixel with its middle at a place that shows anything: less than one at the
    /// edge of a fisheye picture's circle, and zero outside.
    pub fn coverage(&self, place: DVec2, size: DVec2) -> f64 {
        match self.projection {
            Projection::Fisheye => {
                let distance = place.distance(self.axis(size));
                (self.fisheye(size).radius - distance + 0.5).clamp(0.0, 1.0)
            }
            _ => 1.0,
        }
    }

    /// The solid angle of the pixel with its middle at a place, in steradians.
    pub fn solid_angle(&self, place: DVec2, size: DVec2) -> f64 {
        match self.projection {
            Projection::Perspective | Projection::Cube => {
                let cosine = self.looking(place, size).z;
                (2.0 * self.half_extent(size) / size).element_product() * cosine.powi(3)
            }
            Projection::Fisheye => {
                let per_pixel = self.fisheye(size).angle_per_pixel;
                let angle = place.distance(self.axis(size)) * per_pixel;
                // sin(angle)/angle, and nothing beyond straight back.
                let ratio = if angle > 0.0 {
                    angle.sin() / angle
                } else {
                    1.0
                };
                per_pixel.powi(2) * ratio.max(0.0)
            }
            Projection::Equirectangular => {
                let (_, latitude) = angles_at(place, size);
                2.0 * PI * PI * latitude.cos().max(0.0) / size.element_product()
            }
        }
    }

    /// The place of the line of sight.
    pub fn axis(&self, size: DVec2) -> DVec2 {
        match self.projection {
            Projection::Perspective | Projection::Fisheye => {
                let [right, up] = self.shift;
                0.5 * size + DVec2::new(right, -up) * size.y
            }
            Projection::Equirectangular | Projection::Cube => 0.5 * size,
        }
    }

    /// The angle that a pixel at the line of sight covers, in radians.
    pub fn pixel_angle(&self, size: DVec2) -> f64 {
        self.solid_angle(self.axis(size), size).sqrt()
    }

    /// The numbers that the projection's shader needs; its file says what they mean.
    pub fn projection_numbers(&self, size: DVec2) -> DVec2 {
        match self.projection {
            Projection::Perspective | Projection::Cube => self.half_extent(size),
            Projection::Fisheye => {
                let circle = self.fisheye(size);
                DVec2::new(circle.angle_per_pixel, circle.radius)
            }
            Projection::Equirectangular => DVec2::new(TAU, PI) / size,
        }
    }

    /// The place of the line of sight where the picture's middle is (0, 0) and its right and upper
    /// edges are at 1.
    pub fn axis_across(&self, size: DVec2) -> DVec2 {
        (self.axis(size) / size - 0.5) * DVec2::new(2.0, -2.0)
    }

    /// The circle of a fisheye picture.
    fn fisheye(&self, size: DVec2) -> Circle {
        Circle::new(
            self.fisheye_deg.to_radians(),
            self.circle * size.min_element(),
        )
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
    /// The angle that a pixel at the line of sight of the scene's picture covers, in radians.
    pub fn pixel_angle(&self) -> f64 {
        self.camera.pixel_angle(self.picture.size().as_dvec2())
    }
}

/// Longitude and latitude of a place of an equirectangular picture, in radians.
fn angles_at(place: DVec2, size: DVec2) -> (f64, f64) {
    let share = place / size;
    (TAU * (share.x - 0.5), PI * (0.5 - share.y))
}
