//! Sizes in pixels.

use glam::UVec2;
use lightfall_core::scene::{MAX_FILE_SIDE, MAX_PICTURE_SIDE};

/// Reads a size such as `960x540` of a picture that is drawn at once.
pub(super) fn size(text: &str) -> Result<UVec2, String> {
    size_up_to(MAX_PICTURE_SIDE, text)
}

/// Reads the size of a picture file.
pub(super) fn file_size(text: &str) -> Result<UVec2, String> {
    size_up_to(MAX_FILE_SIDE, text)
}

fn size_up_to(most: u32, text: &str) -> Result<UVec2, String> {
    let side = |side: &str| side.parse().ok().filter(|side| (1..=most).contains(side));
    let (width, height) = text.split_once(['x', 'X']).unwrap_or_default();
    side(width)
        .zip(side(height))
        .map(UVec2::from)
        .ok_or(format!(
            "a size is WxH, such as 960x540, each from 1 to {most}"
        ))
}
