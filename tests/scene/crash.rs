//! What is left of a run that ends by a fault of the program itself.

use lightfall_core::scene::Scene;
use lightfall_platform::storage::{note_adapter, note_log, note_scene, report_panics};
use std::path::Path;
use std::process::Command;

/// Tells the test below that it is the program that panics.
const PANICS: &str = "LIGHTFALL_TEST_PANICS";

/// Panics with a report.
fn panic_with_report() -> ! {
    report_panics(|sentence| eprintln!("told: {sentence}"));
    note_adapter("A card (vulkan), driver 1.2".into());
    let mut scene = Scene::default();
    scene.camera.r = 12.25;
    note_scene(&scene);
    for line in 0..200 {
        note_log(format!("line {line} of the log"));
    }
    panic!("a fault on purpose\nwhose second line is in the report only");
}

/// Runs the test below as another process that panics, with these folders for its data and for temporary files. Returns what it has
/// said.
fn crash(data: &Path, temporary: &Path) -> String {
    let output = Command::new(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "crash::a_crash_leaves_a_report_and_says_where_it_is",
            "--nocapture",
        ])
        .env(PANICS, "1")
        .env("XDG_DATA_HOME", data)
        .env("TMPDIR", temporary)
        .output()
        .unwrap();
    assert!(!output.status.success());
    String::from_utf8(output.stderr).unwrap()
}

#[test]
#[cfg(target_os = "linux")]
fn a_crash_leaves_a_report_and_says_where_it_is() {
    if std::env::var_os(PANICS).is_some() {
        panic_with_report();
    }
    let data = tempfile::tempdir().unwrap();
    let said = crash(data.path(), data.path());
    let folder = data.path().join("lightfall");
    let reports: Vec<_> = std::fs::read_dir(&folder).unwrap().flatten().collect();
    assert_eq!(reports.len(), 1, "{said}");
    let file = reports[0].path();
    assert!(
        said.contains(&format!(
            "told: Lightfall has met a fault of its own (a fault on purpose). Please send this report to its makers: {}",
            file.display()
        )),
        "{said}"
    );
    let report = std::fs::read_to_string(file).unwrap();
    for part in [
        "a fault on purpose\nwhose second line is in the report only",
        "tests/scene/crash.rs",
        "A card (vulkan), driver 1.2",
        "r = 12.25",
        "line 199 of the log",
        "line 120 of the log",
    ] {
        assert!(report.contains(part), "{part} is not in {report}");
    }
    assert!(!report.contains("line 119 of the log"), "{report}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_crash_without_a_place_for_its_report_says_why_there_is_none() {
    // A file where a folder would have to be.
    let data = tempfile::NamedTempFile::new().unwrap();
    let said = crash(data.path(), data.path());
    let sentence = format!(
        "told: Lightfall has met a fault of its own (a fault on purpose), and no report could be written: {}",
        data.path().join("lightfall").display()
    );
    assert!(said.contains(&sentence), "{said}");
}
