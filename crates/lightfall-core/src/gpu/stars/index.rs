//! Where on the sky the list's stars are: the index by which a cell of the mesh finds its own.

use super::list::PackedStars;
use glam::{UVec2, Vec2, Vec3};

/// Cells along a side of each of the cube's six faces: a cell covers 0.7 degrees.
pub(super) const SIDE: u32 = 128;

/// The contents of `STAR_INDEX`: for each cell where its stars begin, counted in pairs of numbers from
/// the start of the buffer, and at last where they end; then for each star, cell by cell, its place on
/// its face and its number. The cells are in the order of faces, rows and columns; `place_of` gives a star's.
#[must_use]
pub fn index_bytes(list: &PackedStars) -> Vec<u8> {
    let count = 6 * (SIDE * SIDE) as usize;
    let places: Vec<(u32, Vec2)> = list.directions().map(place_of).collect();
    let cell_of = |(face, place): &(u32, Vec2)| {
        let cell = (place * SIDE as f32).as_uvec2().min(UVec2::splat(SIDE - 1));
        (face * SIDE + cell.y) * SIDE + cell.x
    };
    let cells: Vec<u32> = places.iter().map(cell_of).collect();
    // Each cell's end, then moved back to its start as its stars are counted from the last one.
    let mut starts = vec![0; count + 1];
    for cell in &cells {
        starts[*cell as usize] += 1;
    }
    let first = (count as u32 + 1).div_ceil(2);
    let mut end = first;
    for start in &mut starts {
        end += *start;
        *start = end;
    }
    let mut stars = vec![[0; 2]; cells.len()];
    for (star, cell) in cells.iter().enumerate().rev() {
        let start = &mut starts[*cell as usize];
        *start -= 1;
        let [x, y] = places[star]
            .1
            .to_array()
            .map(|place| (place * 65535.0).round() as u32);
        stars[(*start - first) as usize] = [x | y << 16, star as u32];
    }
    starts.resize(2 * first as usize, 0);
    let words = starts.into_iter().chain(stars.into_iter().flatten());
    words.flat_map(u32::to_le_bytes).collect()
}

/// The face of a direction and its place there, from 0 to 1: faces are those of +x, -x, +y, -y, +z and
/// -z; on each, the other two components in cyclic order, divided by the largest one, give x and y.
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
