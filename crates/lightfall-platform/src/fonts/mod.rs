//! Fonts of the system, for characters that the program's own fonts lack. They are looked for only
//! where a text has such characters. A page in a browser cannot read them.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod installed;
mod script;

#[cfg(target_arch = "wasm32")]
pub use browser::SystemFonts;
#[cfg(not(target_arch = "wasm32"))]
pub use installed::SystemFonts;

use crate::IN_BROWSER;
use script::Script;

/// A font of the system.
#[derive(Clone)]
pub struct SystemFont {
    /// The name of its family.
    pub name: String,
    /// Its file, which stays in memory as long as the program runs.
    pub data: &'static [u8],
    /// Its number within the file, from 0.
    pub index: u32,
    /// The axes that make a variable font upright and of ordinary weight, by their tags.
    pub axes: Vec<([u8; 4], f32)>,
}

/// What was found for some characters.
#[derive(Default)]
pub struct FoundFonts {
    /// Fonts that were not found before.
    pub fonts: Vec<SystemFont>,
    /// The characters that no font has.
    pub missing: Vec<char>,
}

/// The name of the script of a character: empty for a rare one.
#[must_use]
pub fn script_name(character: char) -> &'static str {
    Script::of(character).map_or("", |script| script.name)
}

/// Says that no font has these characters, and what to install. It lists at most `max` of them, and
/// `written` writes one. None if there are none.
#[must_use]
pub fn missing_sentence(
    missing: &[char],
    max: usize,
    written: fn(char) -> String,
) -> Option<String> {
    let [_, others @ ..] = missing else {
        return None;
    };
    let shown = missing.iter().take(max);
    let mut listed = shown.map(|c| written(*c)).collect::<Vec<_>>().join(" ");
    if missing.len() > max {
        listed += &format!(" and {} more", missing.len() - max);
    }
    let characters = if others.is_empty() {
        "character"
    } else {
        "characters"
    };
    if IN_BROWSER {
        return Some(format!(
            "a page cannot use the fonts of the system, and its own lack the {characters} {listed}"
        ));
    }
    let mut names = Vec::new();
    let mut examples = Vec::new();
    for script in missing.iter().filter_map(|c| Script::of(*c)) {
        for (list, word) in [(&mut names, script.name), (&mut examples, script.example())] {
            if !list.contains(&word) {
                list.push(word);
            }
        }
    }
    let install = if names.is_empty() {
        "install one that does".to_owned()
    } else {
        format!(
            "install one for {} text, for example {}",
            names.join(", "),
            examples.join(" and ")
        )
    };
    Some(format!(
        "no font of this system has the {characters} {listed}; {install}"
    ))
}

/// Whether a character belongs to a script that is written from right to left.
#[must_use]
pub fn is_right_to_left(character: char) -> bool {
    matches!(
        u32::from(character),
        0x590..=0x8ff | 0xfb1d..=0xfdff | 0xfe70..=0xfefe | 0x1_0800..=0x1_0fff | 0x1_e800..=0x1_efff
    )
}
