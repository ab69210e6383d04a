//! The size of a draw call. A driver resets a device that does not respond for some seconds;
//! between two calls every device responds.

use lightfall_model::scene::Scene;

/// Maximum number of pixels of a draw call: a full HD picture.
const MAX_PIXELS: u32 = 1920 * 1080;

/// Maximum number of pixels of a scene in one draw call, which is smaller where rays may take more
/// steps than the article's.
pub fn max_pixels_of_call(scene: &Scene) -> u32 {
    (f64::from(MAX_PIXELS) / scene.budget_ratio()) as u32
}

/// The first row and the number of rows of each band of a picture that one call draws, with `most`
/// pixels each, but at least one row.
pub fn bands(width: u32, height: u32, most: u32) -> impl Iterator<Item = (u32, u32)> {
    let rows = (most / width.max(1)).max(1);
    (0..height)
        .step_by(rows as usize)
        .map(move |top| (top, rows.min(height - top)))
}
