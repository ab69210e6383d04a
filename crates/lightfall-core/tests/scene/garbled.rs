//! Broken presets: whatever the text is, it loads or is refused in one sentence.

use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{Scene, load};

/// A small linear congruential generator (Knuth's MMIX constants), so that a failure repeats at the
/// next run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, sides: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % sides
    }
}

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
fn a_garbled_preset_is_a_scene_or_is_refused_in_one_sentence() {
    let mut dice = Dice(1);
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
        for _ in 0..=dice.below(4) {
            let at = dice.below(text.len());
            let length = dice.below(5).min(text.len() - at);
            text.splice(at..at + length, pieces[dice.below(pieces.len())].chars());
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
