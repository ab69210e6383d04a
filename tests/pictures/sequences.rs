//! Sequences: a journey as numbered files.

use super::linear::{Linear, linear, program, small};
use glam::UVec2;
use lightfall_core::scene::resized;
use lightfall_core::scene::{DiskStructure, ObserverKind, journey};
use lightfall_picture::{Frames, Sequence, render};
use std::fs;
use std::path::Path;

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.retain(|name| name != "scene.toml");
    names.sort();
    names
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_frame_is_the_still_of_the_journeys_scene_at_its_time() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = small(6);
    // The journey drives the disk's clock, too, and a smooth disk does not show it.
    scene.disk.structure = DiskStructure::None;
    // One of them is there already, and is replaced.
    fs::write(folder.path().join("f-03.png"), "old").unwrap();
    program(
        folder.path(),
        &scene,
        "--frames 2..4 --fps 0.1 --size 160x90 -o f-##.png",
    );
    assert_eq!(names(folder.path()), ["f-02.png", "f-03.png", "f-04.png"]);
    let journey = journey::load("the built-in journey", journey::DEFAULT).unwrap();
    let mut before = Vec::new();
    for number in 2..=4 {
        let mut then = scene.clone();
        let size = UVec2::new(160, 90);
        then.picture = resized(&then.picture, size);
        journey.apply(10.0 * f64::from(number), &mut then);
        let still = render(&then, size).unwrap().rgb;
        let frame = image::open(folder.path().join(format!("f-0{number}.png")))
            .unwrap()
            .to_rgb8()
            .into_raw();
        assert!(frame == still, "frame {number}");
        assert!(frame != before, "frame {number} is the one before it");
        before = frame;
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_journey_of_ones_own_is_drawn_as_linear_light_to_its_end_and_beyond() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("in.toml"),
        "schema = 1\n[[keyframe]]\ntime = 0\nr = 30\n[[keyframe]]\ntime = 1\nr = 20\n",
    )
    .unwrap();
    let mut scene = small(2);
    scene.disk.rate = 0.0;
    let options = "--journey in.toml --fps 2 --aov hit1.r --size 160x90";
    program(
        folder.path(),
        &scene,
        &format!("{options} --frames 0..3 -o in.exr"),
    );
    assert_eq!(
        names(folder.path()),
        [
            "in-0000.exr",
            "in-0001.exr",
            "in-0002.exr",
            "in-0003.exr",
            "in.toml"
        ]
    );
    let frames =
        [0, 1, 2, 3].map(|number| Linear::read(&folder.path().join(format!("in-000{number}.exr"))));
    let area = |linear: &Linear| {
        linear
            .values("hit1_radius.Y")
            .iter()
            .filter(|r| !r.is_nan())
            .count()
    };
    let areas = frames.each_ref().map(area);
    assert!(
        areas[0] < areas[1] && areas[1] < areas[2],
        "the disk does not grow: {areas:?}"
    );
    assert!(
        frames[2].light() == frames[3].light(),
        "beyond the end is the end"
    );
    assert!(
        frames[1].preset().contains("r = 24.49"),
        "half way in the radius's logarithm"
    );

    // The clock of a disk that moves does not stop at the end, although the camera does.
    scene.disk.rate = 6.0;
    program(
        folder.path(),
        &scene,
        &format!("{options} --frames 2..3 -o on-#.exr"),
    );
    let moving = [2, 3].map(|number| Linear::read(&folder.path().join(format!("on-{number}.exr"))));
    assert!(moving[0].light() != moving[1].light(), "the disk stops");
    let radii = |linear: &Linear| {
        let radii = linear.values("hit1_radius.Y");
        radii.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    };
    for frame in &moving {
        assert!(radii(frame) == radii(&frames[2]), "the camera moves");
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_scene_whose_disk_moves_makes_a_sequence_without_a_journey() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = small(2);
    scene.disk.structure = DiskStructure::Turbulent;
    (scene.disk.time, scene.disk.rate) = (3.0, 6.0);
    program(
        folder.path(),
        &scene,
        "--journey none --frames 0..1 --fps 2 --size 160x90 -o d-#.png",
    );
    assert_eq!(names(folder.path()), ["d-0.png", "d-1.png"]);
    let frames = [0, 1].map(|number| {
        let file = folder.path().join(format!("d-{number}.png"));
        image::open(file).unwrap().to_rgb8().into_raw()
    });
    assert!(frames[0] != frames[1], "the disk does not move");
    let mut then = scene.clone();
    let size = UVec2::new(160, 90);
    then.picture = resized(&then.picture, size);
    then.disk.time = 6.0;
    assert!(frames[1] == render(&then, size).unwrap().rgb);
}

#[test]
fn names_and_numbers_of_frames_are_as_the_pattern_says() {
    let sequence = |pattern: &str, frames: &str, fps: f64| {
        let journey = journey::load("the built-in journey", journey::DEFAULT).unwrap();
        Sequence::new(
            Some(journey),
            frames.parse::<Frames>().unwrap(),
            fps,
            Path::new(pattern),
        )
        .unwrap()
    };
    for (pattern, number, file) in [
        ("a.png", 7, "a-0007.png"),
        ("a.b.exr", 12345, "a.b-12345.exr"),
        ("out/a_##.png", 7, "out/a_07.png"),
        ("out/##a#b.png", 123, "out/##a123b.png"),
        ("######.exr", 7, "000007.exr"),
    ] {
        assert_eq!(
            sequence(pattern, "0..9", 24.0).file(number),
            Path::new(file)
        );
    }
    assert_eq!(sequence("a.png", "0..9", 24.0).end(), Some(132.0 * 24.0));
    assert_eq!(
        sequence("my out/100%-##.png", "5..9", 23.976).ffmpeg(960, 540),
        "ffmpeg -framerate 23.976 -start_number 5 -i 'my out/100%%-%02d.png' \
         -vf 'scale=out_color_matrix=bt709:out_range=limited,format=yuv420p' \
         -color_primaries bt709 -color_trc bt709 -colorspace bt709 -color_range tv \
         -c:v libx264 -crf 16 'my out/100%.mp4'"
    );
    let linear = "lightfall lut --preset 0000.exr -o lightfall.csp && ffmpeg -gamma 4 -framerate 30 -start_number 0 \
                  -i %04d.exr -vf 'lut3d=lightfall.csp:interp=tetrahedral,format=gbrp16le";
    let line = |width| sequence("####.exr", "0..9", 30.0).ffmpeg(width, 540);
    assert!(line(960).starts_with(&format!("{linear},setparams=")));
    assert!(line(960).ends_with(" lightfall.mp4"));
    assert!(line(961).starts_with(&format!(
        "{linear},pad=ceil(iw/2)*2:ceil(ih/2)*2,setparams="
    )));
    // ffmpeg takes what is before a colon for a protocol, and what follows a dash for an option.
    for (pattern, input) in [
        ("c:d/f-##.png", " -i ./c:d/f-%02d.png "),
        ("file:x-##.png", " -i ./file:x-%02d.png "),
        ("-f-##.png", " -i ./-f-%02d.png "),
        ("d/c:f-##.png", " -i d/c:f-%02d.png "),
    ] {
        let line = sequence(pattern, "0..9", 30.0).ffmpeg(960, 540);
        assert!(line.contains(input), "{line}");
    }
}

/// The share of a journey's last picture that is brighter than an eighth of the screen's range.
fn light_at_the_end(text: &str, observer: ObserverKind) -> f64 {
    let journey = journey::load("journey", text).unwrap();
    let mut scene = journey.preset.unwrap().plain_scene().clone();
    scene.observer.kind = observer;
    journey.apply(journey.duration, &mut scene);
    (scene.picture.width, scene.picture.height) = (480, 270);
    scene.picture.bypass = true;
    let still = render(&scene, UVec2::new(480, 270)).unwrap();
    let pixels = still.rgb.chunks(3);
    let lit = pixels.filter(|rgb| rgb.iter().any(|level| *level > 32));
    3.0 * lit.count() as f64 / still.rgb.len() as f64
}

#[test]
#[ignore = "needs a graphics adapter"]
fn bundled_journeys_end_in_the_light() {
    // A view straight up from 1.12 r_s shows a tenth of light, and people called it dark; a whole ring
    // of light around the sky makes a sixth of the picture.
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/journeys");
    let mut ends = 0;
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        for observer in [ObserverKind::Static, ObserverKind::Rain] {
            let share = light_at_the_end(&text, observer);
            println!("{}, {observer:?}: {share:.3}", path.display());
            assert!(share > 0.15, "{}, {observer:?}: {share}", path.display());
            ends += 1;
        }
    }
    assert!(ends >= 2);
}

/// The moments of a shutter lie in the middle of equal parts of its time. Half floats are rounded twice, and
/// the smallest ones have a fixed step.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_shutter_shows_the_mean_of_its_moments() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = small(2);
    scene.disk.structure = DiskStructure::Turbulent;
    (scene.disk.time, scene.disk.rate) = (3.0, 20.0);
    (scene.picture.antialias, scene.picture.automatic_exposure) = (false, false);
    let sequence = "--journey none --frames 5..5 --fps 10 --shutter 0.8 --samples 2 --layers";
    program(folder.path(), &scene, &format!("{sequence} -o m-#.exr"));
    let mean = Linear::read(&folder.path().join("m-5.exr"));
    // A frame takes 2 r_s/c of the disk's clock.
    let moments = [0.2, 0.6].map(|share| {
        let mut then = scene.clone();
        then.disk.time += (5.0 + share) * 2.0;
        linear(&then, "--layers")
    });
    let mut moved = 0;
    for channel in ["R", "G", "B", "light_hit1.R", "light_sky.G", "cover_hole.Y"] {
        let [first, second] = moments.each_ref().map(|moment| moment.values(channel));
        for (pixel, mean) in mean.values(channel).into_iter().enumerate() {
            let (first, second) = (first[pixel], second[pixel]);
            let expected = 0.5 * (first + second);
            // Times in f64 that differ by their last bit move the light by less than the rounding.
            let off = 2.0 * expected / 1024.0 + 2.0_f64.powi(-23);
            assert!(
                (mean - expected).abs() <= off,
                "{channel} of pixel {pixel}: {mean} and {expected}"
            );
            moved += usize::from((first - second).abs() > 0.1 * expected);
        }
    }
    assert!(moved > 1000, "{moved} numbers change between the moments");
}

/// What is given back to the chain is the light that it drew: nothing but the rounding to 8 bits may differ.
#[test]
#[ignore = "needs a graphics adapter"]
fn a_shutter_changes_nothing_where_nothing_moves() {
    let folder = tempfile::tempdir().unwrap();
    let mut scene = small(6);
    (scene.disk.rate, scene.picture.bypass) = (0.0, true);
    for (option, name) in [("", "plain"), ("--shutter 1 --samples 2", "open")] {
        let options = format!("--journey none --frames 0..0 {option} -o {name}-#.png");
        program(folder.path(), &scene, &options);
    }
    let [plain, open] = ["plain-0.png", "open-0.png"].map(|name| {
        let file = folder.path().join(name);
        image::open(file).unwrap().to_rgb8().into_raw()
    });
    let worst = plain.iter().zip(&open).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(worst <= Some(1), "{worst:?}");
    assert!(plain.iter().any(|level| *level > 100), "nothing is seen");
}
