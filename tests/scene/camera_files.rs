//! Files of camera paths and of subtitles, as the program writes and reads them.

use super::program::program;
use lightfall_core::scene::journey;
use lightfall_core::scene::journey::SubtitleFormat;
use std::fs;
use std::path::Path;

const FLIGHT: &str = "[[keyframe]]\ntime = 0\nr = 30\ntheta_deg = 80\nyaw_deg = 20\nease = \"in\"\n\
    [[keyframe]]\ntime = 2\nr = 9\ntheta_deg = 60\nphi_deg = 400\nroll_deg = 30\nfov_deg = 90\n";

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// The numbers and words of a text.
fn words(text: &str) -> Vec<&str> {
    let words = text.split([',', '(', ')', ' ', '\n', ':']);
    words.filter(|word| !word.is_empty()).collect()
}

/// Says that two texts have the same words, and numbers that are equal but for rounding.
fn alike(a: &str, b: &str) {
    let (a, b) = (words(a), words(b));
    assert_eq!(a.len(), b.len());
    for (a, b) in a.into_iter().zip(b) {
        match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(a), Ok(b)) => assert!((a - b).abs() < 1e-9 * b.abs().max(1.0), "{a} {b}"),
            _ => assert_eq!(a, b),
        }
    }
}

#[test]
fn a_camera_path_that_was_written_is_flown_again() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("flight.toml"), FLIGHT).unwrap();
    // An older file is replaced.
    fs::write(folder.path().join("a.csv"), "old").unwrap();
    let write = |journey: &str, file: &str| {
        let line = format!(
            "camera --preset 2 --journey {journey} --frames 5..20 --fps 8 --size 1600x900 -o {file}"
        );
        let (status, stdout, stderr) = program(folder.path(), &line, "");
        assert_eq!((status, stdout), (0, format!("{file}\n")), "{stderr}");
        fs::read_to_string(folder.path().join(file)).unwrap()
    };
    let table = write("flight.toml", "a.csv");
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows.len(), 17);
    assert!(
        rows[1].starts_with("5,0.625,") && rows[16].starts_with("20,2.5,"),
        "{}",
        rows[16]
    );
    alike(&write("a.csv", "b.csv"), &table);
    assert_eq!(
        program(folder.path(), "presets check a.csv", ""),
        (0, "a.csv: ok, a journey of 2.5 s\n".into(), String::new())
    );
    let camera = write("flight.toml", "a.usda");
    assert!(
        camera.contains("\n    startTimeCode = 5\n")
            && camera.contains("float horizontalAperture = 0.426")
    );
    alike(&write("a.csv", "b.usda"), &camera);
    assert_eq!(
        names(folder.path()),
        ["a.csv", "a.usda", "b.csv", "b.usda", "flight.toml"]
    );
}

#[test]
fn a_dome_as_a_usd_camera_is_told_to_be_none() {
    let folder = tempfile::tempdir().unwrap();
    let line = "camera --preset 2 --dome --journey none --frames 0..0 -o";
    let (status, _, stderr) = program(folder.path(), &format!("{line} dome.usda"), "");
    assert_eq!(status, 0);
    assert!(
        stderr.contains("dome.usda: USD has cameras of perspective pictures alone"),
        "{stderr}"
    );
    let (status, _, stderr) = program(folder.path(), &format!("{line} dome.csv"), "");
    assert_eq!((status, stderr.contains("USD")), (0, false), "{stderr}");
}

#[test]
fn the_captions_of_a_lesson_and_of_a_file_become_subtitles() {
    let folder = tempfile::tempdir().unwrap();
    let (status, stdout, stderr) = program(folder.path(), "captions shadow --fps 25 -o s.vtt", "");
    assert_eq!((status, stdout.as_str()), (0, "s.vtt\n"), "{stderr}");
    let written = fs::read_to_string(folder.path().join("s.vtt")).unwrap();
    let lesson = journey::built_in("shadow")
        .unwrap()
        .subtitles(Some(25.0), str::to_owned);
    // The same but for the names of keys.
    assert_eq!(
        written.lines().count(),
        lesson.to_text(SubtitleFormat::WebVtt).lines().count()
    );
    assert!(
        written.starts_with("WEBVTT\n\n1\n00:00:0") && !written.contains("{window."),
        "{written}"
    );

    let file = format!("{FLIGHT}[[caption]]\ntime = 0.5\ntext = \"Näher\"\n");
    fs::write(folder.path().join("flight.toml"), file).unwrap();
    let (status, _, stderr) = program(folder.path(), "captions flight.toml -o f.SRT", "");
    assert_eq!(status, 0, "{stderr}");
    assert_eq!(
        fs::read_to_string(folder.path().join("f.SRT")).unwrap(),
        "1\n00:00:00,500 --> 00:00:06,500\nNäher\n\n"
    );
}

#[test]
fn what_is_wrong_is_refused_in_one_sentence_and_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("flight.toml"), FLIGHT).unwrap();
    fs::write(path("bad.csv"), "frame,x,y,z\n0,20,0,0\n0,19,0,0\n").unwrap();
    fs::write(
        path("deep.csv"),
        "frame,x,y,z,observer\n0,20,0,0,static\n9,0.9,0,0,static\n",
    )
    .unwrap();
    for (line, status, sentence) in [
        (
            "camera --frames 0..1 -o a.obj",
            2,
            "a.obj: unknown form of a camera path \"obj\"; allowed are .csv and .usda",
        ),
        (
            "camera --frames 0..1 -o a",
            2,
            "a: the name has no extension that says which form the camera path has; allowed are .csv and .usda",
        ),
        (
            "render --frames 0..1 --camera a.abc -o a.png",
            2,
            "a.abc: unknown form of a camera path \"abc\"; allowed are .csv and .usda",
        ),
        (
            "camera --frames 0..1 -o nowhere/a.csv",
            1,
            "nowhere/a.csv: cannot be written: there is no such folder",
        ),
        (
            "render --frames 0..1 --camera nowhere/a.csv -o a.png",
            1,
            "nowhere/a.csv: cannot be written: there is no such folder",
        ),
        (
            "camera --journey bad.csv --frames 0..1 -o a.csv",
            2,
            "bad.csv: line 3: frame = 0 is refused: it must be above the number of the row before",
        ),
        (
            "captions -o a.txt",
            2,
            "a.txt: unknown format of subtitles \"txt\"; allowed are .srt and .vtt",
        ),
        (
            "captions -o a",
            2,
            "a: the name has no extension that says which format the subtitles have; allowed are .srt and .vtt",
        ),
        (
            "captions -o nowhere/a.srt",
            1,
            "nowhere/a.srt: cannot be written: there is no such folder",
        ),
        (
            "captions flight.toml -o a.srt",
            2,
            "flight.toml: it has neither captions nor stops with a caption, so there is nothing to write",
        ),
        (
            "captions none.toml -o a.srt",
            2,
            "none.toml: cannot be read: there is no such file",
        ),
    ] {
        assert_eq!(
            program(folder.path(), line, ""),
            (status, String::new(), format!("lightfall: {sentence}\n")),
            "{line}"
        );
    }
    let (status, _, stderr) = program(
        folder.path(),
        "camera --journey deep.csv --frames 0..1 -o a.csv",
        "",
    );
    assert!(
        status == 2 && stderr.starts_with("lightfall: deep.csv: line 3 (time_s = 0.3): "),
        "{stderr}"
    );
    assert_eq!(names(folder.path()), ["bad.csv", "deep.csv", "flight.toml"]);
}
