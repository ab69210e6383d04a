//! How much of a picture one draw call traces. A driver ends a device that does not respond for some
//! seconds, and between two calls every device does.

use lightfall_model::scene::Scene;

/// Most pixels that one draw call traces: a full HD picture.
const MAX_PIXELS: u32 = 1920 * 1080;

/// Most pixels of a scene that one draw call traces. Where rays may take more steps than the
/// article's, a call has fewer of them, so that it never takes more steps.
#[must_use]
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
