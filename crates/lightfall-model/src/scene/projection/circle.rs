//! The circle of an equidistant fisheye picture.

/// A circle in which the distance from the middle is proportional to the angle from the line of
/// sight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circle {
    /// In radians.
    pub(super) angle_per_pixel: f64,
    /// In pixels.
    pub(super) radius: f64,
}

impl Circle {
    /// The circle with this diameter, in pixels, across which the picture shows `field` radians.
    pub(super) fn new(field: f64, diameter: f64) -> Self {
        Self {
            angle_per_pixel: field / diameter,
            radius: 0.5 * diameter,
        }
    }

    /// The angle from the line of sight at a distance from it in pixels, in radians: at the circle's
    /// edge and beyond, that of the edge.
    pub(super) fn angle_at(self, distance: f64) -> f64 {
        self.angle_per_pixel * distance.min(self.radius)
    }
}
