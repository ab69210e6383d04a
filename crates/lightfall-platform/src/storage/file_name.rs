//! File names made from the names of scenes.

/// Maximum length of a name in bytes, so that the whole file name stays far below the 255 bytes
/// that file systems allow.
const MAX_BYTES: usize = 120;

/// A name that every file system accepts: letters, digits and `-` stay, every other character
/// becomes `_`. A name that is too long is cut after a whole character.
#[must_use]
pub fn file_safe_name(name: &str) -> String {
    let mut safe = String::new();
    for character in name.chars() {
        let character = if character.is_alphanumeric() || character == '-' {
            character
        } else {
            '_'
        };
        if safe.len() + character.len_utf8() > MAX_BYTES {
            break;
        }
        safe.push(character);
    }
    safe
}
