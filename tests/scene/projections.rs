//! Projections on the command line: what is refused, in one sentence before anything is drawn, and
//! what files are written.

use crate::program::program;
use std::fs;

/// What the program says, with its exit status.
fn said(line: &str) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    let (status, _, stderr) = program(folder.path(), line, "");
    assert_eq!(
        fs::read_dir(&folder)
            .unwrap()
            .filter(|entry| {
                let name = entry.as_ref().unwrap().file_name();
                name.to_string_lossy().starts_with("a.")
            })
            .count(),
        0,
        "{line}"
    );
    (status, stderr)
}

#[test]
fn wrong_sizes_files_and_options_are_refused_in_one_sentence() {
    let sky = "--set camera.projection=equirectangular";
    let cube = "--set camera.projection=cube";
    for (options, sentence) in [
        (
            format!("{sky} -o a.png"),
            "camera.projection: an equirectangular picture is twice as wide as it is high, such as 2048x1024, and not 960x540; --size gives another",
        ),
        (
            format!("{sky} --size 100x60 -o a.exr"),
            "--size: an equirectangular picture is twice as wide as it is high, such as 2048x1024, and not 100x60; --size gives another",
        ),
        (
            format!("{cube} --size 100x60 -o a.png"),
            "--size: the six sides of a cube are three beside each other and two above each other, such as 3072x2048, and not 100x60; --size gives another",
        ),
        (
            "--dome --size 100x60 -o a.png".into(),
            "--size: the picture for a dome is a square, such as 2048x2048, and not 100x60",
        ),
        (
            "--dome --cells on -o a.png".into(),
            "--cells on: only perspective pictures are shown in cells, and camera.projection is \"fisheye\"",
        ),
        (
            format!("{cube} --size 96x64 --timings -o a.png"),
            "--timings: the six sides of a cube are drawn one after another, which is not timed",
        ),
        (
            "-o a.{face}.png".into(),
            "-o: {face} stands for the sides of a cube, which --set camera.projection=cube draws",
        ),
        (
            format!("{cube} --size 96x64 --frames 0..1 -o a.{{face}}.apng"),
            "-o: {face} stands for files of pictures: the name must end in .png or .exr",
        ),
    ] {
        let line = format!("render {options}");
        assert_eq!(
            said(&line),
            (2, format!("lightfall: {sentence}\n")),
            "{line}"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_probe_is_refused_outside_of_perspective() {
    for options in ["--dome", "--set camera.shift=0.1,0"] {
        let (status, sentence) = said(&format!(
            "render --preset 6 {options} --size 64x64 -o a.png"
        ));
        assert_eq!((status, sentence.lines().count()), (2, 1), "{sentence}");
        assert!(
            sentence.contains("probe.enabled = true is refused: the probe is drawn in perspective")
        );
    }
}

/// A dome has no cells, and what `--dome` sets is not called idle; `--set` may change any of it.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_dome_a_whole_sky_and_a_cube_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let draw = |options: &str, files: &[(&str, [u32; 2])]| {
        let line = format!("render --preset 2 --spin 0 {options}");
        let (status, stdout, stderr) = program(folder.path(), &line, "");
        assert_eq!(status, 0, "{line}: {stderr}");
        assert!(
            !stderr.contains("chang") && !stderr.contains("cells"),
            "{line}: {stderr}"
        );
        let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
        assert_eq!(stdout.lines().collect::<Vec<_>>(), names, "{line}");
        for (name, size) in files {
            let path = folder.path().join(name);
            let found = if name.ends_with(".exr") {
                let header = exr::meta::MetaData::read_from_file(&path, false)
                    .unwrap()
                    .headers;
                let size = header[0].layer_size;
                let map = header[0].own_attributes.environment_map;
                assert!(map.is_some(), "{name}");
                [size.0 as u32, size.1 as u32]
            } else {
                image::image_dimensions(&path).unwrap().into()
            };
            assert_eq!(found, *size, "{name}");
        }
    };
    draw(
        "--dome --set camera.tilt_deg=75 --size 64x64 -o dome.png",
        &[("dome.png", [64, 64])],
    );
    let sky = "--set camera.projection=equirectangular --size 64x32";
    draw(&format!("{sky} -o sky.png"), &[("sky.png", [64, 32])]);
    draw(&format!("{sky} -o sky.exr"), &[("sky.exr", [64, 32])]);
    let cube = "--set camera.projection=cube --size 48x32";
    draw(&format!("{cube} -o cube.png"), &[("cube.png", [48, 32])]);
    draw(&format!("{cube} -o cube.exr"), &[("cube.exr", [16, 96])]);
    draw(
        &format!("{cube} --bits 16 -o deep.png"),
        &[("deep.png", [48, 32])],
    );
    let faces = ["right", "left", "up", "down", "front", "back"];
    let faces = faces.map(|face| format!("{face}.png"));
    let files: Vec<_> = faces.iter().map(|face| (&**face, [16, 16])).collect();
    draw(&format!("{cube} -o {{face}}.png"), &files);
    // Only a picture of the whole sky says that it is one.
    let holds = |file: &str| {
        let bytes = fs::read(folder.path().join(file)).unwrap();
        let text = String::from_utf8_lossy(&bytes).into_owned();
        text.contains("<GPano:ProjectionType>equirectangular</GPano:ProjectionType>")
            && text.contains("<GPano:FullPanoWidthPixels>64</GPano:FullPanoWidthPixels>")
    };
    assert!(holds("sky.png") && !holds("dome.png") && !holds("cube.png"));
}
