//! The resolution at which the window draws the picture: one that suits the window, and a coarser
//! one while something moves.

use super::settings::PictureShape;
use bevy::prelude::*;
use lightfall_core::scene::{Frame, MAX_PICTURE_SIDE, MAX_PIXELS_PER_CELL, Picture, Scene};
use lightfall_core::scene::{drawn_at_once, fit, resized};
use lightfall_render::letterbox;

/// The window that the picture is drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Canvas {
    /// Size in pixels of the part that the panels leave to the picture.
    pub size: UVec2,
    /// Size in pixels of the whole window.
    pub window: UVec2,
    /// Whether the picture has the window's shape or the scene's own.
    pub shape: PictureShape,
    /// The largest number of pixels of a picture without cells.
    pub max_pixels: u64,
}

impl Canvas {
    /// The picture of a scene that suits a part of the window of this size.
    fn fit(&self, own: &Picture, size: UVec2) -> Picture {
        let size = match self.shape {
            PictureShape::Window => size,
            PictureShape::Preset => letterbox(own, size).extent.as_uvec2(),
        };
        fit(own, size, self.max_pixels)
    }
}

/// The window, and the share of its pixels that is drawn.
#[derive(Resource, Clone, Debug)]
pub struct Resolution {
    /// The window. None until its size is known; the picture then has the scene's own size.
    canvas: Option<Canvas>,
    /// The share of each side that is drawn.
    share: f64,
}

impl Default for Resolution {
    fn default() -> Self {
        Self {
            canvas: None,
            share: 1.0,
        }
    }
}

impl Resolution {
    /// The frame of a scene with the size and the cells that are drawn in the window.
    #[must_use]
    pub fn frame(&self, scene: &Scene) -> Frame {
        let (size, cells) = self.drawn_sizes(&scene.shown_picture());
        Frame {
            cells,
            ..Frame::of(scene).with_whole(size)
        }
    }

    /// The picture of a scene with the window's shape and size, as a picture file of what the
    /// window shows without panels has it. At its own size where there is no window, or where it has
    /// the preset's shape.
    #[must_use]
    pub fn in_window(&self, own: &Picture) -> Picture {
        match self.canvas {
            Some(Canvas {
                window,
                shape: PictureShape::Window,
                ..
            }) => resized(own, window.min(UVec2::splat(MAX_PICTURE_SIDE))),
            _ => drawn_at_once(own),
        }
    }

    /// The picture of a scene as it is drawn at rest: its own where there is no window yet, and
    /// otherwise one that suits the window.
    #[must_use]
    pub fn at_rest(&self, own: &Picture) -> Picture {
        self.canvas
            .map_or_else(|| drawn_at_once(own), |canvas| canvas.fit(own, canvas.size))
    }

    /// As [`at_rest`](Self::at_rest), in a window without panels.
    #[must_use]
    pub fn at_rest_without_panels(&self, own: &Picture) -> Picture {
        self.canvas.map_or_else(
            || drawn_at_once(own),
            |canvas| canvas.fit(own, canvas.window),
        )
    }

    /// The number of pixels of the picture at rest over the number that the scene asks for.
    #[must_use]
    pub fn fineness(&self, own: &Picture) -> f64 {
        let pixels = |picture: &Picture| picture.size().as_dvec2().element_product();
        pixels(&self.at_rest(own)) / pixels(own)
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
    fn drawn_sizes(&self, own: &Picture) -> (UVec2, UVec2) {
        let full = self.at_rest(own);
        let (full_size, full_grid) = (full.size(), full.grid());
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
