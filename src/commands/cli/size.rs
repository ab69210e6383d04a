//! Sizes in pixels.

use glam::UVec2;
use lightfall_core::scene::MAX_PICTURE_SIDE;

/// Reads a size such as `960x540`.
pub(super) fn size(text: &str) -> Result<UVec2, String> {
    let side = |side: &str| {
        side.parse()
            .ok()
            .filter(|side| (1..=MAX_PICTURE_SIDE).contains(side))
    };
    let (width, height) = text.split_once(['x', 'X']).unwrap_or_default();
    side(width)
        .zip(side(height))
        .map(UVec2::from)
        .ok_or(format!(
            "a size is WxH, such as 960x540, each from 1 to {MAX_PICTURE_SIDE}"
        ))
}
