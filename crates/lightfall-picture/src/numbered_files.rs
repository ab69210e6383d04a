//! Numbered pictures that exist.

use super::sequence::Sequence;
use super::{Format, Frames};
use std::fs::read_dir;
use std::path::{Path, PathBuf};

/// Most digits of a frame's number.
const MAX_DIGITS: usize = 9;

/// The pictures whose names follow a pattern, in the order of their numbers, which have no gap.
///
/// # Errors
/// The name is no picture's, there are no such pictures, or one is missing between two others. The message is
/// a sentence.
pub fn numbered_pictures(pattern: &Path) -> Result<Vec<PathBuf>, String> {
    let name = pattern.display();
    if Format::of(pattern).map_or(true, Format::holds_sequence) {
        return Err(format!(
            "{name}: the pictures of a film are numbered .png or .exr files, such as flight-####.png"
        ));
    }
    let any = Frames { first: 0, last: 0 };
    let sequence = Sequence::new(None, any, 1.0, pattern)?;
    let first = sequence.file(0);
    let folder = first
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    let entries = read_dir(folder)
        .map_err(|error| format!("{name}: {}", lightfall_core::reason::reason(&error)))?;
    let files = entries.flatten().map(|entry| entry.file_name());
    let mut numbers: Vec<u32> = files
        .filter_map(|file| number_in(&sequence, file.to_str()?))
        .collect();
    numbers.sort_unstable();
    if numbers.is_empty() {
        return Err(format!(
            "{name}: there is no such picture; the first one could be {}",
            first.display()
        ));
    }
    if let Some(pair) = numbers.windows(2).find(|pair| pair[1] > pair[0] + 1) {
        return Err(format!(
            "{} is missing: the pictures of a film have no gaps",
            sequence.file(pair[0] + 1).display()
        ));
    }
    Ok(numbers.into_iter().map(|n| sequence.file(n)).collect())
}

/// The number of the picture of a sequence that has this name.
fn number_in(sequence: &Sequence, file: &str) -> Option<u32> {
    let bytes = file.as_bytes();
    let begins = (0..bytes.len()).filter(|begin| bytes[*begin].is_ascii_digit());
    let mut numbers = begins.filter_map(|begin| {
        let digits = bytes[begin..]
            .iter()
            .take_while(|byte| byte.is_ascii_digit());
        let count = digits.count();
        // With more digits than a number has, another one begins later.
        (count <= MAX_DIGITS).then(|| file[begin..begin + count].parse().ok())?
    });
    numbers.find(|number| {
        sequence
            .file(*number)
            .file_name()
            .is_some_and(|name| name == file)
    })
}
