//! Films of plain pictures, read back by ffmpeg and ffprobe, and what is said where ffmpeg fails.

use super::films::form;
use glam::UVec2;
use lightfall_picture::{Codec, Container, Ffmpeg, Film, FilmForm, PngBits};
use std::fs;
use std::path::Path;
use std::process::Command;

/// A script stands for ffmpeg.
#[cfg(unix)]
#[test]
fn the_end_of_ffmpeg_and_a_full_disk_are_told_in_a_sentence() {
    let folder = tempfile::tempdir().unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scene/false_ffmpeg");
    let ffmpeg = Ffmpeg::find(Some(&script), Codec::H264).unwrap();
    let file = folder.path().join("a.mp4");
    let told = |size: u32| {
        let mut form = form(Container::Mp4, Codec::H264);
        form.size = UVec2::splat(size);
        let mut film = Film::begin(&file, form, &ffmpeg).unwrap();
        let picture = vec![0; 3 * (size * size) as usize];
        // The pipe takes some bytes before it is known that nobody reads them.
        let added = (0..1000).try_for_each(|_| film.add(&picture));
        added.and_then(|()| film.finish()).unwrap_err().to_string()
    };
    let name = file.display();
    assert_eq!(
        told(64),
        format!("{name}: ffmpeg ended before the film was complete: [libx264] it burst")
    );
    assert_eq!(
        told(16),
        format!("{name}: cannot be written: no space is left on the disk")
    );
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// The colours of the frames of a film, from 0 to 1.
const COLOURS: [[f64; 3]; 6] = [
    [0.8, 0.3, 0.1],
    [0.1, 0.5, 0.9],
    [0.5, 0.5, 0.5],
    [0.02, 0.02, 0.03],
    [0.95, 0.9, 0.85],
    [0.3, 0.7, 0.2],
];

/// Writes a film whose frames have one colour each.
fn write_film(file: &Path, form: FilmForm) {
    let ffmpeg = Ffmpeg::find(None, form.codec).unwrap();
    let mut film = Film::begin(file, form, &ffmpeg).unwrap();
    let top = f64::from(form.bits.top());
    for colour in COLOURS {
        let pixel = colour.map(|channel| (channel * top).round() as u16);
        let pixels = form.size.element_product() as usize;
        film.add(&pixel.repeat(pixels)).unwrap();
    }
    assert!(!file.exists(), "it appears before it is complete");
    film.finish().unwrap();
}

/// What ffprobe says of the film's stream, in the order of its own list.
fn probed(file: &Path, entries: &str) -> String {
    let output = Command::new("ffprobe")
        .args("-v error -count_frames -select_streams v -of default=noprint_wrappers=1".split(' '))
        .args(["-show_entries", entries])
        .arg(file)
        .output()
        .expect("ffprobe is missing; ./check installs it");
    String::from_utf8(output.stdout).unwrap()
}

/// The mean colour of each frame, as ffmpeg shows it.
fn means(file: &Path, matrix: &str, size: UVec2) -> Vec<[f64; 3]> {
    let filter = format!(
        "zscale=min={matrix}:rin=limited:m=gbr:r=full,format=gbrp16le,crop={}:{}:0:0,format=rgb48le",
        size.x, size.y
    );
    let output = Command::new("ffmpeg")
        .args(["-v", "error", "-nostdin", "-i"])
        .arg(file)
        .args(["-vf", &filter, "-f", "rawvideo", "-"])
        .output()
        .unwrap();
    let pixels = size.element_product() as usize;
    let frames = output.stdout.chunks_exact(6 * pixels);
    let mean = |frame: &[u8]| {
        [0, 1, 2].map(|channel| {
            let levels = frame.chunks_exact(2).skip(channel).step_by(3);
            let sum: f64 = levels
                .map(|pair| f64::from(u16::from_le_bytes([pair[0], pair[1]])))
                .sum();
            sum / pixels as f64 / 65_535.0
        })
    };
    frames.map(mean).collect()
}

/// The bounds are those of a run of ffmpeg 5.1 by hand (0.9, 0.6, 0.1 and 0.4 of 255 levels), with room for
/// other releases of the encoders.
#[test]
#[ignore = "needs ffmpeg"]
fn films_have_their_frames_tags_and_colours() {
    let folder = tempfile::tempdir().unwrap();
    let sdr = ["bt709", "bt709", "bt709"];
    let hdr = ["bt2020nc", "smpte2084", "bt2020"];
    for (name, codec, probe, tags, matrix, bound) in [
        ("a.mp4", Codec::H264, ["h264", "yuv420p"], sdr, "709", 1.5),
        (
            "a.mov",
            Codec::Prores,
            ["prores", "yuv444p12le"],
            sdr,
            "709",
            0.3,
        ),
        (
            "a.webm",
            Codec::Av1,
            ["av1", "yuv420p10le"],
            sdr,
            "709",
            1.0,
        ),
        ("b.mp4", Codec::Av1, ["av1", "yuv420p10le"], sdr, "709", 1.0),
        (
            "c.mp4",
            Codec::Hdr10,
            ["hevc", "yuv420p10le"],
            hdr,
            "2020_ncl",
            0.8,
        ),
    ] {
        let file = folder.path().join(name);
        let form = form(Container::of(&file).unwrap(), codec);
        write_film(&file, form);
        let found = probed(
            &file,
            "stream=codec_name,width,height,pix_fmt,color_range,color_space,color_transfer,color_primaries,nb_read_frames",
        );
        let [codec_name, pixels] = probe;
        let [space, transfer, primaries] = tags;
        for line in [
            format!("codec_name={codec_name}"),
            "width=98".into(),
            "height=64".into(),
            "color_range=tv".into(),
            format!("color_space={space}"),
            format!("color_transfer={transfer}"),
            format!("color_primaries={primaries}"),
            "nb_read_frames=6".into(),
        ] {
            assert!(
                found.lines().any(|found| found == line),
                "{name}: {line}\n{found}"
            );
        }
        // A newer ffmpeg says how many bits of a ProRes are used.
        assert!(
            found.contains(pixels) || codec == Codec::Prores && found.contains("yuv444p10le"),
            "{found}"
        );
        let means = means(&file, matrix, form.size);
        assert_eq!(means.len(), COLOURS.len(), "{name}");
        for (mean, colour) in means.iter().zip(COLOURS) {
            for i in 0..3 {
                let error = (mean[i] - colour[i]).abs() * 255.0;
                assert!(error < bound, "{name}: {mean:?}, and not {colour:?}");
            }
        }
    }
    // Nothing else is left behind.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 5);
}

#[test]
#[ignore = "needs ffmpeg"]
fn a_film_of_odd_sides_has_one_row_and_column_more() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.mp4");
    let mut form = form(Container::Mp4, Codec::H264);
    (form.size, form.bits) = (UVec2::new(97, 63), PngBits::Eight);
    write_film(&file, form);
    assert_eq!(
        probed(&file, "stream=width,height"),
        "width=98\nheight=64\n"
    );
    // The pixels at the edge share their colour with those that were added.
    let means = means(&file, "709", form.size - 3);
    assert_eq!(means.len(), COLOURS.len());
    for (mean, colour) in means.iter().zip(COLOURS) {
        for i in 0..3 {
            assert!(
                (mean[i] - colour[i]).abs() * 255.0 < 2.0,
                "{mean:?}, and not {colour:?}"
            );
        }
    }
}

/// ffprobe reads Google's Spherical Video V2 of every format.
#[test]
#[ignore = "needs ffmpeg"]
fn a_film_of_the_whole_sky_says_so() {
    let folder = tempfile::tempdir().unwrap();
    for (name, codec) in [
        ("a.mp4", Codec::H264),
        ("b.mp4", Codec::Hdr10),
        ("a.webm", Codec::Av1),
        ("a.mov", Codec::Prores),
    ] {
        let file = folder.path().join(name);
        let mut form = form(Container::of(&file).unwrap(), codec);
        (form.size, form.is_of_whole_sky) = (UVec2::new(128, 64), true);
        write_film(&file, form);
        let found = probed(&file, "stream=nb_read_frames:stream_side_data");
        assert!(
            found.contains("nb_read_frames=6") && found.contains("projection=equirectangular"),
            "{name}: {found}"
        );
    }
}
