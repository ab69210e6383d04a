//! The texts inside a picture: every picture that the program writes holds the preset that drew it,
//! and the rest of its record.

use super::panorama::XMP_KEY;
use super::picture_record::PictureRecord;
use std::io::{Cursor, Write};

/// The name of the preset inside a picture: of a text chunk in PNG, of an attribute in EXR. In EXR
/// the preset is in pieces, whose names end in `.00`, `.01` and so on; version 0.1 wrote one piece.
const PRESET_KEY: &str = "lightfall.preset";

/// The name of the text about the list of stars.
pub(super) const STARS_KEY: &str = "lightfall.stars";

/// Maximum length of a text in the header of an EXR file, in bytes: ffmpeg 5.1 cannot skip longer
/// ones.
pub(super) const MAX_PIECE_BYTES: usize = 255;

/// The preset in pieces for the header of an EXR file, with their names: without comments, and
/// split between lines where a line is not longer than a piece.
#[must_use]
pub fn preset_pieces(preset: &str) -> Vec<(String, String)> {
    let mut pieces = vec![String::new()];
    let is_kept = |line: &&str| !line.starts_with('#') && !line.trim().is_empty();
    for line in preset.split_inclusive('\n').filter(is_kept) {
        let mut rest = line;
        while !rest.is_empty() {
            let last = pieces.last_mut().expect("there is one from the start");
            if rest.len() <= MAX_PIECE_BYTES - last.len() {
                last.push_str(rest);
                break;
            }
            if !last.is_empty() {
                pieces.push(String::new());
                continue;
            }
            let (now, later) = rest.split_at(rest.floor_char_boundary(MAX_PIECE_BYTES));
            last.push_str(now);
            rest = later;
        }
    }
    let name = |i: usize| format!("{PRESET_KEY}.{i:02}");
    pieces
        .into_iter()
        .enumerate()
        .map(|(i, piece)| (name(i), piece))
        .collect()
}

/// The beginning of a text, as much of it as the header of an EXR file can hold.
#[must_use]
pub fn header_text(text: &str) -> &str {
    &text[..text.floor_char_boundary(MAX_PIECE_BYTES)]
}

/// The bytes with which a PNG begins.
pub const PNG_SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// The bytes with which an EXR begins.
pub const EXR_SIGNATURE: &[u8] = b"\x76\x2f\x31\x01";

/// Whether a file that begins with these bytes is a PNG or EXR picture.
#[must_use]
pub fn is_picture(bytes: &[u8]) -> bool {
    bytes.starts_with(PNG_SIGNATURE) || bytes.starts_with(EXR_SIGNATURE)
}

/// The preset in a PNG or EXR picture, or `None` if the picture holds none or its header is broken.
///
/// The preset precedes the pixels, so the first part of the file is enough.
#[must_use]
pub fn embedded_preset(bytes: &[u8]) -> Option<String> {
    embedded_text(bytes, PRESET_KEY)
}

/// The text of this name in a PNG or EXR picture, as [`embedded_preset`].
#[must_use]
pub fn embedded_text(bytes: &[u8], key: &str) -> Option<String> {
    if bytes.starts_with(PNG_SIGNATURE) {
        in_png(bytes, key)
    } else {
        in_exr(bytes, key)
    }
}

fn in_png(bytes: &[u8], key: &str) -> Option<String> {
    let reader = png::Decoder::new(Cursor::new(bytes)).read_info().ok()?;
    let chunk = reader
        .info()
        .utf8_text
        .iter()
        .find(|chunk| chunk.keyword == key)?;
    chunk.get_text().ok()
}

#[cfg(not(target_arch = "wasm32"))]
fn in_exr(bytes: &[u8], key: &str) -> Option<String> {
    use exr::meta::MetaData;
    use exr::meta::attribute::AttributeValue;
    use std::collections::BTreeMap;

    let headers = MetaData::read_from_buffered(bytes, false).ok()?.headers;
    let attributes = headers
        .iter()
        .flat_map(|header| header.own_attributes.other.iter());
    // Piece .100 comes after .99.
    let pieces: BTreeMap<(usize, &[u8]), &[u8]> = attributes
        .filter_map(|(name, value)| match value {
            AttributeValue::Text(text) if name.as_slice().starts_with(key.as_bytes()) => {
                let name = name.as_slice();
                Some(((name.len(), name), text.as_slice()))
            }
            _ => None,
        })
        .collect();
    let text = pieces.into_values().collect::<Vec<_>>().concat();
    String::from_utf8(text).ok().filter(|text| !text.is_empty())
}

/// In a browser only PNG pictures are read.
#[cfg(target_arch = "wasm32")]
fn in_exr(_: &[u8], _: &str) -> Option<String> {
    None
}

/// 8-bit RGB rows, the top one first, as a PNG that holds the record of how they were drawn.
///
/// # Errors
/// There are not as many bytes as the size says.
pub fn encoded_png(
    width: u32,
    height: u32,
    rgb: &[u8],
    record: &PictureRecord,
) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    set_up_png(&mut encoder, png::BitDepth::Eight, record)?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(rgb)?;
    writer.finish()?;
    Ok(bytes)
}

/// Prepares an encoder for a picture in sRGB with this many bits a channel and this record.
///
/// # Errors
/// The encoder refuses the record.
pub fn set_up_png<W: Write>(
    encoder: &mut png::Encoder<W>,
    depth: png::BitDepth,
    record: &PictureRecord,
) -> Result<(), png::EncodingError> {
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(depth);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_filter(png::Filter::Adaptive);
    add_record(encoder, record)
}

/// Writes the record of a picture into the header of its PNG.
///
/// # Errors
/// The encoder refuses it.
fn add_record<W: Write>(
    encoder: &mut png::Encoder<W>,
    record: &PictureRecord,
) -> Result<(), png::EncodingError> {
    encoder.add_itxt_chunk(PRESET_KEY.into(), record.preset.clone())?;
    for (name, text) in &record.texts {
        encoder.add_itxt_chunk((*name).into(), text.clone())?;
    }
    if let Some(panorama) = &record.panorama {
        encoder.add_itxt_chunk(XMP_KEY.into(), panorama.clone())?;
    }
    Ok(())
}
