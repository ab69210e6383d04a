//! Sequences that several processes draw, without a graphics adapter: which frames each of them draws, which
//! pictures are there already, and manifests.

use super::preset;
use glam::UVec2;
use lightfall_core::optics::stars::Catalogue;
use lightfall_core::scene::Scene;
use lightfall_picture::{
    Captured, Channels, ExrCompression, ExrForm, Found, FrameList, Linear, Manifest, ManifestRow,
    PngBits, Shard, Still, Wanted, WantedForm, find_picture, preset_difference, write_exr,
    write_png,
};
use lightfall_platform::storage::{PictureRecord, hash_of_file, hash_of_text};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

const SIZE: UVec2 = UVec2::new(37, 21);

fn list(text: &str) -> FrameList {
    text.parse().unwrap()
}

#[test]
fn a_list_of_frames_has_runs_steps_and_single_numbers_each_once_in_its_order() {
    for (text, numbers) in [
        ("5", &[5][..]),
        ("2..4", &[2, 3, 4]),
        ("2-4", &[2, 3, 4]),
        ("0..9:3", &[0, 3, 6, 9]),
        ("0-9x4", &[0, 4, 8]),
        ("0..9:100", &[0]),
        ("0-2,20,30-50x10", &[0, 1, 2, 20, 30, 40, 50]),
        // The coarse pass first, and then what it left out.
        ("0..4:2,0..4", &[0, 2, 4, 1, 3]),
        ("7,7,6..7", &[7, 6]),
    ] {
        assert_eq!(list(text).numbers(), numbers, "{text}");
    }
    // A step makes few frames of a long run.
    assert_eq!(list("0..999999999:100000").numbers().len(), 10_000);
    let is_run = |text: &str| list(text).run().is_some();
    assert!(is_run("3..9") && is_run("3,4,5") && is_run("3"));
    assert!(!is_run("0..4:2") && !is_run("5,4") && !is_run("1,3"));
}

#[test]
fn shards_draw_every_frame_of_a_list_exactly_once() {
    for text in ["0..239", "0..239:10", "5", "9,1..3,40-80x7", "0..4:2,0..4"] {
        let all = list(text);
        let mut sorted = all.numbers().to_vec();
        sorted.sort_unstable();
        for count in (1..=40).chain([239, 240, 241, 130_000]) {
            let shards: Vec<Vec<u32>> = (1..=count.min(300))
                .map(|number| Shard { number, count }.of(&all))
                .collect();
            let mut drawn = shards.concat();
            drawn.sort_unstable();
            assert_eq!(drawn, sorted, "{text} in {count} shards");
            // None has more than one frame more than another of those that have any work.
            let (least, most) = (all.numbers().len() / count as usize, shards[0].len());
            assert!(shards.iter().all(|own| (least..=most).contains(&own.len())));
            assert!(most <= least + 1, "{text} in {count} shards");
        }
    }
    let first = "1/4".parse::<Shard>().unwrap();
    assert_eq!(first.of(&list("0..9")), [0, 4, 8]);
}

/// The record of a picture of this scene, by this version.
fn record(scene: &Scene) -> PictureRecord {
    PictureRecord::new(scene, Catalogue::built_in(), None)
}

fn write_as_png(path: &Path, size: UVec2, record: &PictureRecord) {
    let pixels = 3 * size.x * size.y;
    let still = Still {
        size,
        rgb: (0..pixels).map(|at| (at * 31 % 251) as u8).collect(),
    };
    write_png(path, &still, record).unwrap();
}

fn write_as_exr(path: &Path, scene: &Scene, channels: &Channels, form: ExrForm) {
    let pixels = (SIZE.x * SIZE.y) as usize;
    let picture = Linear {
        scene,
        record: record(scene),
        light: Captured {
            size: SIZE,
            rgba: (0..pixels).map(|at| [at as u16 % 1000; 4]).collect(),
            depth: None,
        },
        first_row: 0,
        channels,
        samples: vec![vec![1.5; pixels]; channels.list().len()],
        form,
        commit: None,
        fps: Some(24.0),
    };
    write_exr(path, picture).unwrap();
}

fn scene() -> Scene {
    let mut scene = preset(2);
    (scene.picture.width, scene.picture.height) = SIZE.into();
    scene
}

/// What is found where each beginning of a whole file stands, of every length in steps.
fn expect_every_cut_to_be_noticed(path: &Path, find: &dyn Fn() -> Result<Found, String>) {
    assert_eq!(find(), Ok(Found::Whole));
    let whole = fs::read(path).unwrap();
    let lengths = (0..whole.len())
        .step_by(37)
        .chain([1, 2, 3, whole.len() - 1]);
    for length in lengths {
        fs::write(path, &whole[..length]).unwrap();
        assert_eq!(find(), Ok(Found::Partial), "{length} of {}", whole.len());
    }
    fs::write(path, &whole).unwrap();
    assert_eq!(find(), Ok(Found::Whole));
    fs::remove_file(path).unwrap();
    assert_eq!(find(), Ok(Found::Nothing));
}

#[test]
fn a_png_that_ends_too_early_is_told_from_a_whole_one() {
    let folder = tempfile::tempdir().unwrap();
    let (file, record) = (folder.path().join("f-0000.png"), record(&scene()));
    write_as_png(&file, SIZE, &record);
    let wanted = Wanted {
        size: SIZE,
        record: &record,
        is_metered: false,
        form: WantedForm::Png(PngBits::Eight),
    };
    expect_every_cut_to_be_noticed(&file, &|| find_picture(&file, &wanted));
}

#[test]
fn an_exr_that_ends_too_early_is_told_from_a_whole_one() {
    let folder = tempfile::tempdir().unwrap();
    let (file, scene) = (folder.path().join("f-0000.exr"), scene());
    let record = record(&scene);
    for compression in [ExrCompression::Zip, ExrCompression::None] {
        let form = ExrForm {
            compression,
            ..ExrForm::default()
        };
        let channels: Channels = "hit1".parse().unwrap();
        write_as_exr(&file, &scene, &channels, form);
        let wanted = Wanted {
            size: SIZE,
            record: &record,
            is_metered: false,
            form: WantedForm::Exr(&channels, form),
        };
        expect_every_cut_to_be_noticed(&file, &|| find_picture(&file, &wanted));
    }
    // A writer that was killed before it wrote the places of its blocks.
    let (channels, form) = (Channels::default(), ExrForm::default());
    write_as_exr(&file, &scene, &channels, form);
    let mut bytes = fs::read(&file).unwrap();
    let blocks = SIZE.y.div_ceil(16) as usize;
    let size = bytes.len();
    let first = (0..size - 8 * blocks).rev().find(|at| {
        let places: Vec<u64> = bytes[*at..][..8 * blocks]
            .chunks_exact(8)
            .map(|place| u64::from_le_bytes(place.try_into().unwrap()))
            .collect();
        places[0] == (at + 8 * blocks) as u64 && places.iter().all(|place| *place < size as u64)
    });
    let first = first.unwrap();
    bytes[first + 8 * (blocks - 1)..][..8].fill(0);
    fs::write(&file, &bytes).unwrap();
    let wanted = Wanted {
        size: SIZE,
        record: &record,
        is_metered: false,
        form: WantedForm::Exr(&channels, form),
    };
    assert_eq!(find_picture(&file, &wanted), Ok(Found::Partial));
}

#[test]
fn a_whole_file_that_holds_another_picture_is_refused_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("f.png");
    let scene = scene();
    let own = record(&scene);
    let find = |bits: PngBits, metered: bool| {
        let wanted = Wanted {
            size: SIZE,
            record: &own,
            is_metered: metered,
            form: WantedForm::Png(bits),
        };
        find_picture(&file, &wanted)
    };
    let refusal = |words: &str| {
        let fault = find(PngBits::Eight, false).unwrap_err();
        assert!(fault.contains(words), "{fault}");
    };
    let mut other = scene.clone();
    other.hole.spin = 0.25;
    write_as_png(&file, SIZE, &record(&other));
    refusal("was drawn with other options: hole.spin was 0.25, and is 0.9 now");

    // A metered exposure is known only when the picture is drawn again.
    let mut metered = scene.clone();
    metered.picture.exposure_ev += 1.5;
    write_as_png(&file, SIZE, &record(&metered));
    refusal("was drawn with other options: picture.exposure_ev was ");
    assert_eq!(find(PngBits::Eight, true), Ok(Found::Whole));

    let mut older = own.clone();
    for (name, text) in &mut older.texts {
        if *name == "lightfall.version" {
            *text = "0.0.9".into();
        }
    }
    write_as_png(&file, SIZE, &older);
    let version = env!("CARGO_PKG_VERSION");
    refusal(&format!(
        "the version of the program was 0.0.9, and is {version} now"
    ));

    write_as_png(&file, SIZE / 2, &own);
    refusal("has 18 x 10 pixels, and 37 x 21 are asked for now");
    write_as_png(&file, SIZE, &own);
    let fault = find(PngBits::Sixteen, false).unwrap_err();
    assert!(
        fault.contains("has 8 bits per channel, and 16 are asked for now"),
        "{fault}"
    );
    write_as_png(
        &file,
        SIZE,
        &PictureRecord {
            preset: String::new(),
            ..own.clone()
        },
    );
    refusal("was drawn with other options");
    image::RgbImage::new(SIZE.x, SIZE.y).save(&file).unwrap();
    refusal("holds no preset of Lightfall");
    fs::write(&file, "my letters").unwrap();
    refusal("is not a picture in the format PNG");
}

#[test]
fn other_channels_and_another_compression_of_an_exr_are_refused_in_words() {
    let folder = tempfile::tempdir().unwrap();
    let (file, scene) = (folder.path().join("f.exr"), scene());
    let record = record(&scene);
    let (few, form): (Channels, _) = ("steps".parse().unwrap(), ExrForm::default());
    write_as_exr(&file, &scene, &few, form);
    let find = |channels: &Channels, form: ExrForm| {
        let wanted = Wanted {
            size: SIZE,
            record: &record,
            is_metered: false,
            form: WantedForm::Exr(channels, form),
        };
        find_picture(&file, &wanted)
    };
    assert_eq!(find(&few, form), Ok(Found::Whole));
    let more = "steps,outcome".parse().unwrap();
    let fault = find(&more, form).unwrap_err();
    assert!(fault.ends_with("the difference is outcome.Y"), "{fault}");
    let compression = ExrCompression::Piz;
    let fault = find(
        &few,
        ExrForm {
            compression,
            ..form
        },
    )
    .unwrap_err();
    assert!(fault.contains("another compression"), "{fault}");
}

#[test]
fn presets_differ_in_the_first_field_that_they_do_not_share() {
    let scene = scene();
    let text = scene.to_preset();
    assert_eq!(preset_difference(&text, &text, false), None);
    // An EXR holds the preset without comments.
    let bare: String = text
        .lines()
        .filter(|line| !line.starts_with('#') && !line.is_empty())
        .map(|line| format!("{line}\n"))
        .collect();
    assert_eq!(preset_difference(&bare, &text, false), None);
    let less = bare.replace("spin = 0.9\n", "");
    assert_eq!(
        preset_difference(&less, &text, true).as_deref(),
        Some("hole.spin was not there, and is 0.9 now")
    );
}

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
    let path: PathBuf = folder.path().join("f-0007.png");
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
