//! Results that cannot be written: status one and one sentence that names the place and the reason,
//! before any work is done, and nothing else is left behind.

use super::program::program;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};

/// Says of each command line whether the program ends with status one and this sentence alone.
fn expect_refusals(folder: &Path, cases: &[(&str, &str)]) {
    for (line, sentence) in cases {
        assert_eq!(
            program(folder, line, ""),
            (1, String::new(), format!("lightfall: {sentence}\n")),
            "{line}"
        );
    }
}

#[test]
fn a_place_that_cannot_be_written_is_status_one_and_a_sentence_that_names_it() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("afile"), "").unwrap();
    expect_refusals(
        folder.path(),
        &[
            (
                "render --frames 0..1 -o nowhere/a.exr",
                "nowhere/a-0000.exr: cannot be written: there is no such folder",
            ),
            (
                "render --frames 0..1 -o nowhere/a.apng",
                "nowhere/a.apng: cannot be written: there is no such folder",
            ),
            (
                "render -o nowhere/a.png",
                "nowhere/a.png: cannot be written: there is no such folder",
            ),
            (
                "render --timings=nowhere/t.csv -o a.png",
                "nowhere/t.csv: cannot be written: there is no such folder",
            ),
            (
                "bench --quick --out afile",
                "--out afile: afile is a file, and this must be a folder, or one that can be made",
            ),
            (
                "extremes --out afile/deep",
                "--out afile/deep: afile is a file, and this must be a folder, or one that can be made",
            ),
        ],
    );
}

#[test]
fn times_are_not_written_in_the_place_of_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    for file in ["a.png", "./a.png"] {
        let sentence = format!(
            "lightfall: --timings={file}: this is the picture's file; the times need a file of their own\n"
        );
        assert_eq!(
            program(
                folder.path(),
                &format!("render --timings={file} -o a.png"),
                ""
            ),
            (2, String::new(), sentence)
        );
    }
}

#[test]
fn a_folder_in_the_place_of_a_picture_is_found_before_any_picture_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let folders = ["a.png", "a.exr", "a.apng", "b-0007.png"];
    for name in folders {
        fs::create_dir(folder.path().join(name)).unwrap();
    }
    expect_refusals(
        folder.path(),
        &[
            (
                "render -o a.png",
                "a.png: cannot be written: it is a folder",
            ),
            (
                "render -o a.exr",
                "a.exr: cannot be written: it is a folder",
            ),
            (
                "render --frames 0..1 -o a.apng",
                "a.apng: cannot be written: it is a folder",
            ),
            // The eighth of ten frames.
            (
                "render --frames 0..9 -o b.png",
                "b-0007.png: cannot be written: it is a folder",
            ),
        ],
    );
    let left = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(left, folders.len(), "only the folders");
}

/// In /proc no file can be created, not even by root.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_accepts_no_files_is_found_before_any_work_is_done() {
    let folder = tempfile::tempdir().unwrap();
    expect_refusals(
        folder.path(),
        &[
            (
                "render -o /proc/x.png",
                "/proc/x.png: cannot be written: the folder accepts no new files",
            ),
            (
                "render --aov all -o /proc/x.exr",
                "/proc/x.exr: cannot be written: the folder accepts no new files",
            ),
            (
                "render --frames 0..1 -o /proc/x.png",
                "/proc/x-0000.png: cannot be written: the folder accepts no new files",
            ),
            (
                "render --frames 0..9 --shard 3/4 --resume -o /proc/x.png",
                "/proc/x-0002.png: cannot be written: the folder accepts no new files",
            ),
            (
                "render --timings=/dev/null -o a.png",
                "/dev/null: cannot be written: it is not a regular file",
            ),
            (
                "bench --quick --out /proc",
                "--out /proc: no report can be written: the folder accepts no new files",
            ),
            (
                "extremes --out /proc",
                "--out /proc: no report can be written: the folder accepts no new files",
            ),
        ],
    );
    let long = "x".repeat(300);
    let (status, stdout, stderr) = program(folder.path(), &format!("render -o {long}.png"), "");
    let sentence = format!("lightfall: {long}.png: cannot be written: file name too long");
    assert!(
        status == 1 && stdout.is_empty() && stderr.starts_with(&sentence),
        "{stderr}"
    );
}

/// /dev/full is a disk without room.
#[cfg(target_os = "linux")]
#[test]
fn standard_output_on_a_full_disk_is_status_one_and_a_sentence() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("rays"), "0,0,1\n").unwrap();
    for line in [
        "presets list",
        "presets show 2",
        "trace --rays rays --device cpu",
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_lightfall"))
            .args(line.split(' '))
            .current_dir(&folder)
            .stdout(Stdio::from(
                File::options().write(true).open("/dev/full").unwrap(),
            ))
            .output()
            .unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{line}: {stderr}");
        assert!(
            stderr.starts_with("lightfall: standard output: ") && stderr.lines().count() == 1,
            "{line}: {stderr}"
        );
    }
}

/// What is said on standard error changes nothing, so a place without room for it is no fault.
#[cfg(target_os = "linux")]
#[test]
fn standard_error_on_a_full_disk_changes_no_exit_status() {
    for (line, status) in [
        ("--spin 2", 2),
        ("presets show nothing", 2),
        ("presets list", 0),
        ("extremes --hunt 10 --seed 1 --delay", 2),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_lightfall"))
            .args(line.split(' '))
            .stderr(Stdio::from(
                File::options().write(true).open("/dev/full").unwrap(),
            ))
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(status), "{line}");
    }
}
