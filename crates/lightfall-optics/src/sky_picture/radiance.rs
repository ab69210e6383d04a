//! Pictures of the sky in Radiance's HDR (Ward 1991, "Real Pixels"): a text of lines, and pixels of
//! three mantissas with a common exponent, each channel of a row in runs.

use super::error::SkyPictureFault;
use super::panorama::{Panorama, check_size};

/// The format that is read, in the header.
const FORMAT: &str = "32-bit_rle_rgbe";

/// The exponent of a mantissa of one 256th.
const BIAS: i32 = 128 + 8;

/// The widths of rows whose channels are in runs of their own.
const RUN_WIDTHS: std::ops::Range<usize> = 8..32_768;

/// The picture of an HDR file, in linear light.
pub(super) fn decoded(bytes: &[u8]) -> Result<Panorama, SkyPictureFault> {
    let mut rest = bytes;
    let mut scale = 1.0;
    loop {
        let line = line(&mut rest)?;
        if line.is_empty() {
            break;
        }
        if let Some(format) = line.strip_prefix("FORMAT=")
            && format.trim() != FORMAT
        {
            return Err(SkyPictureFault::broken(
                "its colours are not red, green and blue",
            ));
        }
        // Several exposures multiply. Light is the pixels divided by them.
        if let Some(exposure) = line.strip_prefix("EXPOSURE=") {
            let exposure = exposure.trim().parse::<f32>().ok();
            let exposure = exposure.filter(|exposure| *exposure > 0.0 && exposure.is_finite());
            scale /=
                exposure.ok_or_else(|| SkyPictureFault::broken("its exposure is no number"))?;
        }
    }
    let resolution = line(&mut rest)?;
    let words: Vec<&str> = resolution.split_whitespace().collect();
    let ["-Y", height, "+X", width] = words[..] else {
        return Err(SkyPictureFault::broken("its rows do not run from the top"));
    };
    let side = |word: &str| word.parse::<u32>().map_err(SkyPictureFault::broken);
    let (width, height) = (side(width)?, side(height)?);
    check_size(width, height)?;
    let mut light = Vec::with_capacity(width as usize * height as usize);
    let mut row = vec![[0; 4]; width as usize];
    for _ in 0..height {
        read_row(&mut rest, &mut row)?;
        light.extend(row.iter().map(|pixel| pixel_light(*pixel, scale)));
    }
    Panorama::new([width, height], light)
}

/// The next line of the header, without its end.
fn line<'a>(rest: &mut &'a [u8]) -> Result<&'a str, SkyPictureFault> {
    let end = rest.iter().position(|byte| *byte == b'\n');
    let end = end.ok_or_else(incomplete)?;
    let line = std::str::from_utf8(&rest[..end]).map_err(SkyPictureFault::broken)?;
    *rest = &rest[end + 1..];
    Ok(line.trim_end_matches('\r'))
}

fn incomplete() -> SkyPictureFault {
    SkyPictureFault::broken("it ends too early")
}

fn bytes<'a>(rest: &mut &'a [u8], count: usize) -> Result<&'a [u8], SkyPictureFault> {
    let (taken, after) = rest.split_at_checked(count).ok_or_else(incomplete)?;
    *rest = after;
    Ok(taken)
}

fn read_row(rest: &mut &[u8], row: &mut [[u8; 4]]) -> Result<(), SkyPictureFault> {
    let width = row.len();
    let begins_runs = match rest {
        [2, 2, high, low, ..] => usize::from(u16::from_be_bytes([*high, *low])) == width,
        _ => false,
    };
    if !(begins_runs && RUN_WIDTHS.contains(&width)) {
        return read_whole_pixels(rest, row);
    }
    bytes(rest, 4)?;
    for channel in 0..4 {
        let mut column = 0;
        while column < width {
            let count = usize::from(bytes(rest, 1)?[0]);
            // A count above 128 repeats one byte.
            let (count, repeats) = if count > 128 {
                (count - 128, true)
            } else {
                (count, false)
            };
            if count == 0 || column + count > width {
                return Err(SkyPictureFault::broken("a run is longer than its row"));
            }
            let values = bytes(rest, if repeats { 1 } else { count })?;
            for (i, pixel) in row[column..column + count].iter_mut().enumerate() {
                pixel[channel] = values[if repeats { 0 } else { i }];
            }
            column += count;
        }
    }
    Ok(())
}

/// A row of whole pixels. The mantissas 1, 1, 1 repeat the pixel before as often as the fourth byte
/// says, and each further such pixel counts 256 times as much.
fn read_whole_pixels(rest: &mut &[u8], row: &mut [[u8; 4]]) -> Result<(), SkyPictureFault> {
    let (mut column, mut shift) = (0, 0);
    while column < row.len() {
        let pixel = bytes(rest, 4)?;
        if let [1, 1, 1, count] = *pixel {
            let count = usize::from(count) << shift;
            let is_possible = column > 0 && count <= row.len() - column && shift <= 16;
            if !is_possible {
                return Err(SkyPictureFault::broken("a run is longer than its row"));
            }
            let before = row[column - 1];
            row[column..column + count].fill(before);
            (column, shift) = (column + count, shift + 8);
        } else {
            row[column].copy_from_slice(pixel);
            (column, shift) = (column + 1, 0);
        }
    }
    Ok(())
}

fn pixel_light([r, g, b, exponent]: [u8; 4], scale: f32) -> [f32; 3] {
    if exponent == 0 {
        return [0.0; 3];
    }
    let unit = scale * ((i32::from(exponent) - BIAS) as f32).exp2();
    [r, g, b].map(|mantissa| f32::from(mantissa) * unit)
}
