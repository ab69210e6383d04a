//! File names made from the names of scenes.

use lightfall_platform::storage::file_safe_name;

#[test]
fn a_file_name_keeps_letters_digits_and_hyphens() {
    assert_eq!(
        file_safe_name("edge-on 2/μέλας.toml"),
        "edge-on_2_μέλας_toml"
    );
}

/// Letters of one to four bytes. File systems allow 255 bytes, of which a screenshot's name needs
/// 19 around the scene's name: `lightfall-` and `-0001.png`.
#[test]
fn a_long_name_of_any_letters_is_cut_to_what_file_systems_allow() {
    for letter in ['a', 'μ', '黒', '𐌰'] {
        let safe = file_safe_name(&letter.to_string().repeat(300));
        assert!(safe.chars().all(|kept| kept == letter), "{safe}");
        assert!((100..=255 - 19).contains(&safe.len()), "{safe}");
    }
}
