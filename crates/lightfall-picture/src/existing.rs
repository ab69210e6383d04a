//! Pictures that exist already: whether a file is whole, and whether it is the picture that would be drawn.

use super::exr_header;
use super::{Channels, ExrForm, PngBits};
use exr::meta::MetaData;
use exr::meta::header::Header;
use glam::UVec2;
use lightfall_platform::storage::{
    EXR_SIGNATURE, PNG_SIGNATURE, PictureRecord, embedded_preset, embedded_text,
};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::{self, Cursor, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;

/// How much of a file is read to know what it is. The texts of a picture precede its pixels, and a preset has a
/// few kilobytes.
const HEAD_BYTES: u64 = 1 << 20;

/// The field that may differ where the exposure is metered.
const METERED: &str = "picture.exposure_ev";

/// The texts beside the preset that decide pixels, with words for them.
const DECISIVE: [(&str, &str); 3] = [
    ("lightfall.version", "the version of the program"),
    ("lightfall.stars", "the list of stars"),
    ("lightfall.sky", "the picture of the sky"),
];

/// A picture that would be drawn.
#[derive(Clone, Debug)]
pub struct Wanted<'a> {
    /// Its size.
    pub size: UVec2,
    /// Its record; the adapter is not compared, because machines have different ones.
    pub record: &'a PictureRecord,
    /// Whether its exposure is metered while it is drawn.
    pub is_metered: bool,
    /// The form of its file.
    pub form: WantedForm<'a>,
}

/// The form of the file of a picture that would be drawn.
#[derive(Clone, Copy, Debug)]
pub enum WantedForm<'a> {
    /// A PNG.
    Png(PngBits),
    /// An EXR with these channels beside its light.
    Exr(&'a Channels, ExrForm),
}

/// What stands in the place of a picture that would be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// There is no file.
    Nothing,
    /// The file ends too early, or its parts do not fit together.
    Partial,
    /// The picture is there.
    Whole,
}

/// Looks whether the picture is there.
///
/// # Errors
/// The file is whole and holds something else, or cannot be read. The sentence continues one that begins
/// with the file's name.
pub fn find_picture(path: &Path, wanted: &Wanted) -> Result<Found, String> {
    let unreadable = |error: io::Error| {
        let reason = lightfall_core::reason::reason(&error);
        format!("cannot be read: {reason}")
    };
    let mut file = match File::open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Found::Nothing),
        opened => opened.map_err(unreadable)?,
    };
    let head = head_of(&mut file).map_err(unreadable)?;
    let (signature, kind) = match wanted.form {
        WantedForm::Png(_) => (PNG_SIGNATURE, "PNG"),
        WantedForm::Exr(..) => (EXR_SIGNATURE, "EXR"),
    };
    if head.len() < signature.len() && signature.starts_with(&head) {
        return Ok(Found::Partial);
    }
    if !head.starts_with(signature) {
        return Err(format!("is not a picture in the format {kind}"));
    }
    let checked = match wanted.form {
        WantedForm::Png(bits) => check_png(&head, bits, wanted.size),
        WantedForm::Exr(channels, form) => check_exr(&head, (channels, form), wanted.size),
    };
    let is_whole = match wanted.form {
        WantedForm::Png(_) => png_is_whole(&mut file),
        WantedForm::Exr(..) => exr_is_whole(&mut file, &head),
    };
    match (checked, is_whole.map_err(unreadable)?) {
        (Some(checked), true) => checked?,
        // The header cannot be read, or the rest is missing.
        _ => return Ok(Found::Partial),
    }
    let preset = embedded_preset(&head);
    let preset = preset.ok_or("holds no preset of Lightfall: it is another picture")?;
    for (name, words) in DECISIVE {
        let own = wanted.record.texts.iter().find(|(key, _)| *key == name);
        let (own, other) = (
            own.map(|(_, text)| text.clone()),
            embedded_text(&head, name),
        );
        if own != other {
            let text = |text: Option<String>| text.unwrap_or_else(|| "none".into());
            return Err(format!(
                "was drawn otherwise: {words} was {}, and is {} now",
                text(other),
                text(own)
            ));
        }
    }
    match preset_difference(&preset, &wanted.record.preset, wanted.is_metered) {
        Some(difference) => Err(format!("was drawn with other options: {difference}")),
        None => Ok(Found::Whole),
    }
}

/// The beginning of a file, which tells what it is and has the texts of a picture.
pub(super) fn head_of(file: &mut File) -> io::Result<Vec<u8>> {
    let mut head = Vec::new();
    file.take(HEAD_BYTES).read_to_end(&mut head)?;
    Ok(head)
}

/// The first field in which two presets differ, in words; fields that are metered may differ. `None` if they
/// are the same.
#[must_use]
pub fn preset_difference(there: &str, here: &str, is_metered: bool) -> Option<String> {
    let (there, here) = (fields(there), fields(here));
    let keys: BTreeSet<_> = there.keys().chain(here.keys()).collect();
    let key = keys
        .into_iter()
        .find(|key| there.get(*key) != here.get(*key) && !(is_metered && *key == METERED))?;
    let value = |fields: &BTreeMap<String, String>| match fields.get(key) {
        Some(value) => value.clone(),
        None => "not there".into(),
    };
    Some(format!(
        "{key} was {}, and is {} now",
        value(&there),
        value(&here)
    ))
}

/// The values in a preset by their fields' keys. A preset that the program writes has a line for each.
pub(super) fn fields(preset: &str) -> BTreeMap<String, String> {
    let (mut fields, mut table) = (BTreeMap::new(), "");
    for line in preset.lines().map(str::trim) {
        if let Some(head) = line
            .strip_prefix('[')
            .and_then(|rest| rest.strip_suffix(']'))
        {
            table = head;
        } else if let Some((name, value)) = line.split_once(" = ")
            && !line.starts_with('#')
        {
            let dot = if table.is_empty() { "" } else { "." };
            fields.insert(format!("{table}{dot}{name}"), value.to_owned());
        }
    }
    fields
}

/// Checks the size and the form of a PNG. `None` if its beginning cannot be read.
fn check_png(head: &[u8], bits: PngBits, wanted: UVec2) -> Option<Result<(), String>> {
    let reader = png::Decoder::new(Cursor::new(head)).read_info().ok()?;
    let info = reader.info();
    let (depth, own) = (info.bit_depth as u8, bits.word());
    let checked = check_size(UVec2::new(info.width, info.height), wanted).and_then(|()| {
        if depth.to_string() != own {
            return Err(format!(
                "has {depth} bits per channel, and {own} are asked for now"
            ));
        }
        Ok(())
    });
    Some(checked)
}

/// The same for an EXR.
fn check_exr(
    head: &[u8],
    (channels, form): (&Channels, ExrForm),
    wanted: UVec2,
) -> Option<Result<(), String>> {
    let header = exr_header_of(head)?;
    let size = UVec2::new(header.layer_size.0 as u32, header.layer_size.1 as u32);
    let there: BTreeSet<String> = header
        .channels
        .list
        .iter()
        .map(|channel| channel.name.to_string())
        .collect();
    let own = channels.list().iter();
    let light = ["R", "G", "B", "A"].map(str::to_owned);
    let here: BTreeSet<String> = own
        .map(|channel| form.names.of(channel).to_owned())
        .chain(light)
        .collect();
    let checked = check_size(size, wanted).and_then(|()| {
        if there != here {
            let (more, less) = (there.difference(&here), here.difference(&there));
            let names: Vec<&str> = more.chain(less).map(String::as_str).collect();
            return Err(format!(
                "has other channels than are asked for now: the difference is {}",
                names.join(", ")
            ));
        }
        if header.compression != form.compression.method() {
            return Err("has another compression than is asked for now".into());
        }
        Ok(())
    });
    Some(checked)
}

fn check_size(there: UVec2, here: UVec2) -> Result<(), String> {
    if there != here {
        return Err(format!(
            "has {} x {} pixels, and {} x {} are asked for now",
            there.x, there.y, here.x, here.y
        ));
    }
    Ok(())
}

/// Whether the chunks of a PNG follow one another to its last one.
fn png_is_whole(file: &mut File) -> io::Result<bool> {
    let length = file.metadata()?.len();
    let mut at = PNG_SIGNATURE.len() as u64;
    loop {
        // Length and name, and a checksum behind the contents.
        if at + 12 > length {
            return Ok(false);
        }
        let mut start = [0; 8];
        file.seek(SeekFrom::Start(at))?;
        file.read_exact(&mut start)?;
        let [a, b, c, d, name @ ..] = start;
        at += 12 + u64::from(u32::from_be_bytes([a, b, c, d]));
        if name == *b"IEND" {
            return Ok(at <= length);
        }
    }
}

/// Whether every block of an EXR has its place in the file, and the last one ends there.
fn exr_is_whole(file: &mut File, head: &[u8]) -> io::Result<bool> {
    let Some((header, start)) = exr_header_of(head).zip(exr_header::length(head)) else {
        return Ok(false);
    };
    let length = file.metadata()?.len();
    let table_bytes = (header.chunk_count as u64).saturating_mul(8);
    let blocks = (start as u64).saturating_add(table_bytes);
    if blocks > length || header.chunk_count == 0 {
        return Ok(false);
    }
    let mut table = vec![0; table_bytes as usize];
    file.seek(SeekFrom::Start(start as u64))?;
    file.read_exact(&mut table)?;
    let offsets = table
        .chunks_exact(8)
        .filter_map(|bytes| bytes.first_chunk())
        .map(|bytes| u64::from_le_bytes(*bytes));
    let (mut first, mut last) = (u64::MAX, 0);
    for offset in offsets {
        first = first.min(offset);
        last = last.max(offset);
    }
    // A block begins with its first row and the number of its bytes.
    if first < blocks || last.saturating_add(8) > length {
        return Ok(false);
    }
    let mut block = [0; 8];
    file.seek(SeekFrom::Start(last))?;
    file.read_exact(&mut block)?;
    let [.., a, b, c, d] = block;
    let bytes = u64::from(u32::from_le_bytes([a, b, c, d]));
    Ok(last + 8 + bytes <= length)
}

/// The header of an EXR with one part.
fn exr_header_of(head: &[u8]) -> Option<Header> {
    let headers = MetaData::read_from_buffered(head, false).ok()?.headers;
    let mut headers = headers.into_iter();
    headers.next().filter(|_| headers.next().is_none())
}
