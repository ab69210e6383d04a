//! The system's reasons why a file cannot be read or written, in words.

use std::io::{self, ErrorKind};

/// Why the system refused, as a clause. The standard library's text has another style and ends with
/// a number, as in `No such file or directory (os error 2)`.
#[must_use]
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    if error.raw_os_error().is_none() {
        return text;
    }
    match error.kind() {
        ErrorKind::NotFound => "there is no such file".into(),
        ErrorKind::IsADirectory => "it is a folder".into(),
        ErrorKind::PermissionDenied => "permission denied".into(),
        _ => {
            let words = text.split(" (os error").next().unwrap_or_default();
            let mut letters = words.chars();
            let first = letters.next().map(|letter| letter.to_ascii_lowercase());
            first.into_iter().chain(letters).collect()
        }
    }
}
