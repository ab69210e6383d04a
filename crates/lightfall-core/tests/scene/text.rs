//! Text of other programs: what is decoded, and what is refused and how.

use lightfall_core::text::{NotText, decode};

const TEXT: &str = "camera.r = 8 # Schräg, 光\r\nname = \"𝄞\"\n";

fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    text.encode_utf16().flat_map(bytes).collect()
}

#[test]
fn utf_8_and_utf_16_with_a_byte_order_mark_give_the_same_text() {
    for bytes in [
        TEXT.as_bytes().to_vec(),
        [b"\xef\xbb\xbf", TEXT.as_bytes()].concat(),
        [vec![0xff, 0xfe], utf16(TEXT, u16::to_le_bytes)].concat(),
        [vec![0xfe, 0xff], utf16(TEXT, u16::to_be_bytes)].concat(),
    ] {
        assert_eq!(decode(bytes), Ok(TEXT.into()));
    }
    for empty in ["", "\u{feff}"] {
        assert_eq!(decode(empty.into()), Ok(String::new()));
    }
    assert_eq!(decode(vec![0xff, 0xfe]), Ok(String::new()));
}

#[test]
fn carriage_returns_alone_become_line_feeds() {
    assert_eq!(
        decode(b"a = 1\rb = 2\r".to_vec()),
        Ok("a = 1\nb = 2\n".into())
    );
    let both = "a = 1\r\nb = \"\r\"\n";
    assert_eq!(decode(both.into()), Ok(both.into()));
}

#[test]
fn another_encoding_is_named() {
    let orders: [(fn(u16) -> [u8; 2], _); 2] = [
        (u16::to_le_bytes, "Unicode"),
        (u16::to_be_bytes, "BigEndianUnicode"),
    ];
    for (bytes, encoding) in orders {
        assert_eq!(
            decode(utf16("a = 1\n", bytes)),
            Err(NotText::Utf16WithoutMark { encoding })
        );
        assert_eq!(
            decode(utf16(TEXT, bytes)),
            Err(NotText::Utf16WithoutMark { encoding })
        );
    }
    let utf32: Vec<u8> = "\u{feff}a"
        .chars()
        .flat_map(|c| u32::from(c).to_le_bytes())
        .collect();
    assert_eq!(decode(utf32), Err(NotText::Utf32));
    assert_eq!(
        decode(b"a = 1\n# Schr\xe4g\n".to_vec()),
        Err(NotText::OneByteEncoding {
            line: 2,
            byte: 0xe4
        })
    );
    assert_eq!(decode(vec![0xff, 0xfe, b'a']), Err(NotText::BrokenUtf16));
    assert_eq!(
        decode(vec![0xff, 0xfe, 0x00, 0xd8]),
        Err(NotText::BrokenUtf16)
    );
    assert_eq!(
        decode(b"a\nb\0c".to_vec()),
        Err(NotText::Binary { line: 2 })
    );
    assert_eq!(
        decode(b"\x7fELF\x02\x01\x01\0\0\0\xf0".to_vec()),
        Err(NotText::Binary { line: 1 })
    );
}

#[test]
fn a_refusal_says_how_to_save_the_text_again() {
    let fault = decode(b"\xe4".to_vec()).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "is not UTF-8 text: line 1 has the byte 0xE4, as in Windows-1252 or Latin-1; save it as UTF-8, in PowerShell with `Get-Content OLD | Set-Content -Encoding utf8 NEW`"
    );
}
