//! Text that other programs wrote, decoded.

use thiserror::Error;

/// Why bytes are not a text that can be read. Each message continues a sentence that begins with
/// the name of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NotText {
    /// Every other byte is zero, and there is no byte order mark.
    #[error(
        "is UTF-16 text without a byte order mark; save it as UTF-8, in PowerShell with `Get-Content -Encoding {encoding} OLD | Set-Content -Encoding utf8 NEW`"
    )]
    Utf16WithoutMark {
        /// PowerShell's name of the encoding.
        encoding: &'static str,
    },
    /// UTF-16 with half a character.
    #[error(
        "is UTF-16 text with a broken character; save it as UTF-8, in PowerShell with `Get-Content OLD | Set-Content -Encoding utf8 NEW`"
    )]
    BrokenUtf16,
    /// UTF-32, by its byte order mark.
    #[error(
        "is UTF-32 text; save it as UTF-8, in PowerShell with `Get-Content OLD | Set-Content -Encoding utf8 NEW`"
    )]
    Utf32,
    /// A byte above 127 that is not UTF-8, as the encodings of one byte per character have them.
    #[error(
        "is not UTF-8 text: line {line} has the byte 0x{byte:02X}, as in Windows-1252 or Latin-1; save it as UTF-8, in PowerShell with `Get-Content OLD | Set-Content -Encoding utf8 NEW`"
    )]
    OneByteEncoding {
        /// Line of the byte, from 1.
        line: usize,
        /// The first byte that is not UTF-8.
        byte: u8,
    },
    /// Zeros, as programs and compressed files have them.
    #[error("is not text: line {line} has a zero byte")]
    Binary {
        /// Line of the first zero, from 1.
        line: usize,
    },
}

/// Decodes a text: UTF-8 with or without a byte order mark, or UTF-16 with one, as Windows
/// PowerShell writes it. Lines that all end in a carriage return alone, as old programs of the Mac
/// wrote them, end in a line feed afterwards.
///
/// # Errors
/// The bytes are in another encoding, or are not text.
pub fn decode(bytes: Vec<u8>) -> Result<String, NotText> {
    let text = match bytes.as_slice() {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => return Err(NotText::Utf32),
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes)?,
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes)?,
        _ => utf8(bytes)?,
    };
    match text.find('\0') {
        Some(at) => Err(
            utf16_without_mark(text.as_bytes()).unwrap_or(NotText::Binary {
                line: line_of(text.as_bytes(), at),
            }),
        ),
        None => Ok(with_line_feeds(text)),
    }
}

fn with_line_feeds(text: String) -> String {
    if text.contains('\r') && !text.contains('\n') {
        text.replace('\r', "\n")
    } else {
        text
    }
}

fn utf8(mut bytes: Vec<u8>) -> Result<String, NotText> {
    const MARK: &[u8] = b"\xef\xbb\xbf";
    if bytes.starts_with(MARK) {
        bytes.drain(..MARK.len());
    }
    String::from_utf8(bytes).map_err(|error| {
        let (at, bytes) = (error.utf8_error().valid_up_to(), error.as_bytes());
        if let Some(utf16) = utf16_without_mark(bytes) {
            utf16
        } else if let Some(zero) = bytes.iter().position(|byte| *byte == 0) {
            let line = line_of(bytes, zero);
            NotText::Binary { line }
        } else {
            let line = line_of(bytes, at);
            NotText::OneByteEncoding {
                line,
                byte: bytes[at],
            }
        }
    })
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, NotText> {
    let (pairs, rest) = bytes.as_chunks();
    let units: Vec<u16> = pairs.iter().map(|pair| unit(*pair)).collect();
    let text = String::from_utf16(&units).map_err(|_| NotText::BrokenUtf16)?;
    rest.is_empty().then_some(text).ok_or(NotText::BrokenUtf16)
}

/// UTF-16, if most bytes at even places, or at odd places, are zero: ASCII characters have their high
/// byte there.
fn utf16_without_mark(bytes: &[u8]) -> Option<NotText> {
    let (pairs, _) = bytes.as_chunks::<2>();
    let has_high_bytes = |place: usize| {
        let zeros = pairs.iter().filter(|pair| pair[place] == 0).count();
        let others = pairs.iter().filter(|pair| pair[1 - place] == 0).count();
        2 * zeros > pairs.len() && others == 0
    };
    let encodings = [(0, "BigEndianUnicode"), (1, "Unicode")];
    let found = encodings.iter().find(|(place, _)| has_high_bytes(*place));
    found.map(|&(_, encoding)| NotText::Utf16WithoutMark { encoding })
}

fn line_of(bytes: &[u8], at: usize) -> usize {
    1 + bytes[..at].iter().filter(|byte| **byte == b'\n').count()
}
