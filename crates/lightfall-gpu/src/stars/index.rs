//! The index over the sky by which a cell of the mesh finds its stars.
//!
//! Stars are in layers by brightness, because a cell that sees much of the sky shows only bright
//! ones. Fainter layers have more stars and smaller cells.

use super::list::PackedStars;
use glam::{UVec2, Vec2, Vec3};
use std::ops::Range;

pub(super) const LAYERS: u32 = 4;

/// Cells of the brightest layer along a side of each of the cube's six faces. Each next layer has
/// twice as many; a cell of the last one covers 0.7 degrees.
pub(super) const FIRST_SIDE: u32 = 32;

/// The cells of a layer along a side of a face.
fn side(layer: u32) -> u32 {
    FIRST_SIDE << layer
}

fn cell_count(layer: u32) -> u32 {
    6 * side(layer) * side(layer)
}

/// The stars of a layer: as many as it has cells, and in the last one all others.
fn stars_of(layer: u32, list: &PackedStars) -> Range<u32> {
    let first: u32 = (0..layer).map(cell_count).sum();
    let last = if layer + 1 < LAYERS {
        first + cell_count(layer)
    } else {
        u32::MAX
    };
    first.min(list.len())..last.min(list.len())
}

/// The contents of `STAR_INDEX`: layer by layer the start of each cell's stars, counted in pairs of
/// numbers from the start of the buffer, and at last the end; then for each star, cell by cell, its
/// place on its face and its number. The cells of a layer are in the order of faces, rows and
/// columns.
pub fn index_bytes(list: &PackedStars) -> Vec<u8> {
    let places: Vec<(u32, Vec2)> = list.directions().map(place_of).collect();
    let numbers: u32 = (0..LAYERS).map(|layer| cell_count(layer) + 1).sum();
    let first_pair = numbers.div_ceil(2);
    let mut starts = Vec::new();
    let mut stars = vec![[0; 2]; places.len()];
    for layer in 0..LAYERS {
        let range = stars_of(layer, list);
        let cell_of = |star: u32| {
            let (face, place) = places[star as usize];
            let side = side(layer);
            let cell = (place * side as f32).as_uvec2().min(UVec2::splat(side - 1));
            ((face * side + cell.y) * side + cell.x) as usize
        };
        // Each cell's end, which moves back to its start as its stars are placed from the last one.
        let mut ends = vec![0; cell_count(layer) as usize + 1];
        for star in range.clone() {
            ends[cell_of(star)] += 1;
        }
        let mut end = first_pair + range.start;
        for here in &mut ends {
            end += *here;
            *here = end;
        }
        for star in range.rev() {
            let start = &mut ends[cell_of(star)];
            *start -= 1;
            let place = places[star as usize].1.to_array();
            let [x, y] = place.map(|place| (place * 65535.0).round() as u32);
            stars[(*start - first_pair) as usize] = [x | y << 16, star];
        }
        starts.extend(ends);
    }
    starts.resize(2 * first_pair as usize, 0);
    let words = starts.into_iter().chain(stars.into_iter().flatten());
    words.flat_map(u32::to_le_bytes).collect()
}

/// The face of a direction and its place there, from 0 to 1: faces are those of +x, -x, +y, -y, +z
/// and -z; on each, the other two components in cyclic order, divided by the largest one, give x
/// and y.
fn place_of(direction: Vec3) -> (u32, Vec2) {
    let size = direction.abs();
    let axis = if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    let components = direction.to_array();
    let across = [1, 2].map(|offset| components[(axis + offset) % 3] / size[axis]);
    let face = 2 * axis as u32 + u32::from(components[axis] < 0.0);
    (face, 0.5 * (Vec2::from(across) + 1.0))
}
