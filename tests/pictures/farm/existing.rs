//! Pictures that are there already: whole ones, those that end too early, and other ones.

use super::{SIZE, record, scene, write_as_png};
use lightfall_core::scene::Scene;
use lightfall_picture::{
    Captured, Channels, ExrCompression, ExrForm, Found, Linear, PngBits, Wanted, WantedForm,
    find_picture, preset_difference, write_exr,
};
use lightfall_platform::storage::PictureRecord;
use std::fs;
use std::path::Path;

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

/// A picture of this record with a chosen exposure.
fn wanted<'a>(record: &'a PictureRecord, form: WantedForm<'a>) -> Wanted<'a> {
    Wanted {
        size: SIZE,
        record,
        is_metered: false,
        form,
    }
}

/// Asserts that a whole file is found to be whole, and its beginnings of many lengths to be cut.
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
    let wanted = wanted(&record, WantedForm::Png(PngBits::Eight));
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
        let wanted = wanted(&record, WantedForm::Exr(&channels, form));
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
    let wanted = wanted(&record, WantedForm::Exr(&channels, form));
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
            is_metered: metered,
            ..wanted(&own, WantedForm::Png(bits))
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
        find_picture(&file, &wanted(&record, WantedForm::Exr(channels, form)))
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
