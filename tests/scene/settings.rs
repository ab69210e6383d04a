//! The settings file is read back as it was written, and a broken file is never fatal.

use lightfall::app::{Automatic, SETTINGS_VERSION, Settings};
use lightfall_core::gpu::AdapterName;

#[test]
fn settings_are_read_back_as_they_were_written() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("deep/er/settings.toml");
    let mut settings = Settings {
        ui_scale: 1.25,
        volume: 0.0,
        pupil: "Ada \"Countess\" Lovelace".into(),
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
        (
            "ui_scale = ",
            "line 1: `ui_scale =` has no value behind the equals sign",
        ),
        (
            "ui_scale = 1,5",
            "line 1: `1,5` has a comma where a number has a point: did you mean 1.5?",
        ),
        ("version = 0", "version = 0 is refused: it must be 1"),
        (
            "version = \"new\"",
            "line 1: version = \"new\" is refused: it must be a whole number",
        ),
        (
            "\nui_skale = 1.0",
            "line 2: unknown field `ui_skale`; did you mean `ui_scale`?",
        ),
        (
            "pupil = \"Ada\\nLovelace\"",
            "it must be one line of at most 60 characters",
        ),
        (
            "ui_scale = 40.0",
            "ui_scale = 40 is refused: it must be a number from 0.6 to 2.5",
        ),
        (
            "volume = 1.5",
            "volume = 1.5 is refused: it must be a number from 0 to 1",
        ),
        (
            "volume = \"loud\"",
            "line 1: volume = \"loud\" is refused: it must be a number",
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
        (
            "[adapter]\nname = \"A card\"",
            "line 1: adapter has no field `backend`",
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("settings.toml");
        std::fs::write(&file, text).unwrap();
        let (settings, unused) = Settings::load(&file);
        let fault = unused.unwrap().sentence;
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
    let fault = Settings::load(&file).1.unwrap().sentence;
    assert!(fault.contains("cannot be read"), "{fault}");
}

#[test]
fn the_file_says_its_version_and_one_without_a_version_has_the_first() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings.toml");
    Settings::default().save(&file).unwrap();
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains("\nversion = 1\n"), "{text}");
    assert_eq!(SETTINGS_VERSION, 1);
    let settings = Settings::read("frame_rate = 60.0").unwrap();
    assert_eq!((settings.version, settings.frame_rate), (1, 60.0));
}

#[test]
fn a_file_of_a_newer_version_is_not_used_and_stays_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("settings.toml");
    // Fields that nobody knows yet, one of another type, and one with a value that is too large.
    let text = "version = 999\nwarp_drive = true\nui_scale = 40.0\n[frame_rate]\nhighest = 1000\n";
    std::fs::write(&file, text).unwrap();
    let (settings, unused) = Settings::load(&file);
    let unused = unused.unwrap();
    assert_eq!(settings, Settings::default());
    assert!(unused.stays);
    assert_eq!(
        unused.sentence,
        format!(
            "{}: version = 999 is that of a newer Lightfall, and this one reads versions up to 1; the file stays as it is, \
             default settings are used, and changes of settings are not saved; update Lightfall, or rename the file",
            file.display()
        )
    );
    let left: Vec<_> = std::fs::read_dir(folder.path()).unwrap().collect();
    assert_eq!(left.len(), 1, "{left:?}");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
}

#[test]
fn settings_that_cannot_be_written_are_a_sentence_that_names_the_file() {
    // A file where the folder should be stops everybody, root too.
    let folder = tempfile::tempdir().unwrap();
    let blocking = folder.path().join("lightfall");
    std::fs::write(&blocking, "").unwrap();
    let file = blocking.join("settings.toml");
    let fault = Settings::default().save(&file).unwrap_err();
    let start = format!("{}: the settings cannot be written: ", file.display());
    assert!(fault.starts_with(&start), "{fault}");
    assert_eq!(std::fs::read_to_string(&blocking).unwrap(), "");
}
