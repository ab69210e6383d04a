//! Films by the program itself, and pictures of linear light through lookup tables.

use super::linear::{Linear, program, run, small};
use lightfall_core::optics::lut::Look;
use lightfall_core::scene::{DiskStructure, Scene, ToneCurve};
use std::fs;
use std::path::Path;
use std::process::Command;

/// The frames of a film with this matrix, as ffmpeg shows them: red, green and blue in 16 bits.
fn shown(file: &Path, matrix: &str) -> Vec<Vec<u16>> {
    let filter =
        format!("zscale=min={matrix}:rin=limited:m=gbr:r=full,format=gbrp16le,format=rgb48le");
    let output = Command::new("ffmpeg")
        .args(["-v", "error", "-nostdin", "-i"])
        .arg(file)
        .args(["-vf", &filter, "-f", "rawvideo", "-"])
        .output()
        .expect("ffmpeg is missing; ./check installs it");
    let frames = output.stdout.chunks_exact(160 * 90 * 6);
    assert!(frames.remainder().is_empty());
    let levels = |frame: &[u8]| -> Vec<u16> {
        let pairs = frame.chunks_exact(2);
        pairs
            .map(|pair| u16::from_le_bytes([pair[0], pair[1]]))
            .collect()
    };
    frames.map(levels).collect()
}

/// The mean difference of two pictures, in 255 levels.
fn difference(a: &[u16], b: &[u16]) -> f64 {
    assert_eq!(a.len(), b.len());
    let differences = a.iter().zip(b).map(|(a, b)| f64::from(a.abs_diff(*b)));
    differences.sum::<f64>() / a.len() as f64 / 257.0
}

/// A disk that moves, of 160x90 pixels, with one exposure and without bloom, which a table cannot have.
fn living() -> Scene {
    let mut scene = small(2);
    scene.disk.structure = DiskStructure::Turbulent;
    scene.disk.rate = 6.0;
    scene.picture.automatic_exposure = false;
    scene.picture.exposure_ev = 3.5;
    scene.picture.bloom = 0.0;
    scene.picture.bypass = true;
    scene
}

/// ProRes 4444 keeps a picture to a tenth of a level; an EXR is developed as the program's shader does it.
#[test]
#[ignore = "needs a graphics adapter and ffmpeg"]
fn a_film_shows_the_frames_that_are_drawn_and_so_does_one_of_exr_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let here = |name: &str| folder.path().join(name);
    let scene = living();
    let options = "--journey none --frames 0..2 --fps 1 --size 160x90";
    program(
        folder.path(),
        &scene,
        &format!("{options} --bits 16 -o f-#.png"),
    );
    program(folder.path(), &scene, &format!("{options} -o f-#.exr"));
    program(folder.path(), &scene, &format!("{options} -o drawn.mov"));
    for (pictures, film) in [("f-#.png", "png.mov"), ("f-#.exr", "exr.mov")] {
        let line = format!("video {pictures} --fps 1 -o {film}");
        let made = run(folder.path(), &line);
        assert_eq!(made.stdout, format!("{film}\n").as_bytes());
    }
    let drawn = [0, 1, 2].map(|number| {
        let file = here(&format!("f-{number}.png"));
        image::open(file).unwrap().to_rgb16().into_raw()
    });
    for film in ["drawn.mov", "png.mov", "exr.mov"] {
        let frames = shown(&here(film), "709");
        assert_eq!(frames.len(), 3, "{film}");
        for (number, frame) in frames.iter().enumerate() {
            let found = difference(frame, &drawn[number]);
            println!("{film}, frame {number}: {found:.3}");
            assert!(found < 0.6, "{film}, frame {number}: {found}");
            let other = difference(frame, &drawn[(number + 1) % 3]);
            assert!(
                found < 0.5 * other,
                "{film} shows another frame as {number}"
            );
        }
    }
}

/// The first and the last frame of a loop are neighbours, as others are.
#[test]
#[ignore = "needs a graphics adapter and ffmpeg"]
fn a_loop_goes_on_at_its_beginning() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--loop 1 --fps 12 --size 160x90";
    program(folder.path(), &living(), &format!("{options} -o a.mov"));
    let frames = shown(&folder.path().join("a.mov"), "709");
    assert_eq!(frames.len(), 12);
    let apart = |a: usize, b: usize| difference(&frames[a], &frames[b]);
    let steps: Vec<f64> = (0..11).map(|number| apart(number, number + 1)).collect();
    let largest = steps.iter().copied().fold(0.0, f64::max);
    let seam = apart(11, 0);
    assert!(seam > 0.0 && seam < 1.5 * largest, "{seam}, and {steps:?}");
}

/// HDR10's film has the light above white, which the film for a screen cuts off.
#[test]
#[ignore = "needs a graphics adapter and ffmpeg"]
fn a_film_in_hdr10_is_brighter_than_its_white() {
    let folder = tempfile::tempdir().unwrap();
    let options = "--journey none --frames 0..1 --fps 24 --size 160x90 --codec hdr10";
    program(folder.path(), &living(), &format!("{options} -o a.mp4"));
    let codes = shown(&folder.path().join("a.mp4"), "2020_ncl").concat();
    assert_eq!(codes.len(), 2 * 3 * 160 * 90);
    let largest = f64::from(codes.into_iter().max().unwrap()) / 65_535.0;
    // The code of white is 0.58, and that of the peak 0.752. A lossy codec overshoots at edges.
    assert!((0.62..0.8).contains(&largest), "{largest}");
}

/// The curves in f64 are those of the shader: an EXR through them is the PNG, to the rounding of half floats
/// and of eight bits.
#[test]
#[ignore = "needs a graphics adapter"]
fn light_through_a_curve_in_f64_is_the_picture() {
    for curve in ToneCurve::ALL {
        let folder = tempfile::tempdir().unwrap();
        let mut scene = living();
        scene.picture.tone_curve = curve;
        program(folder.path(), &scene, "--size 160x90 -o a.exr");
        program(folder.path(), &scene, "--size 160x90 -o a.png");
        let linear = Linear::read(&folder.path().join("a.exr"));
        let [red, green, blue] = linear.light();
        let png = image::open(folder.path().join("a.png")).unwrap().to_rgb8();
        let look = Look::of(&scene);
        let mut errors: Vec<f64> = Vec::new();
        for (i, pixel) in png.pixels().enumerate() {
            let light = [red[i], green[i], blue[i]].map(|channel| channel as f32);
            let wanted = look.shown(light, scene.picture.exposure_ev.exp2());
            for (level, code) in pixel.0.iter().zip(wanted) {
                errors.push((f64::from(*level) - 255.0 * code).abs());
            }
        }
        errors.sort_by(f64::total_cmp);
        let p999 = errors[errors.len() * 999 / 1000];
        println!("{curve:?}: {p999:.2}");
        // The level is rounded with noise of one level.
        assert!(p999 < 1.3, "{curve:?}: {p999}");
    }
}

/// A table's file appears, with the metered exposure where the scene has it metered.
#[test]
fn the_program_writes_a_table_of_each_form() {
    let folder = tempfile::tempdir().unwrap();
    for (name, begin) in [
        ("a.csp", "CSPLUTV100\n3D\n"),
        ("a.clf", "<?xml version=\"1.0\""),
        ("a.cube", "LUT_1D_SIZE 65536\n"),
    ] {
        let line = format!("lut --preset 2 --set picture.tone_curve=aces -o {name}");
        let made = run(folder.path(), &line);
        let said = String::from_utf8_lossy(&made.stderr);
        assert!(said.contains("the tone curve aces"), "{said}");
        assert_eq!(made.stdout, format!("{name}\n").as_bytes());
        let text = fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(text.starts_with(begin), "{name}");
        // A cube of 65 places a side, and a shaper.
        assert!(text.lines().count() > 65 * 65 * 65, "{name}");
    }
}
