//! Picture files: they appear whole or not at all.

use crate::storage::{PRESET_KEY, WriteError, check_writable, write_atomically};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Why a picture could not be made or written; each is one sentence.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The name has no extension that this program writes.
    #[error("{path}: {}; allowed are .png and .exr", ending(.extension))]
    Extension {
        /// The file asked for.
        path: PathBuf,
        /// Its extension, without the dot.
        extension: String,
    },
    /// The folder or file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The picture could not be encoded.
    #[error("{path}: the picture could not be encoded: {reason}")]
    Encode {
        /// The file asked for.
        path: PathBuf,
        /// What the encoder says.
        reason: String,
    },
    /// The device cannot draw a picture this large.
    #[error("{field} = {width}x{height}: this device draws pictures of 1 to {limit} pixels a side")]
    Size {
        /// Which size.
        field: &'static str,
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
        /// Largest side.
        limit: u32,
    },
    /// The chain failed.
    #[error("the picture could not be drawn: {0}")]
    Draw(String),
    /// Somebody has stopped the program.
    #[error("interrupted; the pictures written before are whole")]
    Interrupted,
}

/// What is wrong with the ending of a file's name.
fn ending(extension: &str) -> String {
    if extension.is_empty() {
        return "the name has no ending that says which picture format to write".into();
    }
    format!("unknown picture format {extension:?}")
}

/// What kind of picture a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// What a window would show, in 8 bits a channel.
    Png,
    /// Linear light, and what rays tell.
    Exr,
}

/// Checks that a picture can be written at `path`, before any work is done for it, and tells of
/// which kind it will be.
///
/// # Errors
/// An unknown extension, or a folder that does not exist or cannot be written.
pub fn check_path(path: &Path) -> Result<Format, PictureError> {
    let extension = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    let format = match extension.to_ascii_lowercase().as_str() {
        "png" => Format::Png,
        "exr" => Format::Exr,
        _ => {
            return Err(PictureError::Extension {
                path: path.into(),
                extension,
            });
        }
    };
    if path.is_dir() {
        let reason = io::Error::new(ErrorKind::IsADirectory, "it is a folder");
        return Err(WriteError::new(path, reason).into());
    }
    check_writable(path)?;
    Ok(format)
}

/// Writes 8-bit RGB rows, top first, as a PNG, with the preset that drew them inside. The file
/// appears under its name only when it is complete.
///
/// # Errors
/// What the encoder or the file system says, with the file's name.
pub fn write_png(
    path: &Path,
    width: u32,
    height: u32,
    rgb: &[u8],
    preset: &str,
) -> Result<(), PictureError> {
    let bytes = encoded(width, height, rgb, preset).map_err(|error| PictureError::Encode {
        path: path.into(),
        reason: error.to_string(),
    })?;
    Ok(write_atomically(path, &bytes)?)
}

fn encoded(
    width: u32,
    height: u32,
    rgb: &[u8],
    preset: &str,
) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Adaptive);
    encoder.add_itxt_chunk(PRESET_KEY.into(), preset.into())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(rgb)?;
    writer.finish()?;
    Ok(bytes)
}
