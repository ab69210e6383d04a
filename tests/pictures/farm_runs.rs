//! Sequences that are killed, resumed and shared among processes, by the program itself.

use super::linear::{program, small};
use lightfall_core::scene::{DiskStructure, Scene};
use lightfall_picture::Manifest;
use lightfall_platform::storage::hash_of_file;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The longest that a test waits for a file: a software renderer compiles for minutes.
const PATIENCE: Duration = Duration::from_secs(400);

const FRAMES: &str = "--frames 0..11 --fps 4 --size 96x54";

fn scene() -> Scene {
    let mut scene = small(2);
    scene.disk.structure = DiskStructure::None;
    scene.picture.automatic_exposure = true;
    scene
}

fn command(folder: &Path, options: &str) -> Command {
    // A program that is running may just be reading it.
    let preset = folder.join("scene.toml");
    if !preset.exists() {
        fs::write(preset, scene().to_preset()).unwrap();
    }
    let mut command = Command::new(env!("CARGO_BIN_EXE_lightfall"));
    command
        .current_dir(folder)
        .args(["render", "--preset", "scene.toml"])
        .args(options.split_whitespace())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Names of the files in a folder.
fn names(folder: &Path) -> impl Iterator<Item = String> {
    let files = fs::read_dir(folder).unwrap();
    files.map(|file| file.unwrap().file_name().into_string().unwrap())
}

/// The pictures in a folder, with their bytes.
fn pictures(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    names(folder)
        .filter(|name| name.ends_with(".png") || name.ends_with(".exr"))
        .map(|name| (name.clone(), fs::read(folder.join(name)).unwrap()))
        .collect()
}

/// Names of temporary files.
fn temporary(folder: &Path) -> Vec<String> {
    names(folder)
        .filter(|name| name.ends_with(".part"))
        .collect()
}

/// Waits until something is so while a program runs.
fn wait_while(child: &mut Child, what: &str, is_so: impl Fn() -> bool) {
    let began = Instant::now();
    while !is_so() {
        // It may have ended since the last look, with everything done.
        let has_ended = child.try_wait().unwrap().is_some();
        assert!(!has_ended || is_so(), "it ended before {what}");
        assert!(began.elapsed() < PATIENCE, "{what} takes too long");
        sleep(Duration::from_millis(20));
    }
}

/// Asks a program to end, as schedulers do, and returns what it has said.
fn terminate(child: Child) -> Output {
    let mut kill = Command::new("kill");
    // It may have ended already.
    kill.args(["-TERM", &child.id().to_string()])
        .output()
        .unwrap();
    child.wait_with_output().unwrap()
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_sequence_that_was_killed_and_resumed_in_four_shards_has_the_bytes_of_one_run() {
    for format in ["png", "exr"] {
        let (one, many) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        let options = format!("{FRAMES} -o f-##.{format}");
        program(one.path(), &scene(), &options);
        let whole = pictures(one.path());
        assert_eq!(whole.len(), 12);

        // Killed without a word, and then asked to end.
        let mut killed = command(many.path(), &options).spawn().unwrap();
        wait_while(&mut killed, "three pictures", || {
            pictures(many.path()).len() >= 3
        });
        killed.kill().unwrap();
        killed.wait().unwrap();
        // A fast device may have drawn more of them.
        for name in pictures(many.path()).keys().skip(3) {
            fs::remove_file(many.path().join(name)).unwrap();
        }
        let mut asked = command(many.path(), &format!("{options} --resume"))
            .spawn()
            .unwrap();
        wait_while(&mut asked, "one more picture", || {
            pictures(many.path()).len() > 3
        });
        let output = terminate(asked);
        // It may have been done before it was asked.
        if pictures(many.path()).len() < 12 {
            assert_eq!(output.status.code(), Some(143), "{}", said(&output));
            assert!(
                said(&output).contains("asked to end (SIGTERM)"),
                "{}",
                said(&output)
            );
        }

        // What is there is kept, and a file that lost its end is drawn again.
        let kept = many.path().join(format!("f-00.{format}"));
        let time = fs::metadata(&kept).unwrap().modified().unwrap();
        let cut = many.path().join(format!("f-01.{format}"));
        let bytes = fs::read(&cut).unwrap();
        fs::write(&cut, &bytes[..bytes.len() / 2]).unwrap();
        let shards: Vec<Child> = (1..=4)
            .map(|shard| format!("{options} --resume --shard {shard}/4"))
            .map(|options| command(many.path(), &options).spawn().unwrap())
            .collect();
        for shard in shards {
            let output = shard.wait_with_output().unwrap();
            assert!(output.status.success(), "{}", said(&output));
        }
        assert_eq!(fs::metadata(&kept).unwrap().modified().unwrap(), time);
        let resumed = pictures(many.path());
        assert!(resumed.keys().eq(whole.keys()), "{:?}", resumed.keys());
        for (name, bytes) in &resumed {
            assert!(whole[name] == *bytes, "{name}");
        }

        // The manifests of the shards have every picture once, with its hash.
        let mut rows = BTreeMap::new();
        for shard in 1..=4 {
            let path = many.path().join(format!("f.{shard}-of-4.jsonl"));
            for row in Manifest::open(&path).unwrap().rows() {
                assert_eq!(row.frame % 4, shard - 1);
                let (sha256, bytes) = hash_of_file(&many.path().join(&row.file)).unwrap();
                assert_eq!((&row.sha256, row.bytes), (&sha256, bytes), "{}", row.file);
                assert!(row.adapter.is_some() && row.exposure_ev.is_some());
                assert!(rows.insert(row.file.clone(), row.frame).is_none());
            }
        }
        assert!(rows.keys().eq(whole.keys()), "{rows:?}");

        // Nothing is left to do, which is no fault; and other options are one.
        let again = command(many.path(), &format!("{options} --resume"))
            .output()
            .unwrap();
        assert!(again.status.success() && again.stdout.is_empty());
        let sentence = "lightfall: nothing to draw: all frames are there";
        assert!(said(&again).contains(sentence), "{}", said(&again));
        let other = command(many.path(), &format!("{options} --resume --spin 0.5"))
            .output()
            .unwrap();
        assert_eq!(other.status.code(), Some(2));
        let sentence = format!("lightfall: --resume: f-00.{format} was drawn with other options: ");
        let words = said(&other);
        assert!(
            words.contains(&sentence) && words.ends_with("; without --resume it is replaced\n"),
            "{words}"
        );
        assert!(pictures(many.path()) == resumed, "they stay as they are");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_large_exr_that_is_asked_to_end_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--size 4096x2304 -o large.exr";
    let mut child = command(folder.path(), options).spawn().unwrap();
    // The file by which the program tries the folder is gone at once.
    wait_while(&mut child, "the temporary file", || {
        let first = temporary(folder.path());
        sleep(Duration::from_millis(300));
        !first.is_empty() && temporary(folder.path()) == first
    });
    let began = Instant::now();
    let output = terminate(child);
    assert_eq!(output.status.code(), Some(143), "{}", said(&output));
    assert_eq!(temporary(folder.path()), [""; 0]);
    assert!(pictures(folder.path()).is_empty());
    // Schedulers kill half a minute later; the program waits for ten seconds for a frame to end.
    assert!(
        began.elapsed() < Duration::from_secs(20),
        "{:?}",
        began.elapsed()
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_shard_without_frames_and_a_manifest_that_was_changed_end_before_anything_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let run = |options: &str| command(folder.path(), options).output().unwrap();
    let none = run("--frames 0..2 --shard 4/4 -o f.png");
    assert!(none.status.success(), "{}", said(&none));
    let sentence = "lightfall: nothing to draw: shard 4/4 has none of the 3 frames\n";
    assert!(said(&none).ends_with(sentence), "{}", said(&none));
    fs::write(folder.path().join("f.1-of-2.jsonl"), "mine\n").unwrap();
    let changed = run("--frames 0..2 --shard 1/2 -o f.png");
    assert_eq!(changed.status.code(), Some(2));
    let sentence = "lightfall: f.1-of-2.jsonl: line 1: this is not a row of a manifest";
    assert!(said(&changed).contains(sentence), "{}", said(&changed));
    assert!(pictures(folder.path()).is_empty());
}
