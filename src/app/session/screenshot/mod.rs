//! Screenshots: the picture by itself, or what the window shows.

#[cfg(target_arch = "wasm32")]
mod downloads;
#[cfg(not(target_arch = "wasm32"))]
mod files;

#[cfg(target_arch = "wasm32")]
pub(crate) use downloads::plugin;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use files::plugin;

use bevy::prelude::*;
use std::time::Duration;

/// How long the window says at least where a picture was saved.
const SAVED: Duration = Duration::from_secs(4);

/// The size of a picture of the window, and its pixels: 8-bit RGB, rows from the top.
///
/// # Errors
/// The picture has a format that cannot be converted.
fn pixels(image: Image) -> Result<(UVec2, Vec<u8>), String> {
    let image = image
        .try_into_dynamic()
        .map_err(|error| error.to_string())?
        .to_rgb8();
    Ok(((image.width(), image.height()).into(), image.into_raw()))
}
