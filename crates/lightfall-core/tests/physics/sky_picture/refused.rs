//! Files that are no pictures of a sky: each is refused with one sentence, before anything is drawn.

use super::{Folder, JPEG, exr, hdr, png, under};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Scene, SkyMode};
use std::fs;

/// Why a scene under this file cannot be drawn, without the file's name.
fn refusal(path: &str) -> String {
    let sentence = Drawable::new(under(path)).unwrap_err().to_string();
    let start = format!("sky.picture = {path:?} is refused: ");
    let rest = sentence.strip_prefix(&start);
    rest.unwrap_or_else(|| panic!("{sentence}")).to_owned()
}

#[test]
fn every_wrong_file_is_refused_with_a_sentence() {
    let folder = Folder::new("wrong");
    let whole = png(64, 32, |x, y| [x as u8, y as u8, (x * y) as u8]);
    let runs = hdr(64, 32, true);
    let open_exr = folder.path("whole.exr");
    exr(&open_exr, [64, 32], |x, _| x as f32);
    let open_exr = fs::read(open_exr).unwrap();
    for (path, expected) in [
        (folder.path("missing.png"), "there is no such file"),
        (folder.path(""), "it is not a regular file"),
        (
            folder.file("text.png", b"no picture at all"),
            "it is no picture in EXR, HDR, PNG or JPEG",
        ),
        (
            folder.file("empty.png", b""),
            "it is no picture in EXR, HDR, PNG or JPEG",
        ),
        (
            folder.file("square.png", &png(64, 64, |_, _| [9; 3])),
            "it has 64 x 64 pixels, and a picture of the whole sky is twice as wide as high",
        ),
        (
            folder.file("small.png", &png(4, 2, |_, _| [9; 3])),
            "it has 4 x 2 pixels, and it must have 8 x 4 to 16384 x 8192",
        ),
        (
            folder.file("large.hdr", b"#?RADIANCE\n\n-Y 16384 +X 32768\n"),
            "it has 32768 x 16384 pixels, and it must have 8 x 4 to 16384 x 8192",
        ),
        (
            folder.file("other.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n"),
            "it is damaged or incomplete, or of a kind that is not read: its colours are not red, green and blue",
        ),
    ] {
        assert_eq!(refusal(&path), expected);
    }
    // The sentences of decoders are their own.
    for (name, bytes) in [
        ("cut.png", &whole[..whole.len() / 2]),
        ("cut.hdr", &runs[..runs.len() - 5]),
        ("cut.exr", &open_exr[..open_exr.len() / 2]),
        ("cut.jpg", &JPEG[..JPEG.len() - 20]),
        ("head.png", &whole[..20]),
        ("head.exr", &open_exr[..20]),
        ("head.jpg", &JPEG[..20]),
    ] {
        let sentence = refusal(&folder.file(name, bytes));
        let start = "it is damaged or incomplete, or of a kind that is not read: ";
        assert!(sentence.starts_with(start), "{name}: {sentence}");
        assert_eq!(sentence.lines().count(), 1, "{name}: {sentence}");
    }
    for (value, said) in [(f32::NAN, "NaN"), (-1.5, "-1.5"), (f32::INFINITY, "inf")] {
        let path = folder.path("value.exr");
        exr(
            &path,
            [16, 8],
            |x, y| if (x, y) == (5, 3) { value } else { 1.0 },
        );
        assert_eq!(
            refusal(&path),
            format!("the light in column 5, row 3 is {said}, and light is a number from 0 up")
        );
    }
    let mut without = Scene::default();
    without.sky.mode = SkyMode::Picture;
    assert_eq!(
        Drawable::new(without).unwrap_err().to_string(),
        "sky.mode = \"picture\" is refused: sky.picture names no file; --sky FILE shows a picture of the whole sky"
    );
    // Nothing is read for other skies.
    let mut other = under("no such file");
    other.sky.mode = SkyMode::Grid;
    assert!(Drawable::new(other).is_ok());
}
