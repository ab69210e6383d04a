//! File names made from the names of scenes.

/// Maximum number of characters of a name, so that the whole file name stays far below the 255
/// bytes that file systems allow.
const MAX_CHARACTERS: usize = 60;

/// A name that every file system accepts: letters, digits and `-` stay, every other character
/// becomes `_`.
#[must_use]
pub fn file_safe_name(name: &str) -> String {
    name.chars()
        .map(|c| {
            if c.is_alphanumeric() || c == '-' {
                c
            } else {
                '_'
            }
        })
        .take(MAX_CHARACTERS)
        .collect()
}
