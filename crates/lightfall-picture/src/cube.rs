//! One picture of the six sides of a cube.

use lightfall_core::scene::CubeLayout;
use lightfall_render::Captured;

/// The values of a whole picture, rows from the top, of those of its sides in the order of the layout.
/// Each side has `side` pixels to a side, and each pixel this many values.
fn joined<T: Copy>(layout: CubeLayout, side: u32, per_pixel: usize, sides: &[&[T]]) -> Vec<T> {
    let line = side as usize * per_pixel;
    let rows = sides.chunks(layout.columns as usize).flat_map(|beside| {
        (0..side as usize).flat_map(move |row| {
            beside
                .iter()
                .map(move |values| &values[row * line..][..line])
        })
    });
    rows.flatten().copied().collect()
}

/// The levels of six sides of `side` pixels: red, green and blue of each pixel.
#[must_use]
pub fn joined_levels(layout: CubeLayout, side: u32, sides: &[Vec<u16>]) -> Vec<u16> {
    let values: Vec<&[u16]> = sides.iter().map(|levels| &**levels).collect();
    joined(layout, side, 3, &values)
}

/// The light of six sides of the same size.
#[must_use]
pub fn joined_light(layout: CubeLayout, sides: &[Captured]) -> Captured {
    let side = sides.first().map_or(0, |light| light.size.x);
    let values: Vec<&[[u16; 4]]> = sides.iter().map(|light| &*light.rgba).collect();
    Captured {
        size: layout.size(side),
        rgba: joined(layout, side, 1, &values),
        depth: None,
    }
}

/// The numbers of each channel of six sides of `side` pixels, of the lists of their channels.
#[must_use]
pub fn joined_channels(layout: CubeLayout, side: u32, sides: &[Vec<Vec<f32>>]) -> Vec<Vec<f32>> {
    let count = sides.first().map_or(0, Vec::len);
    let of_channel = |channel: usize| {
        let values: Vec<&[f32]> = sides.iter().map(|list| &*list[channel]).collect();
        joined(layout, side, 1, &values)
    };
    (0..count).map(of_channel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of one pixel a side is the list of the sides, row by row; one of two pixels a side has
    /// the upper rows of the first three sides first.
    #[test]
    fn the_sides_of_a_cube_lie_row_by_row() {
        let single: Vec<[u8; 3]> = (0..6).map(|i| [i, 10 + i, 20 + i]).collect();
        let sides: Vec<&[u8]> = single.iter().map(|side| &side[..]).collect();
        let whole = joined(CubeLayout::THREE_BY_TWO, 1, 3, &sides);
        assert_eq!(whole, single.concat());
        let double: Vec<[u8; 4]> = (0..6).map(|i| [i, 10 + i, 20 + i, 30 + i]).collect();
        let sides: Vec<&[u8]> = double.iter().map(|side| &side[..]).collect();
        let whole = joined(CubeLayout::THREE_BY_TWO, 2, 1, &sides);
        assert_eq!(whole[..12], [0, 10, 1, 11, 2, 12, 20, 30, 21, 31, 22, 32]);
        assert_eq!(joined(CubeLayout::COLUMN, 2, 1, &sides), double.concat());
    }
}
