//! The mesh of rays through a picture that finds the images of stars without an inversion.

use glam::{DVec2, UVec2};

/// Points at equal distances along both axes of a picture, in pixels from its upper left corner.
/// They cover the picture and a margin about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshLayout {
    /// The place of the first point.
    pub origin: DVec2,
    /// The distance between neighbours.
    pub spacing: f64,
    /// Points in a row, and rows.
    pub points: UVec2,
}

impl MeshLayout {
    /// The number of cells that cover a picture: one every 4 pixels of 960x540. With a field of
    /// view of 50 degrees neighbours are 7e-3 radians apart, and from 20 r_s the cells find all
    /// images with more than 0.03 times the star's flux. The number, and the work, is the same for
    /// all pictures, because the images depend on the field of view and not on its pixels.
    pub const CELLS: f64 = 240.0 * 135.0;

    /// The mesh of about `cells` square cells for a picture of `size` pixels, with as many more
    /// rows and columns as reach `margin` pixels beyond its border.
    pub fn new(size: UVec2, cells: f64, margin: f64) -> Self {
        let size = size.as_dvec2();
        let spacing = (size.x * size.y / cells).sqrt();
        let beyond = (margin / spacing).ceil().max(1.0);
        let inner = (size / spacing - 1e-9).ceil();
        Self {
            origin: DVec2::splat(-beyond * spacing),
            spacing,
            points: (inner + 2.0 * beyond + 1.0).as_uvec2(),
        }
    }

    /// The mesh with this many more cells beyond each of its sides.
    #[must_use]
    pub fn with_rim(self, cells: u32) -> Self {
        Self {
            origin: self.origin - f64::from(cells) * self.spacing,
            points: self.points + 2 * cells,
            ..self
        }
    }

    /// Number of points.
    pub fn point_count(&self) -> u32 {
        self.points.element_product()
    }

    /// Number of cells.
    pub fn cell_count(&self) -> u32 {
        (self.points - 1).element_product()
    }

    /// The place of a point, in pixels.
    pub fn place(&self, point: UVec2) -> DVec2 {
        self.origin + self.spacing * point.as_dvec2()
    }
}
