//! Where the picture lies on the output.

use bevy::math::{UVec2, Vec2};
use lightfall_core::scene::Picture;

/// The rectangle of the output that the picture fills.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Letterbox {
    /// Upper left corner, in output pixels.
    pub offset: Vec2,
    /// Size, in output pixels.
    pub extent: Vec2,
}

/// Centres the picture on an output of the given size, with bars around it. Cells have the largest
/// whole scale that fits. Where the grid is bypassed, or does not fit at scale one, the picture is
/// as large as the output allows.
pub fn letterbox(picture: &Picture, output: UVec2) -> Letterbox {
    let grid = picture.grid();
    let scale = (output / grid).min_element();
    let extent = if !picture.bypass && scale > 0 {
        (grid * scale).as_vec2()
    } else {
        let shown = if picture.bypass { picture.size() } else { grid }.as_vec2();
        (shown * (output.as_vec2() / shown).min_element())
            .round()
            .max(Vec2::ONE)
    };
    Letterbox {
        offset: ((output.as_vec2() - extent) / 2.0).floor(),
        extent,
    }
}
