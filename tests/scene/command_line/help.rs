//! The texts of `--help`.

use super::{read, refuse};
use lightfall::commands::cli::{self, Command};
use lightfall_core::scene::{MAX_FILE_SIDE, MAX_PICTURE_SIDE};
use lightfall_picture::CHANNELS;

/// The help that a command line asks for.
fn text_of(line: &str) -> String {
    let error = cli::read(line.split(' ')).unwrap_err();
    assert_eq!(error.exit_code(), 0, "{line}");
    error.to_string()
}

#[test]
fn help_and_version_have_exit_status_zero() {
    for line in [
        "lightfall --help",
        "lightfall render -h",
        "lightfall --version",
        "lightfall presets --help",
    ] {
        assert_eq!(
            cli::read(line.split(' ')).unwrap_err().exit_code(),
            0,
            "{line}"
        );
    }
    let help = text_of("lightfall -h");
    let words = "one of auto, verlet, closed, mino, kerr-schild, reference";
    assert!(help.contains("Examples:") && help.contains(words), "{help}");
    let render = text_of("lightfall render -h");
    assert!(
        render.contains(&format!("up to {MAX_FILE_SIDE} a side")),
        "{render}"
    );
    assert_eq!(
        MAX_PICTURE_SIDE,
        wgpu::Limits::default().max_texture_dimension_2d,
        "what every device can do"
    );
}

#[test]
fn a_fault_of_a_commands_options_shows_that_commands_usage() {
    for (line, usage) in [
        (
            "lightfall render --journey none -o x.png",
            "lightfall render",
        ),
        ("lightfall --preset 2 presets list", "lightfall presets"),
    ] {
        let error = refuse(line).to_string();
        assert!(error.contains(&format!("Usage: {usage} ")), "{error}");
    }
}

#[test]
fn help_lists_the_journey_with_the_scene() {
    let help = text_of("lightfall --help");
    let scene = help
        .split("\n\n")
        .find(|part| part.starts_with("Scene:"))
        .unwrap();
    assert!(
        scene.contains("--preset") && scene.contains("--journey") && !scene.contains("--list-gpus"),
        "{scene}"
    );
}

#[test]
fn the_help_of_render_lists_every_channel_with_both_names() {
    let help = text_of("lightfall render --help");
    for channel in CHANNELS {
        let line = help
            .lines()
            .map(str::trim_start)
            .find(|line| line.starts_with(channel.name));
        let mut words = line
            .unwrap_or_else(|| panic!("{}", channel.name))
            .split_whitespace()
            .skip(1);
        assert_eq!(words.next(), Some(channel.old_name), "{}", channel.name);
    }
}

#[test]
fn the_help_of_trace_offers_only_what_concerns_a_ray() {
    let help = text_of("lightfall trace --help");
    for of_pictures in ["--samples", "--cells", "--stars", "--sky"] {
        assert!(!help.contains(of_pictures), "{of_pictures}: {help}");
    }
    // They are read all the same, because scene options may precede any command.
    let Command::Trace(trace) = read("lightfall --samples 4 trace --rays rays.csv") else {
        panic!("it traces")
    };
    assert_eq!(trace.scene.samples.as_deref(), Some("4"));
}
