//! Manifests: what their rows say of the files, and which lines are refused.

use super::{SIZE, record, scene, write_as_png};
use lightfall_picture::{Manifest, ManifestRow};
use lightfall_platform::storage::{hash_of_file, hash_of_text};
use std::collections::BTreeMap;
use std::fs;

fn row(frame: u32, file: &str) -> ManifestRow {
    ManifestRow {
        frame,
        file: file.into(),
        sha256: hash_of_text(file),
        bytes: 12,
        seconds: Some(0.5),
        exposure_ev: Some(-1.25),
        preset_sha256: hash_of_text("preset"),
        version: Some("0.1.0".into()),
        commit: None,
        adapter: Some("a card (Vulkan)".into()),
        driver: None,
        backend: None,
        pci: None,
        host: Some("node-7".into()),
    }
}

#[test]
fn a_manifest_is_read_back_as_it_was_written_and_keeps_rows_of_other_frames() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flight.1-of-4.jsonl");
    let mut manifest = Manifest::open(&path).unwrap();
    assert_eq!(manifest.rows().count(), 0);
    for frame in [8, 0, 4] {
        manifest.insert(row(frame, &format!("flight-{frame:04}.png")));
        manifest.write().unwrap();
    }
    let again = Manifest::open(&path).unwrap();
    let frames: Vec<u32> = again.rows().map(|row| row.frame).collect();
    assert_eq!(frames, [0, 4, 8]);
    assert!(again.rows().eq(manifest.rows()));
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(text.lines().count(), 3);
    // A frame that is drawn again has one row, and the others stay.
    let mut again = again;
    let mut newer = row(4, "flight-0004.png");
    newer.bytes = 13;
    again.insert(newer.clone());
    again.write().unwrap();
    let last = Manifest::open(&path).unwrap();
    assert_eq!(last.rows().count(), 3);
    assert!(last.rows().any(|row| *row == newer));
    // A row knows its file as long as the file keeps its length.
    let file = folder.path().join("flight-0004.png");
    assert!(!last.knows(4, &file));
    fs::write(&file, [0_u8; 13]).unwrap();
    assert!(last.knows(4, &file) && !last.knows(5, &file));
    fs::write(&file, [0_u8; 14]).unwrap();
    assert!(!last.knows(4, &file));
}

#[test]
fn a_manifest_with_a_line_that_is_wrong_is_refused_with_the_number_of_the_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("m.jsonl");
    let good = serde_json::to_string(&row(0, "a.png")).unwrap();
    let with = |from: &str, to: &str| {
        let line = good.replace(from, to);
        assert!(line != good, "{from}");
        line
    };
    let digits = hash_of_text("a.png");
    for (line, words) in [
        (String::new(), "not a row"),
        ("{".into(), "not a row"),
        (good[..good.len() / 2].into(), "not a row"),
        (with("\"frame\":0", "\"frame\":-1"), "not a row"),
        (with("\"frame\":0,", ""), "not a row"),
        (with("\"bytes\"", "\"size\""), "not a row"),
        (with("\"frame\"", "\"mine\":1,\"frame\""), "not a row"),
        (with("a.png", "../a.png"), "must be the name of a file"),
        (with(&digits, "12ab"), "must have 64 digits"),
        (with(&digits, &digits.to_uppercase()), "must have 64 digits"),
        (good.clone(), "there is a line for a.png already"),
    ] {
        fs::write(&path, format!("{good}\n{line}\n{good}\n")).unwrap();
        let fault = Manifest::open(&path).unwrap_err().to_string();
        let start = format!("{}: line 2: ", path.display());
        assert!(
            fault.starts_with(&start) && fault.contains(words),
            "{line}: {fault}"
        );
        assert_eq!(fault.lines().count(), 1, "{fault}");
    }
    fs::write(&path, [0xff_u8, 0xfe, 0xfd]).unwrap();
    assert!(Manifest::open(&path).is_err());
}

#[test]
fn the_row_of_a_picture_says_what_its_file_says() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("f-0007.png");
    let mut scene = scene();
    scene.picture.exposure_ev = 2.5;
    let record = record(&scene);
    write_as_png(&path, SIZE, &record);
    let row = ManifestRow::of_file(7, &path).unwrap();
    let (sha256, bytes) = hash_of_file(&path).unwrap();
    assert_eq!(bytes, fs::metadata(&path).unwrap().len());
    let texts: BTreeMap<_, _> = record.texts.iter().cloned().collect();
    assert_eq!((row.frame, &*row.file), (7, "f-0007.png"));
    assert_eq!((row.sha256, row.bytes), (sha256, bytes));
    assert_eq!(row.exposure_ev, Some(2.5));
    assert_eq!(row.preset_sha256, hash_of_text(&record.preset));
    assert_eq!(row.version.as_ref(), texts.get("lightfall.version"));
    assert_eq!((row.seconds, row.host), (None, None));
    // The hash of "abc" in FIPS 180-2, appendix B.1.
    assert_eq!(
        hash_of_text("abc"),
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    );
    assert!(ManifestRow::of_file(7, &folder.path().join("none.png")).is_err());
}
