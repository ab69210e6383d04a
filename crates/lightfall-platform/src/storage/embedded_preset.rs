//! The preset inside a picture: every picture that the program writes holds the preset that drew
//! it.

use std::io::Cursor;

/// The name of the preset inside a picture: of a text chunk in PNG, of an attribute in EXR. In EXR
/// the preset is in pieces, whose names end in `.00`, `.01` and so on; version 0.1 wrote one piece.
pub const PRESET_KEY: &str = "lightfall.preset";

/// Maximum length of a text in the header of an EXR file, in bytes: ffmpeg 5.1 cannot skip longer
/// ones.
const MAX_PIECE_BYTES: usize = 255;

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

const PNG_SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
const EXR_SIGNATURE: &[u8] = b"\x76\x2f\x31\x01";

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
    if bytes.starts_with(PNG_SIGNATURE) {
        in_png(bytes)
    } else {
        in_exr(bytes)
    }
}

fn in_png(bytes: &[u8]) -> Option<String> {
    let reader = png::Decoder::new(Cursor::new(bytes)).read_info().ok()?;
    let chunk = reader
        .info()
        .utf8_text
        .iter()
        .find(|chunk| chunk.keyword == PRESET_KEY)?;
    chunk.get_text().ok()
}

#[cfg(not(target_arch = "wasm32"))]
fn in_exr(bytes: &[u8]) -> Option<String> {
    use exr::meta::MetaData;
    use exr::meta::attribute::AttributeValue;
    use std::collections::BTreeMap;

    let headers = MetaData::read_from_buffered(bytes, false).ok()?.headers;
    let attributes = headers
        .iter()
        .flat_map(|header| header.own_attributes.other.iter());
    let pieces: BTreeMap<&[u8], &[u8]> = attributes
        .filter_map(|(name, value)| match value {
            AttributeValue::Text(text) if name.as_slice().starts_with(PRESET_KEY.as_bytes()) => {
                Some((name.as_slice(), text.as_slice()))
            }
            _ => None,
        })
        .collect();
    let text = pieces.into_values().collect::<Vec<_>>().concat();
    String::from_utf8(text).ok().filter(|text| !text.is_empty())
}

/// In a browser only PNG pictures are read.
#[cfg(target_arch = "wasm32")]
fn in_exr(_: &[u8]) -> Option<String> {
    None
}

/// 8-bit RGB rows, the top one first, as a PNG that holds the preset that drew them.
///
/// # Errors
/// There are not as many bytes as the size says.
pub fn encoded_png(
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
