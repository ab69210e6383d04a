//! Reads the file of a picture of the sky.

use super::error::SkyPictureFault;
use super::panorama::Panorama;
use super::{MAX_FILE_BYTES, SkyPicture, cube};
use super::{exr_file, jpeg, png_file, radiance};
use sha2::{Digest, Sha256};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// The picture of a file.
///
/// # Errors
/// The file cannot be read, is no picture or is damaged; or the picture is not one of the whole sky,
/// is too large, or has texels that are no light.
pub(super) fn read(path: &Path) -> Result<SkyPicture, SkyPictureFault> {
    let bytes = contents(path)?;
    let panorama = decoded(&bytes)?;
    let size = [panorama.width as u32, panorama.height as u32];
    let sha256 = Sha256::digest(&bytes);
    drop(bytes);
    let (side, levels) = cube::levels(panorama);
    Ok(SkyPicture {
        name: path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into(),
        sha256: sha256.iter().map(|byte| format!("{byte:02x}")).collect(),
        size,
        side,
        levels,
    })
}

fn contents(path: &Path) -> Result<Vec<u8>, SkyPictureFault> {
    let unreadable = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => SkyPictureFault::Missing,
        _ => SkyPictureFault::Unreadable {
            reason: error.to_string(),
        },
    };
    // A pipe would wait for ever.
    let found = fs::metadata(path).map_err(unreadable)?;
    if !found.is_file() {
        return Err(SkyPictureFault::NotAFile);
    }
    if found.len() > MAX_FILE_BYTES {
        let megabytes = found.len() >> 20;
        return Err(SkyPictureFault::TooLong { megabytes });
    }
    fs::read(path).map_err(unreadable)
}

/// The picture of a file with these contents. Its first bytes say which format it has.
fn decoded(bytes: &[u8]) -> Result<Panorama, SkyPictureFault> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => png_file::decoded(bytes),
        [0x76, 0x2f, 0x31, 0x01, ..] => exr_file::decoded(bytes),
        [0xff, 0xd8, 0xff, ..] => jpeg::decoded(bytes),
        [b'#', b'?', ..] => radiance::decoded(bytes),
        _ => Err(SkyPictureFault::NoPicture),
    }
}
