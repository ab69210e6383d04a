//! Fonts in place of those of the system, by fontconfig's variable for its configuration.

use bevy_egui::egui::FontDefinitions;
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// The number of the full stop in the font Hack.
const FULL_STOP: u32 = 592;

/// A folder with fontconfig's configuration, of a system with one font that shows each of these
/// characters as a full stop, or of a system without fonts where there are none.
pub fn font_folder(characters: &str) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().display();
    if !characters.is_empty() {
        fs::write(folder.path().join("font.ttf"), font(characters)).unwrap();
    }
    let text =
        format!("<fontconfig><dir>{path}</dir><cachedir>{path}/cache</cachedir></fontconfig>");
    let file = folder.path().join("fonts.conf");
    fs::write(&file, text).unwrap();
    (folder, file)
}

/// Whether fontconfig's library is installed, without which there are no fonts.
pub fn has_fontconfig() -> bool {
    let list = std::process::Command::new("/sbin/ldconfig")
        .arg("-p")
        .output();
    list.is_ok_and(|list| String::from_utf8_lossy(&list.stdout).contains("libfontconfig.so.1"))
}

/// egui's font Hack with another table of characters (OpenType, `cmap` with a subtable of format 12).
fn font(characters: &str) -> Vec<u8> {
    let mut font = FontDefinitions::default().font_data["Hack"].font.to_vec();
    let mut characters: Vec<u32> = characters.chars().map(u32::from).collect();
    characters.sort_unstable();
    let count = characters.len() as u32;
    let length = 16 + 12 * count;
    // The table's version and number of subtables; the subtable's platform, encoding and place; its
    // format.
    let head = [1, 3 << 16 | 10, 12, 12 << 16, length, 0, count];
    let groups = characters.iter().flat_map(|c| [*c, *c, FULL_STOP]);
    let table: Vec<u8> = head
        .into_iter()
        .chain(groups)
        .flat_map(u32::to_be_bytes)
        .collect();
    // An entry of the font's list of tables: tag, checksum, place and length.
    let entry = font.chunks_exact(4).position(|tag| tag == b"cmap").unwrap() * 4;
    let place = font.len() as u32;
    font[entry + 8..entry + 12].copy_from_slice(&place.to_be_bytes());
    font[entry + 12..entry + 16].copy_from_slice(&(table.len() as u32).to_be_bytes());
    font.extend(table);
    font
}
