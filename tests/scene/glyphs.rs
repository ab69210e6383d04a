//! Characters of a preset's texts that egui's own fonts lack.

use crate::font_folder::{font_folder, has_fontconfig};
use crate::program::program_with;
use std::fs;

/// What `presets check` says of a preset with this title, on a system with a font that has
/// `characters`.
fn remarks(title: &str, characters: &str) -> String {
    let (folder, configuration) = font_folder(characters);
    fs::write(
        folder.path().join("mine.toml"),
        format!("title = \"{title}\""),
    )
    .unwrap();
    let variables = [("FONTCONFIG_FILE", configuration.as_path())];
    let line = "presets check mine.toml";
    let (status, stdout, stderr) = program_with(&variables, folder.path(), line, "");
    assert_eq!(
        (status, stdout.as_str()),
        (0, "mine.toml: ok\n"),
        "{stderr}"
    );
    stderr
}

#[test]
fn characters_that_no_font_has_are_named_with_what_to_install() {
    for (title, sentence) in [
        (
            "光速, 光",
            "no font of this system has the characters 光 速; install one for Han text, for example fonts-noto-cjk",
        ),
        (
            "한 हि",
            "no font of this system has the characters 한 ह ि; install one for Hangul, Devanagari text, for example \
             fonts-noto-cjk and fonts-noto-core",
        ),
        (
            "נ",
            "no font of this system has the character נ; install one for Hebrew text, for example fonts-noto-core",
        ),
        (
            "一二三四五六七八九十",
            "no font of this system has the characters 一 二 三 四 五 六 七 八 and 2 more; install one for Han text, \
             for example fonts-noto-cjk",
        ),
    ] {
        let said = remarks(title, "");
        assert_eq!(said, format!("lightfall: mine.toml: {sentence}\n"));
    }
    assert_eq!(remarks("Größe, Ελλάς, Земля", ""), "");
}

#[test]
fn characters_of_a_font_of_the_system_are_not_named() {
    if !has_fontconfig() {
        return println!("not tried: fontconfig is not installed");
    }
    assert_eq!(remarks("光速", "光速"), "");
    let said = remarks("光速", "光");
    assert!(said.contains("has the character 速;"), "{said}");
}

#[test]
fn the_order_of_words_from_right_to_left_is_named_as_wrong() {
    let disordered = |title: &str| remarks(title, "").contains("from left to right");
    assert!(disordered("سلام دنيا"));
    assert!(!disordered("Hello سلام"));
}
