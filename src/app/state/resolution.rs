//! The resolution at which the picture is drawn: the scene's own, or a coarser one while something
//! moves. The scene's own resolution is kept here, so that nothing is lost.

use bevy::prelude::*;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{MAX_PIXELS_PER_CELL, Picture, Scene};

/// The scene's own resolution, and the one that is drawn.
#[derive(Resource, Clone, Debug)]
pub struct Resolution {
    /// Size and cells that the scene asks for.
    full_size: UVec2,
    full_grid: UVec2,
    /// Size and cells that are drawn.
    drawn_size: UVec2,
    drawn_grid: UVec2,
}

impl Resolution {
    /// The resolution of a scene, to be drawn in full.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let (full_size, full_grid) = sizes(&scene.picture);
        Self {
            full_size,
            full_grid,
            drawn_size: full_size,
            drawn_grid: full_grid,
        }
    }

    /// The scene at its own resolution, from the scene that is drawn.
    #[must_use]
    pub fn full_scene(&self, drawn: &Scene) -> Scene {
        let mut scene = drawn.clone();
        set_sizes(&mut scene.picture, self.full_size, self.full_grid);
        scene
    }

    /// Keeps the resolution of a scene that has its own resolution, and returns the scene at the
    /// resolution that is drawn.
    #[must_use]
    pub fn adopt(&mut self, full: Drawable) -> Drawable {
        if (self.full_size, self.full_grid) != sizes(&full.picture) {
            *self = Self::new(&full);
        }
        self.resized(&full).unwrap_or(full)
    }

    /// The scene with the sizes that are to be drawn. None where it has them already.
    #[must_use]
    pub fn resized(&self, scene: &Drawable) -> Option<Drawable> {
        if sizes(&scene.picture) == (self.drawn_size, self.drawn_grid) {
            return None;
        }
        let mut resized = scene.scene().clone();
        set_sizes(&mut resized.picture, self.drawn_size, self.drawn_grid);
        Drawable::new(resized)
            .inspect_err(|reason| error_once!("the picture keeps its resolution: {reason}"))
            .ok()
    }

    /// The share of each side at which every cell still has a pixel of its own.
    #[must_use]
    pub fn share_of_one_pixel_per_cell(&self) -> f64 {
        (self.full_grid.as_dvec2() / self.full_size.as_dvec2()).max_element()
    }

    /// Draws with this share of each side, from now on. The cells stay as they are while each has
    /// a pixel.
    pub fn set_share(&mut self, share: f64) {
        let scaled =
            |side: UVec2, share: f64| (side.as_dvec2() * share).round().as_uvec2().max(UVec2::ONE);
        self.drawn_size = if share >= 1.0 {
            self.full_size
        } else {
            scaled(self.full_size, share)
        };
        self.drawn_grid = self.full_grid.min(self.drawn_size);
        if self.drawn_grid != self.full_grid {
            // Both sides shrink by the same factor, so that cells stay square, and by a whole
            // number, so that they cover the same area as before.
            let factor = (self.full_grid.as_dvec2() / self.drawn_size.as_dvec2())
                .max_element()
                .ceil();
            // Where rounding leaves too few cells, one side has more.
            let min = (self.drawn_size + MAX_PIXELS_PER_CELL - 1) / MAX_PIXELS_PER_CELL;
            self.drawn_grid = scaled(self.full_grid, 1.0 / factor).clamp(min, self.drawn_size);
        }
    }
}

fn sizes(picture: &Picture) -> (UVec2, UVec2) {
    (
        picture.size(),
        UVec2::new(picture.grid_width, picture.grid_height),
    )
}

fn set_sizes(picture: &mut Picture, size: UVec2, grid: UVec2) {
    (picture.width, picture.height) = size.into();
    (picture.grid_width, picture.grid_height) = grid.into();
}
