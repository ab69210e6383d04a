//! The command line that the window copies: a shell and the program read it back as the same scene.

use lightfall::app::command_line;
use lightfall::commands::cli::{self, Command};
use lightfall::commands::scene;
use lightfall_core::scene::Scene;
use lightfall_core::scene::presets::{PRESETS, find};

/// The scene that a command line opens.
fn opened(line: &str) -> Scene {
    let Command::Fly(args) = cli::read(shlex::split(line).unwrap()).unwrap() else {
        panic!("{line} does not fly")
    };
    scene(&args.scene).unwrap()
}

#[test]
fn a_presets_command_line_is_its_name() {
    for preset in PRESETS {
        let line = command_line(preset.plain_scene());
        assert_eq!(line, format!("lightfall --preset {}", preset.name));
        assert_eq!(opened(&line), *preset.plain_scene());
    }
}

#[test]
fn a_copied_command_line_opens_the_same_scene() {
    let mut scene = find("close").unwrap().plain_scene().clone();
    scene.name = "my-place".into();
    scene.title = "It's a \"place\" of $mine `here` \\ there; and = it".into();
    scene.hole.spin = -0.3;
    scene.observer.velocity = [0.1, -0.2, 0.3];
    scene.effects.doppler = false;
    assert_eq!(opened(&command_line(&scene)), scene);
}
