//! The command lines of camera paths and subtitles.

use super::{read, refuse};
use lightfall::commands::cli::Command;
use std::path::PathBuf;

#[test]
fn options_of_the_scene_and_the_journey_may_precede_the_command_camera() {
    let Command::Camera(camera) =
        read("lightfall --journey a.csv --preset 3 camera --frames 0..9 --spin 0.5 -o b.usda")
    else {
        panic!()
    };
    assert_eq!(
        (camera.journey, camera.out, camera.fps),
        (Some(PathBuf::from("a.csv")), "b.usda".into(), 30.0)
    );
    assert_eq!(
        (camera.scene.preset, camera.scene.spin),
        (Some("3".into()), Some("0.5".into()))
    );
    let twice = refuse("lightfall --journey a.csv camera --journey b.csv --frames 0..9 -o c.csv");
    assert!(twice.to_string().contains("--journey may be given once"));
    let scene = refuse("lightfall --preset 2 captions -o a.srt");
    assert!(
        scene
            .to_string()
            .contains("`captions` takes no scene options")
    );
    let still = refuse("lightfall render --camera a.csv -o a.png");
    assert!(still.to_string().contains("--frames"));
    let Command::Render(render) =
        read("lightfall render --frames 0..9 --camera a.csv --camera a.usda -o a.png")
    else {
        panic!()
    };
    assert_eq!(
        render.camera,
        [PathBuf::from("a.csv"), PathBuf::from("a.usda")]
    );
}
