//! The arguments of `lightfall` and their meaning.

mod copied;
mod help;
mod paths;
mod presets;
mod render;

use std::fs;
use std::path::Path;

use clap::error::ErrorKind;
use lightfall::commands::cli::{Command, Device, FlyArgs, SceneArgs};
use lightfall::commands::{self, cli};
use lightfall_core::scene::journey;
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{Method, Scene};

fn read(line: &str) -> Command {
    cli::read(line.split(' ')).unwrap()
}

fn refuse(line: &str) -> clap::Error {
    let error = cli::read(line.split(' ')).unwrap_err();
    assert_eq!(error.exit_code(), 2, "{line}");
    error
}

fn fly(line: &str) -> SceneArgs {
    let Command::Fly(FlyArgs { scene, .. }) = read(line) else {
        panic!("{line} does not fly")
    };
    scene
}

fn fault(args: &SceneArgs) -> String {
    let error = commands::scene(args).unwrap_err();
    assert_eq!(error.status, 2);
    error.to_string()
}

fn preset() -> Scene {
    PRESETS[2].scene(&[]).unwrap()
}

fn of_preset(preset: &Path) -> SceneArgs {
    SceneArgs {
        preset: Some(preset.into()),
        ..SceneArgs::default()
    }
}

fn answer(line: &str) -> String {
    let Command::Presets(command) = read(line) else {
        panic!("{line} is about presets")
    };
    let mut out = Vec::new();
    commands::presets(&command, &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

#[test]
fn without_arguments_it_flies_from_preset_two() {
    assert_eq!(
        commands::scene(&fly("lightfall")).unwrap(),
        PRESETS[1].scene(&[]).unwrap()
    );
}

#[test]
fn scene_options_may_precede_the_command_or_follow_it() {
    let expected = {
        let mut scene = PRESETS[2].scene(&[]).unwrap();
        (
            scene.hole.spin,
            scene.method,
            scene.camera.r,
            scene.camera.fov_deg,
        ) = (-0.5, Method::Verlet, 9.0, 40.0);
        scene
    };
    for line in [
        "lightfall --preset 3 --spin -.5 --method verlet --set camera.r=9 --set camera.fov_deg=40 render -o a.png",
        "lightfall render --preset 3 --spin=-0.5 --method verlet --set camera.r=9 --set camera.fov_deg=40 -o a.png",
        "lightfall --set camera.r=8 --preset 3 --set camera.fov_deg=40 render -o a.png --spin -0.5 --method verlet \
         --set camera.r=9",
    ] {
        let Command::Render(render) = read(line) else {
            panic!("{line} renders")
        };
        assert_eq!(commands::scene(&render.scene).unwrap(), expected, "{line}");
        assert_eq!(render.out, Path::new("a.png"));
    }
}

#[test]
fn render_reads_a_size() {
    let Command::Render(render) = read("lightfall render -o a.png --size 1920x1080") else {
        panic!()
    };
    assert_eq!(render.size.unwrap().to_array(), [1920, 1080]);
    for size in [
        "0x5",
        "5",
        "x",
        "axb",
        "32769x1",
        "-1x5",
        "1x2x3",
        "99999999999x1",
        "5x",
    ] {
        let error = refuse(&format!("lightfall render -o a.png --size={size}")).to_string();
        assert!(
            error.contains("a size is WxH, such as 960x540, each from 1 to 32768"),
            "{error}"
        );
    }
}

#[test]
fn trace_uses_the_gpu_by_default() {
    for (line, device) in [
        ("", Device::Gpu),
        (" --device gpu", Device::Gpu),
        (" --device cpu", Device::Cpu),
    ] {
        let Command::Trace(trace) = read(&format!("lightfall trace --rays -{line}")) else {
            panic!()
        };
        assert_eq!(
            (trace.device, trace.rays.as_path()),
            (device, Path::new("-"))
        );
    }
    assert_eq!(
        refuse("lightfall trace").kind(),
        ErrorKind::MissingRequiredArgument
    );
    assert_eq!(
        refuse("lightfall render").kind(),
        ErrorKind::MissingRequiredArgument
    );
    assert_eq!(
        refuse("lightfall trace --rays - --device tpu").kind(),
        ErrorKind::InvalidValue
    );
}

#[test]
fn the_articles_qualities_set_scale_and_budget_of_the_steps() {
    let steps = |line: &str| {
        let quality = commands::scene(&fly(line)).unwrap().quality;
        (quality.step_scale, quality.max_steps)
    };
    for (word, expected) in [
        ("cheap", (1.55, 128)),
        ("balanced", (0.85, 256)),
        ("high", (0.45, 768)),
    ] {
        let line = format!("lightfall --quality {word} --set quality.max_steps=5");
        assert_eq!(steps(&line), expected, "{word}");
    }
    let refused = refuse("lightfall --quality best").to_string();
    assert!(refused.contains("cheap, balanced, high"), "{refused}");
}

#[test]
fn refining_is_a_measurement_of_its_own() {
    for other in [
        "--delay",
        "--light",
        "--medium",
        "--pictures",
        "--frames",
        "--size 9x9",
    ] {
        let refused = refuse(&format!("lightfall bench --refine {other}"));
        assert_eq!(refused.kind(), ErrorKind::ArgumentConflict, "{other}");
    }
}

#[test]
fn measurements_refuse_what_they_do_not_use() {
    for line in [
        "bench --light --rays 64",
        "extremes --hunt 9 --grid",
        "extremes --hunt 9 --delay",
        "bench --medium --scenes 2",
        "bench --medium --light",
        "extremes --medium --methods mino",
        "extremes --medium --grid",
    ] {
        let refused = refuse(&format!("lightfall {line}"));
        assert_eq!(refused.kind(), ErrorKind::ArgumentConflict, "{line}");
    }
    for line in ["", " --delay", " --grid"] {
        let refused = refuse(&format!("lightfall extremes --seed 2{line}")).to_string();
        assert!(refused.contains("--seed belongs to --hunt"), "{refused}");
    }
}

#[test]
fn wrong_values_of_the_short_forms_name_the_short_form() {
    for (line, sentence) in [
        (
            "--spin 1",
            "--spin: hole.spin = 1 is refused: it must be a number above -1 and below 1",
        ),
        (
            "--spin fast",
            "--spin: hole.spin = \"fast\" is refused: it must be a number above -1 and below 1",
        ),
        // The same range for what is no number and for a number that is out of range.
        (
            "--set camera.r=far",
            "--set: camera.r = \"far\" is refused: it must be a number above 0.996984 and at most 10000000 r_s (nothing \
             is at rest in the ergosphere, which reaches this far at hole.spin = 0.9 and camera.theta_deg = 83; observers zamo and \
             rain go deeper)",
        ),
        (
            "--set camera.r=0.3",
            "--set: camera.r = 0.3 is refused: it must be a number above 0.996984 and at most 10000000 r_s (nothing \
             is at rest in the ergosphere, which reaches this far at hole.spin = 0.9 and camera.theta_deg = 83; observers zamo and \
             rain go deeper)",
        ),
        (
            "--method euler",
            "--method: method = \"euler\" is refused: it must be one of auto, verlet, closed, mino, kerr-schild, reference",
        ),
        (
            "--set camera.r",
            "--set: camera.r is not of the form KEY=VALUE, such as camera.r=20",
        ),
    ] {
        assert_eq!(fault(&fly(&format!("lightfall {line}"))), sentence);
    }
}

#[test]
fn shaders_of_a_folder_are_for_flying_only() {
    let Command::Fly(FlyArgs { shaders, .. }) = read("lightfall --shaders mine") else {
        panic!()
    };
    assert_eq!(shaders.unwrap(), Path::new("mine"));
    assert!(
        refuse("lightfall --shaders mine render -o x.png")
            .to_string()
            .contains("--shaders is for flying")
    );
}

#[test]
fn a_journey_is_flown_from_its_file_and_its_faults_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    let Command::Fly(FlyArgs { journey, scene, .. }) =
        read("lightfall --journey mine.toml --spin 0.5")
    else {
        panic!()
    };
    assert_eq!(
        (journey.unwrap(), scene.spin.unwrap().as_str()),
        (Path::new("mine.toml").into(), "0.5")
    );
    assert!(
        refuse("lightfall --journey mine.toml render -o x.png")
            .to_string()
            .contains("--journey needs --frames A..B")
    );
    assert!(
        refuse("lightfall --journey mine.toml doctor")
            .to_string()
            .contains("--journey is for flying")
    );
    assert_eq!(commands::journey(None, &preset()).unwrap().duration, 132.0);
    assert!(
        commands::journey(Some(&file), &preset())
            .unwrap_err()
            .to_string()
            .starts_with(&format!("{}: cannot be read", file.display()))
    );
    fs::write(&file, b"\x89PNG\r\n\x1a\n").unwrap();
    assert_eq!(
        commands::journey(Some(&file), &preset())
            .unwrap_err()
            .to_string(),
        format!(
            "{}: is a picture, and a journey is a TOML text of keyframes",
            file.display()
        )
    );
    fs::write(
        &file,
        "[[keyframe]]\ntime = 0\nr = 3\n[[keyframe]]\ntime = 2\nr = 0",
    )
    .unwrap();
    let error = commands::journey(Some(&file), &preset()).unwrap_err();
    assert_eq!(error.status, 2);
    assert!(
        error.to_string().ends_with(
            "keyframe 2: r = 0 is refused: it must be a number from 0.1 to 10000000 r_s"
        )
    );
    fs::write(
        &file,
        "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 2\nr = 0.9",
    )
    .unwrap();
    let error = commands::journey(Some(&file), &preset()).unwrap_err();
    assert_eq!(error.status, 2);
    let sentence = "keyframe 1 (time = 0): camera.r = 0.9 is refused: it must be a number above 1 and at most 10000000 r_s \
                    (outside the horizon at hole.spin = 0; observer rain goes on inside)";
    assert_eq!(error.to_string(), format!("{}: {sentence}", file.display()));
    fs::write(&file, journey::DEFAULT).unwrap();
    assert_eq!(
        commands::journey(Some(&file), &preset()).unwrap(),
        commands::journey(None, &preset()).unwrap()
    );
}
