//! Values that are given by name and change nothing: the program says so, why, and what would help.

use crate::program::program;
use std::fs;

/// What the program says to a command line that it obeys, without what it says about the machine.
fn remarks(line: &str, files: &[(&str, &str)]) -> String {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    let (status, _, stderr) = program(folder.path(), line, "0,-0.1,1\n");
    assert_eq!(status, 0, "{line}: {stderr}");
    let lines = stderr.lines().filter(|line| line.contains("chang"));
    lines.map(|line| format!("{line}\n")).collect()
}

/// Renders preset 2, which follows the innermost stable orbit, in a few pixels.
fn render(options: &str, files: &[(&str, &str)]) -> String {
    remarks(&format!("render --preset 2 --size 64x36 {options}"), files)
}

#[test]
#[ignore = "needs a graphics adapter"]
fn an_option_that_changes_nothing_is_named_with_the_reason() {
    for (options, remark) in [
        (
            "-o a.png --set disk.inner=4.6",
            "--set disk.inner=4.6 changes nothing: the disk begins at the innermost stable orbit; --set disk.follow_isco=false uses it",
        ),
        (
            "-o a.png --set disk.rate=2",
            "--set disk.rate=2 changes nothing: a single picture shows one moment",
        ),
        (
            "-o a.png --quality cheap",
            "--quality cheap changes nothing: only the methods that take steps use it: Verlet and Kerr-Schild; --set method=kerr-schild uses it",
        ),
        (
            "-o a.png --set picture.exposure_ev=9 --set picture.automatic_exposure=true",
            "--set picture.exposure_ev=9 changes nothing: the light meter chooses the exposure; --set picture.automatic_exposure=false uses it",
        ),
        (
            "-o a.exr --cells off",
            "--cells off changes nothing: linear light is written as it is, before exposure, curve and cells",
        ),
        (
            "-o a.png --spin 0.9 --set hole.spin=0.5",
            "--set hole.spin=0.5 changes nothing: --spin 0.9 comes after it",
        ),
        (
            "-o a.png --set probe.enabled=true",
            "--set probe.enabled=true changes no pixel of this picture; what it sets may be hidden, out of view, too small to be seen, or without effect beside other values",
        ),
        (
            "-o a.png --set camera.phi_deg=-360",
            "--set camera.phi_deg=-360 changes nothing: the scene has the same angle without it, but for whole turns",
        ),
        (
            "-o a.png --set disk.waves=25",
            "--set disk.waves=25 changes nothing: the number of waves is rounded down to a multiple of four",
        ),
        (
            "-o a.png --set picture.width=300",
            "--set picture.width=300 changes nothing: --size decides it",
        ),
        (
            "-o a-#.png --frames 30..31 --set camera.r=9 --set disk.rate=9",
            "--set camera.r=9 changes nothing: the journey decides it; --journey none keeps the camera where the scene has it",
        ),
    ] {
        let said = render(options, &[]);
        assert!(
            said.starts_with(&format!("lightfall: {remark}\n")),
            "{options}: {said}"
        );
    }
    assert_eq!(
        render("-o a.png --set camera.r=12 --set disk.outer=9", &[]),
        ""
    );
}

#[test]
#[ignore = "needs a graphics adapter"]
fn values_of_presets_journeys_and_traces_that_change_nothing_are_named() {
    let preset = [(
        "mine.toml",
        "[disk]\nenabled = false\ntemperature_k = 5e3\nlimb = \"none\"\n[camera]\nphi_deg = 360",
    )];
    let check = remarks("presets check mine.toml", &preset);
    assert_eq!(
        check,
        "lightfall: mine.toml: camera.phi_deg = 360.0 changes nothing: the scene has the same angle without it, but for whole turns\n\
         lightfall: mine.toml: disk.temperature_k = 5000.0 changes nothing: the disk is off; disk.enabled=true uses it\n"
    );
    let rays = remarks(
        "trace --rays - --device cpu --set sky.brightness=2 --spin 0.5",
        &[],
    );
    assert_eq!(
        rays,
        "lightfall: --set sky.brightness=2 changes nothing: traced rays carry no light\n"
    );
    let journey =
        "[[keyframe]]\ntime = 0\ndisk_node_deg = 10\nr = 20\n[[keyframe]]\ntime = 5\nr = 10\n";
    // Around a hole that spins a tilt alone would be refused.
    for (spin, reason) in [
        (
            "0.5",
            "around a hole that spins the disk lies in the equator; hole.spin=0 with disk.tilt_deg=30 uses it",
        ),
        (
            "0",
            "the disk is not tilted; --set disk.tilt_deg=30 uses it",
        ),
    ] {
        let line = format!("-o a-#.png --frames 0..1 --journey tilt.toml --spin {spin}");
        assert_eq!(
            render(&line, &[("tilt.toml", journey)]),
            format!("lightfall: tilt.toml: disk_node_deg changes nothing: {reason}\n")
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_dark_scene_is_named_before_it_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    for (dark, remedy) in [
        (
            "--set disk.enabled=false --set sky.mode=off",
            "--set disk.enabled=true or --set sky.mode=stars",
        ),
        (
            "--set disk.brightness=0 --set sky.brightness=0",
            "--set disk.brightness=1 or --set sky.brightness=1",
        ),
    ] {
        let line = format!("render --size 32x18 -o a.png {dark}");
        let (status, _, stderr) = program(folder.path(), &line, "");
        assert_eq!(status, 0);
        let sentence = format!("nothing shines in this scene; {remedy} brings light");
        assert!(stderr.contains(&sentence), "{stderr}");
    }
}
