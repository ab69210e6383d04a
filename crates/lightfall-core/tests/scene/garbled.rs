//! Broken presets: whatever the text is, it loads or is refused in one sentence.

use crate::random::Random;
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{Scene, load};

/// Loads any text; an error must be one sentence that begins with the file's name.
fn survive(text: &str) {
    if let Err(error) = load("my.toml", text, &[]) {
        let error = error.to_string();
        assert!(
            error.starts_with("my.toml: ") && !error.contains('\n') && error.len() < 1000,
            "{error:?} of {text:?}"
        );
    }
}

#[test]
fn a_truncated_preset_is_a_scene_or_is_refused_in_one_sentence() {
    for preset in PRESETS {
        for (end, _) in preset.text.char_indices() {
            survive(&preset.text[..end]);
        }
    }
}

#[test]
fn a_randomly_garbled_preset_is_a_scene_or_is_refused_in_one_sentence() {
    let mut random = Random::new();
    let mut below = |count: usize| random.integer(0, count as u32 - 1) as usize;
    let whole = Scene::default().to_preset();
    // Characters that TOML uses, numbers at their limits, and characters that nothing uses.
    let pieces = [
        "\"",
        "'''",
        "[",
        "]]",
        "{",
        "}",
        "=",
        ".",
        ",",
        "#",
        "\n",
        "\0",
        "\u{7f}",
        "é",
        "-",
        "1e999",
        "nan",
        "9223372036854775807",
        "99999999999999999999",
        "true",
        "1979-05-27",
        "0x",
        "_",
        "\\u12",
        "camera",
        "r",
    ];
    for round in 0..6000 {
        let mut text: Vec<char> = if round % 2 == 0 {
            whole.chars()
        } else {
            PRESETS[round % 7].text.chars()
        }
        .collect();
        for _ in 0..=below(4) {
            let at = below(text.len());
            let length = below(5).min(text.len() - at);
            text.splice(at..at + length, pieces[below(pieces.len())].chars());
        }
        survive(&text.into_iter().collect::<String>());
    }
}

#[test]
fn deep_nesting_and_long_lines_are_refused_in_one_short_sentence() {
    survive(&("camera.r = ".to_owned() + &"[".repeat(100_000)));
    survive(&("camera.r = ".to_owned() + &"{a=".repeat(100_000)));
    survive(&("a.".repeat(100_000) + "b = 1"));
    survive(&format!("{} = 1", "k".repeat(1_000_000)));
    survive(&format!("name = \"{}\"", "n".repeat(1_000_000)));
    survive(&format!("observer.velocity = [{}]", "0, ".repeat(100_000)));
}
