//! What screenshots have in common, wherever they go.

use bevy::prelude::*;
use std::time::Duration;

/// How long the window says at least where a picture was saved.
pub(super) const SAVED: Duration = Duration::from_secs(4);

/// The size of a picture of the window, and its pixels: 8-bit RGB, rows from the top.
///
/// # Errors
/// The picture has a format that cannot be converted.
pub(super) fn pixels(image: Image) -> Result<(UVec2, Vec<u8>), String> {
    let image = image
        .try_into_dynamic()
        .map_err(|error| error.to_string())?
        .to_rgb8();
    Ok(((image.width(), image.height()).into(), image.into_raw()))
}
