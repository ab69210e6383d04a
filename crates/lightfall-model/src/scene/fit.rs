//! The size of a picture that fills an output: a window, or a picture file.

use super::{MAX_PICTURE_SIDE, MAX_PIXELS_PER_CELL, Picture};
use glam::UVec2;

/// The picture with a size and a grid that fill an output of `size` pixels. The vertical field of
/// view stays, and the output's shape decides how far the picture reaches to the sides.
///
/// Cells are squares of equally many output pixels: as many as make the number of rows nearest to
/// `picture.grid_height`. Where the output is no whole number of cells, its edge cuts through the
/// outermost ones, so the grid may be larger than the output by less than one cell. A cell is
/// traced with as many pixels as in the picture given.
///
/// Without cells the picture is traced at the size of the output, with at most `max_pixels` pixels.
#[must_use]
pub fn fit(picture: &Picture, size: UVec2, max_pixels: u64) -> Picture {
    let size = size.max(UVec2::ONE);
    let scale = cell_scale(picture, size);
    let grid = (size + scale - 1) / scale;
    let (traced, grid) = if picture.bypass {
        let traced = limited(size, max_pixels);
        // The grid is not shown, but has to be one that this picture could have.
        let min = (traced + MAX_PIXELS_PER_CELL - 1) / MAX_PIXELS_PER_CELL;
        (traced, grid.clamp(min, traced))
    } else {
        (grid * pixels_per_cell(picture, grid), grid)
    };
    Picture {
        width: traced.x,
        height: traced.y,
        grid_width: grid.x,
        grid_height: grid.y,
        ..*picture
    }
}

/// The picture with another size, as a scene keeps it. The number of rows of its cells stays, as far
/// as cells may have from 1 to `MAX_PIXELS_PER_CELL` pixels to a side, and that of its columns
/// follows the size.
#[must_use]
pub fn resized(picture: &Picture, size: UVec2) -> Picture {
    let columns = fit(picture, size, u64::MAX).grid_width;
    let min = (size + MAX_PIXELS_PER_CELL - 1) / MAX_PIXELS_PER_CELL;
    let max = size.min(UVec2::splat(MAX_PICTURE_SIDE));
    let grid = UVec2::new(columns, picture.grid_height).clamp(min, max);
    Picture {
        width: size.x,
        height: size.y,
        grid_width: grid.x,
        grid_height: grid.y,
        ..*picture
    }
}

/// The picture with the size in which a window can draw it: its own, or a smaller one of the same shape.
#[must_use]
pub fn drawn_at_once(picture: &Picture) -> Picture {
    let size = limited(picture.size(), u64::MAX);
    if size == picture.size() {
        *picture
    } else {
        resized(picture, size)
    }
}

/// Output pixels per side of a cell. The grid has at most `MAX_PICTURE_SIDE` cells to a side.
fn cell_scale(picture: &Picture, size: UVec2) -> u32 {
    let rows = f64::from(picture.grid_height.max(1));
    let scale = (f64::from(size.y) / rows).round() as u32;
    scale
        .max(size.max_element().div_ceil(MAX_PICTURE_SIDE))
        .max(1)
}

/// Traced pixels per side of a cell: a whole number, so that no pixel belongs to two cells.
fn pixels_per_cell(picture: &Picture, grid: UVec2) -> u32 {
    let own = f64::from(picture.height) / f64::from(picture.grid_height.max(1));
    let max = (MAX_PICTURE_SIDE / grid.max_element()).min(MAX_PIXELS_PER_CELL);
    (own.round() as u32).clamp(1, max.max(1))
}

/// The largest size of the same shape with at most this many pixels and sides that can be drawn.
fn limited(size: UVec2, max_pixels: u64) -> UVec2 {
    let wanted = size.as_dvec2();
    let by_area = (max_pixels as f64 / (wanted.x * wanted.y)).sqrt();
    let by_side = f64::from(MAX_PICTURE_SIDE) / wanted.max_element();
    let share = by_area.min(by_side).min(1.0);
    (wanted * share)
        .round()
        .as_uvec2()
        .clamp(UVec2::ONE, UVec2::splat(MAX_PICTURE_SIDE))
}
