//! The options of `lightfall render`.

use super::{read, refuse};
use clap::error::ErrorKind;
use lightfall::commands;
use lightfall::commands::cli::Command;
use std::path::Path;

#[test]
fn render_reads_channels_timings_and_frames() {
    let Command::Render(render) = read("lightfall render -o a.exr --aov steps,hit1,sky.z,steps")
    else {
        panic!()
    };
    let names: Vec<_> = render
        .aov
        .unwrap()
        .list()
        .iter()
        .map(|channel| channel.name)
        .collect();
    assert_eq!(
        names,
        [
            "sky_direction.Z",
            "hit1_radius.Y",
            "hit1_azimuth.Y",
            "hit1_shift.Y",
            "hit1_temperature.Y",
            "hit1_delay.Y",
            "steps.Y"
        ]
    );
    for list in ["foo", "sky,", "SKY", "hit3", "hit1.", "."] {
        let error = refuse(&format!("lightfall render -o a.exr --aov={list}")).to_string();
        assert!(
            error.contains("there is no channel") && error.contains("hit2_azimuth.Y"),
            "{error}"
        );
    }
    let timings = |line: &str| match read(line) {
        Command::Render(render) => render.timings,
        _ => None,
    };
    assert_eq!(timings("lightfall render -o a.png"), None);
    assert_eq!(timings("lightfall render --timings -o a.png"), Some(None));
    assert_eq!(
        timings("lightfall render --timings=t.csv -o a.png"),
        Some(Some("t.csv".into()))
    );
    let line = "lightfall --journey j.toml render -o a.png --frames 10..20 --fps 23.976";
    let Command::Render(render) = read(line) else {
        panic!()
    };
    let frames = render.frames.unwrap();
    let ends = frames.ends();
    assert_eq!((ends.first, ends.last, render.fps), (10, 20, 23.976));
    assert_eq!(frames.run(), Some(ends));
    assert_eq!(render.journey.as_deref(), Some(Path::new("j.toml")));
    for frames in [
        "3..2", "", "..", "-1..2", "0..x", "0...9", "+1..2", "a..b", "1,", ",1", "1,,2", "5-3",
        "0..9,x",
    ] {
        let error = refuse(&format!("lightfall render -o a.png --frames={frames}")).to_string();
        assert!(error.contains("frames are A..B"), "{error}");
    }
    for frames in ["999999999..1000000000", "1..99999999999", "1000000000..5"] {
        let error = refuse(&format!("lightfall render -o a.png --frames={frames}")).to_string();
        let sentence = "the number of a frame is at most 999999999";
        assert_eq!(
            error.contains(sentence),
            !frames.ends_with("..5"),
            "{error}"
        );
    }
    assert!(
        refuse("lightfall render -o a.png --frames 0..999999999")
            .to_string()
            .contains("at most 130000")
    );
    for fps in ["0", "-1", "nan", "inf", "x", "1001"] {
        let error = refuse(&format!(
            "lightfall render -o a.png --frames 0..1 --fps={fps}"
        ))
        .to_string();
        assert!(error.contains("from 0.01 to 1000"), "{error}");
    }
    let comma = refuse("lightfall render -o a.png --frames 0..1 --fps 23,976").to_string();
    assert!(comma.contains("did you mean 23.976?"), "{comma}");
    assert_eq!(
        refuse("lightfall render -o a.png --fps 25").kind(),
        ErrorKind::MissingRequiredArgument
    );
    for line in [
        "lightfall render -o a.png --journey j.toml",
        "lightfall --journey i.toml render -o a.png --frames 0..1 --journey j.toml",
        "lightfall render -o a.png --frames 0..1 --timings",
        "lightfall --journey j.toml trace --rays -",
    ] {
        assert_eq!(refuse(line).kind(), ErrorKind::ArgumentConflict, "{line}");
    }
}

#[test]
fn shards_steps_and_the_rest_of_a_farm_are_refused_in_words_that_say_what_is_allowed() {
    let farm = |options: &str| match read(&format!("lightfall render -o a.png {options}")) {
        Command::Render(render) => render.farm,
        _ => panic!("{options}"),
    };
    let shard = farm("--frames 0..9 --shard 2/4 --manifest").shard.unwrap();
    assert_eq!((shard.number, shard.count), (2, 4));
    assert!(farm("--frames 0..9 --resume").resume);
    for shard in [
        "0/4",
        "5/4",
        "a/b",
        "1/0",
        "0/0",
        "1",
        "1/",
        "/4",
        "-1/4",
        "1/4/4",
        "1.5/4",
        "1/130001",
        "99999999999/4",
    ] {
        let line = format!("lightfall render -o a.png --frames 0..9 --shard={shard}");
        let error = refuse(&line).to_string();
        assert!(
            error.contains("a shard is K/N, such as 1/4") && error.contains("K from 1 to N"),
            "{error}"
        );
    }
    for step in ["0", "-1", "x", "", "1.5", "99999999999"] {
        for mark in [":", "x"] {
            let line = format!("lightfall render -o a.png --frames=0..9{mark}{step}");
            let error = refuse(&line).to_string();
            assert!(
                error.contains("the step of frames is a whole number from 1"),
                "{error}"
            );
        }
    }
    for option in ["--shard 1/4", "--resume", "--manifest"] {
        let error = refuse(&format!("lightfall render -o a.png {option}"));
        assert_eq!(error.kind(), ErrorKind::MissingRequiredArgument);
        assert!(error.to_string().contains("--frames <A..B>"), "{error}");
    }
}

#[test]
fn the_form_of_an_exr_has_listed_words_and_is_for_channels_where_it_concerns_them() {
    let Command::Render(render) =
        read("lightfall render -o a.exr --aov all --nan zero --exr piz --aov-names 0.1")
    else {
        panic!()
    };
    assert_eq!(
        (render.nan.as_deref(), render.exr.as_deref()),
        (Some("zero"), Some("piz"))
    );
    let Command::Render(render) = read("lightfall render -o a.exr --layers --alpha hole") else {
        panic!()
    };
    assert_eq!(
        (render.layers, render.alpha.as_deref()),
        (true, Some("hole"))
    );
    for (option, words) in [
        ("--exr=pxr24", "zip, zips, piz, rle, none"),
        ("--nan=0", "keep, zero"),
        ("--alpha=disk", "sky, hole"),
    ] {
        let error = refuse(&format!("lightfall render -o a.exr --aov sky {option}")).to_string();
        assert!(error.contains(words), "{error}");
    }
    assert_eq!(
        refuse("lightfall render -o a.exr --nan zero").kind(),
        ErrorKind::MissingRequiredArgument
    );
}

#[test]
fn a_shutter_is_open_for_a_part_of_the_time_between_frames() {
    let Command::Render(render) =
        read("lightfall render -o a.png --frames 0..9 --shutter 0.5 --samples 8")
    else {
        panic!()
    };
    assert_eq!(render.shutter, Some(0.5));
    for share in ["0", "-0.5", "1.01", "nan", "180"] {
        let line = format!("lightfall render -o a.png --frames 0..9 --shutter={share}");
        let error = refuse(&line).to_string();
        assert!(error.contains("above 0 and up to 1"), "{error}");
    }
    let comma = refuse("lightfall render -o a.png --frames 0..9 --shutter 0,5").to_string();
    assert!(comma.contains("did you mean 0.5?"), "{comma}");
    assert_eq!(
        refuse("lightfall render -o a.png --shutter 0.5").kind(),
        ErrorKind::MissingRequiredArgument
    );
}

#[test]
fn only_an_adapter_that_is_a_program_is_said_to_need_a_graphics_card() {
    use wgpu::DeviceType::{Cpu, DiscreteGpu, IntegratedGpu, Other, VirtualGpu};
    let said = |kind| commands::still_drawing([1920, 1080].into(), kind);
    let plain = "still drawing 1920 x 1080 pixels";
    let slow = "; without a graphics card a large picture takes minutes";
    assert_eq!(said(Some(Cpu)), format!("{plain}{slow}"));
    for kind in [DiscreteGpu, IntegratedGpu, VirtualGpu, Other].map(Some) {
        assert_eq!(said(kind), plain);
    }
    assert_eq!(said(None), plain);
}

#[test]
fn a_loop_has_a_length_and_no_range_of_frames() {
    let line =
        "lightfall --journey none render -o a.mp4 --loop 10 --fps 25 --codec av1 --ffmpeg f/ffmpeg";
    let Command::Render(render) = read(line) else {
        panic!()
    };
    assert_eq!((render.loop_seconds, render.fps), (Some(10.0), 25.0));
    assert_eq!(render.journey.as_deref(), Some(Path::new("none")));
    assert_eq!(render.film.codec.as_deref(), Some("av1"));
    assert_eq!(render.film.ffmpeg.as_deref(), Some(Path::new("f/ffmpeg")));
    for line in [
        "lightfall render -o a.mp4 --loop 2 --frames 0..1",
        "lightfall render -o a.mp4 --loop 2 --timings",
    ] {
        assert_eq!(refuse(line).kind(), ErrorKind::ArgumentConflict, "{line}");
    }
    for seconds in ["0", "-1", "nan", "x", "1e9"] {
        let error = refuse(&format!("lightfall render -o a.mp4 --loop={seconds}")).to_string();
        assert!(error.contains("from 0.1 to 86400"), "{error}");
    }
    let error = refuse("lightfall render -o a.mp4 --frames 0..1 --codec vp9").to_string();
    assert!(error.contains("h264, hdr10, av1, prores"), "{error}");
}

#[test]
fn films_of_pictures_and_tables_have_commands_of_their_own() {
    let Command::Video(video) = read("lightfall video a-##.png -o a.mp4 --fps 12 --codec h264")
    else {
        panic!()
    };
    assert_eq!(video.pictures, Path::new("a-##.png"));
    assert_eq!((video.out.as_path(), video.fps), (Path::new("a.mp4"), 12.0));
    assert_eq!(video.film.codec.as_deref(), Some("h264"));
    let Command::Lut(lut) = read("lightfall --spin 0.5 lut -o a.csp --preset 3 --hdr 600") else {
        panic!()
    };
    assert_eq!(
        (lut.out.as_path(), lut.hdr),
        (Path::new("a.csp"), Some(600))
    );
    assert_eq!(lut.scene.spin.as_deref(), Some("0.5"));
    for peak in ["299", "10001", "bright"] {
        let error = refuse(&format!("lightfall lut -o a.csp --hdr {peak}")).to_string();
        assert!(error.contains("from 300 to 10000"), "{error}");
    }
    assert_eq!(
        refuse("lightfall --preset 2 video a.png -o a.mp4").kind(),
        ErrorKind::ArgumentConflict
    );
}
