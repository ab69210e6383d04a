//! The settings file is read back as it was written, and a broken file is never fatal.

use lightfall::app::{Automatic, Settings};
use lightfall_core::gpu::AdapterName;

#[test]
fn settings_are_read_back_as_they_were_written() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("deep/er/settings.toml");
    let mut settings = Settings {
        ui_scale: 1.25,
        automatic_resolution: Automatic::Off,
        ..Settings::default()
    };
    settings
        .keys
        .insert("window.help".into(), vec!["Home".into()]);
    settings
        .buttons
        .insert("window.help".into(), vec!["Guide".into()]);
    settings.adapter = Some(AdapterName {
        name: "A card \"2\"".into(),
        backend: "vulkan".into(),
    });
    settings.save(&file).unwrap();
    assert_eq!(Settings::load(&file), (settings, None));
}

#[test]
fn without_a_file_the_settings_are_the_defaults_and_nothing_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(
        Settings::load(&folder.path().join("none.toml")),
        (Settings::default(), None)
    );
}

#[test]
fn a_broken_file_is_renamed_and_reported() {
    for (text, expected) in [
        ("ui_scale = ", "line 1"),
        ("\nui_skale = 1.0", "ui_skale"),
        (
            "ui_scale = 40.0",
            "ui_scale = 40 is refused: it must be a number from 0.6 to 2.5",
        ),
        ("frame_rate = nan", "frame_rate = NaN is refused"),
        (
            "most_frames = -1.0",
            "or 0 for as many as the monitor shows",
        ),
        (
            "[keys]\n\"window.help\" = [\"W\"]\n\"window.panel\" = [\"W\"]",
            "W is given to both window.help and window.panel",
        ),
        (
            "[buttons]\n\"window.help\" = [\"A\"]\n\"window.panel\" = [\"A\"]",
            "A is given to both window.help and window.panel",
        ),
        ("[adapter]\nname = \"A card\"", "backend"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("settings.toml");
        std::fs::write(&file, text).unwrap();
        let (settings, fault) = Settings::load(&file);
        let fault = fault.unwrap();
        assert_eq!(settings, Settings::default());
        assert!(fault.contains(expected), "{fault}");
        assert!(!file.exists(), "the broken file is still there");
        let aside = folder.path().join("settings.broken-1.toml");
        assert!(fault.contains(&aside.display().to_string()), "{fault}");
        assert_eq!(
            std::fs::read_to_string(aside).unwrap(),
            text,
            "what was written is lost"
        );
    }
}

#[test]
fn a_file_that_is_not_text_is_reported_too() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings.toml");
    std::fs::write(&file, [0xff, 0xfe, 0x00]).unwrap();
    assert!(Settings::load(&file).1.unwrap().contains("cannot be read"));
}
