//! The resolution at which the window draws the picture: one that suits the window, and a coarser
//! one while something moves. The scene's own resolution is kept here, so that nothing is lost.

use super::settings::PictureShape;
use bevy::prelude::*;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Frame, MAX_PICTURE_SIDE, MAX_PIXELS_PER_CELL, Picture, Scene};
use lightfall_render::{fit, letterbox, resized};

/// The window that the picture is drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Canvas {
    /// Size in pixels.
    pub size: UVec2,
    /// Whether the picture has the window's shape or the scene's own.
    pub shape: PictureShape,
    /// The largest number of pixels of a picture without cells.
    pub max_pixels: u64,
}

/// The scene's own resolution, and the one that is drawn.
#[derive(Resource, Clone, Debug)]
pub struct Resolution {
    /// Size and cells that the scene asks for.
    own_size: UVec2,
    own_grid: UVec2,
    /// The window. None until its size is known; the picture then has the scene's own size.
    canvas: Option<Canvas>,
    /// The share of each side that is drawn.
    share: f64,
}

impl Resolution {
    /// The resolution of a scene, to be drawn in full.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let (own_size, own_grid) = sizes(&scene.picture);
        Self {
            own_size,
            own_grid,
            canvas: None,
            share: 1.0,
        }
    }

    /// The scene at its own resolution, from the scene that is drawn.
    #[must_use]
    pub fn full_scene(&self, drawn: &Scene) -> Scene {
        let mut scene = drawn.clone();
        set_sizes(&mut scene.picture, (self.own_size, self.own_grid));
        scene
    }

    /// Keeps the resolution of a scene that has its own resolution, and returns the scene at the
    /// resolution that is drawn.
    #[must_use]
    pub fn adopt(&mut self, full: &Drawable) -> Drawable {
        (self.own_size, self.own_grid) = sizes(&full.picture);
        full.shown_in(&self.frame(full))
    }

    /// The frame of the scene with the sizes that are to be drawn.
    #[must_use]
    pub fn frame(&self, scene: &Scene) -> Frame {
        let (size, cells) = self.drawn_sizes(&scene.picture);
        Frame {
            cells,
            ..Frame::of(scene).with_whole(size)
        }
    }

    /// The scene with a picture of the window's shape and size, as a picture file of what the
    /// window shows has it. At its own size where there is no window, or where it has the preset's
    /// shape.
    #[must_use]
    pub fn scene_in_window(&self, drawn: &Scene) -> Scene {
        let mut scene = self.full_scene(drawn);
        if let Some(Canvas {
            size,
            shape: PictureShape::Window,
            ..
        }) = self.canvas
        {
            let size = size.min(UVec2::splat(MAX_PICTURE_SIDE));
            scene.picture = resized(&scene.picture, size);
        }
        scene
    }

    /// The scene as it is drawn for a picture file of what the window shows: in the window's own
    /// cells, or at the file's full size.
    #[must_use]
    pub fn drawn_for_file(&self, drawn: &Scene) -> Scene {
        let mut scene = self.scene_in_window(drawn);
        scene.picture = if drawn.picture.bypass {
            fit(&scene.picture, scene.picture.size(), u64::MAX)
        } else {
            self.picture_at_rest(&drawn.picture)
        };
        scene
    }

    /// The picture as it is drawn at rest: the scene's own where there is no window yet, and
    /// otherwise one that suits the window. Only the other fields of `drawn` are used.
    #[must_use]
    pub fn picture_at_rest(&self, drawn: &Picture) -> Picture {
        let mut picture = *drawn;
        set_sizes(&mut picture, (self.own_size, self.own_grid));
        match self.canvas {
            None => picture,
            Some(Canvas {
                size,
                shape,
                max_pixels,
            }) => {
                let size = match shape {
                    PictureShape::Window => size,
                    PictureShape::Preset => letterbox(&picture, size).extent.as_uvec2(),
                };
                fit(&picture, size, max_pixels)
            }
        }
    }

    /// Whether the picture at rest has more pixels than the scene asks for.
    #[must_use]
    pub fn is_finer_than_the_scene(&self, drawn: &Picture) -> bool {
        let pixels = |size: UVec2| u64::from(size.x) * u64::from(size.y);
        pixels(self.picture_at_rest(drawn).size()) > pixels(self.own_size)
    }

    /// The share of each side at which the picture has as many pixels as the scene asks for.
    #[must_use]
    pub fn share_of_own_size(&self, drawn: &Picture) -> f64 {
        let area = |size: UVec2| size.as_dvec2().element_product();
        (area(self.own_size) / area(self.picture_at_rest(drawn).size()))
            .sqrt()
            .min(1.0)
    }

    /// Draws for this window from now on.
    pub fn set_canvas(&mut self, canvas: Canvas) {
        self.canvas = Some(canvas);
    }

    /// Draws with this share of each side, from now on.
    pub fn set_share(&mut self, share: f64) {
        self.share = share;
    }

    /// Size and grid of the picture that is drawn. The cells stay as they are while each has a
    /// pixel.
    fn drawn_sizes(&self, drawn: &Picture) -> (UVec2, UVec2) {
        let (full_size, full_grid) = sizes(&self.picture_at_rest(drawn));
        if self.share >= 1.0 {
            return (full_size, full_grid);
        }
        let size = (full_size.as_dvec2() * self.share)
            .round()
            .as_uvec2()
            .max(UVec2::ONE);
        // Cells grow by a whole factor, so that they cover the same area as before.
        let factor = ((full_grid + size - 1) / size).max_element();
        // Where rounding leaves too few cells, one side has more.
        let min = (size + MAX_PIXELS_PER_CELL - 1) / MAX_PIXELS_PER_CELL;
        let grid = ((full_grid + factor - 1) / factor).clamp(min, size);
        (size, grid)
    }
}

fn sizes(picture: &Picture) -> (UVec2, UVec2) {
    (picture.size(), picture.grid())
}

fn set_sizes(picture: &mut Picture, (size, grid): (UVec2, UVec2)) {
    (picture.width, picture.height) = size.into();
    (picture.grid_width, picture.grid_height) = grid.into();
}
