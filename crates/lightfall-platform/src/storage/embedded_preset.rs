//! The preset inside a picture: every picture that the program writes holds the preset that drew
//! it.

use std::io::Cursor;

/// The name of the preset inside a picture: of a text chunk in PNG, of an attribute in EXR.
pub const PRESET_KEY: &str = "lightfall.preset";

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

    let headers = MetaData::read_from_buffered(bytes, false).ok()?.headers;
    let mut attributes = headers
        .iter()
        .flat_map(|header| header.own_attributes.other.iter());
    let text = attributes.find_map(|(name, value)| match value {
        AttributeValue::Text(text) if name.as_slice() == PRESET_KEY.as_bytes() => {
            Some(text.as_slice())
        }
        _ => None,
    })?;
    String::from_utf8(text.to_vec()).ok()
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
