//! `--preset` and `lightfall presets`.

use super::{answer, fault, fly, of_preset, preset, read, refuse};
use clap::error::ErrorKind;
use lightfall::commands;
use lightfall::commands::cli::{Command, PresetsCommand, SceneArgs};
use lightfall_core::scene::Scene;
use lightfall_core::scene::presets::PRESETS;
use lightfall_platform::storage::Opened;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

#[test]
fn a_preset_is_found_by_number_name_or_path() {
    let file = tempfile::NamedTempFile::new().unwrap();
    fs::write(&file, PRESETS[4].text).unwrap();
    let path = file.path().to_str().unwrap();
    for preset in ["5", "einstein-ring", path] {
        assert_eq!(
            commands::scene(&fly(&format!("lightfall --preset {preset}")))
                .unwrap()
                .name,
            "einstein-ring"
        );
    }
}

#[test]
fn one_preset_given_twice_is_refused() {
    for line in [
        "lightfall --preset 1 render --preset 2 -o a.png",
        "lightfall --spin 0 trace --spin 0 --rays -",
    ] {
        assert_eq!(refuse(line).kind(), ErrorKind::ArgumentConflict);
    }
    for command in ["presets list", "doctor --preset 3", "bench", "extremes"] {
        assert_eq!(
            refuse(&format!("lightfall --preset 2 {command}")).kind(),
            ErrorKind::ArgumentConflict
        );
    }
}

#[test]
fn the_error_about_an_unknown_preset_lists_the_presets() {
    let presets = "1 telescope, 2 edge-on, 3 above, 4 close, 5 einstein-ring, 6 probe, 7 limit, 8 extremal, 9 falling, 10 article, 11 flare, 12 ring, 13 orion, 14 thick, 15 torus, 16 close-thick, 17 lanes, 18 jet";
    for given in ["19", "galaxy", "-1", ""] {
        let sentence =
            format!("--preset {given}: there is no such preset or file; the presets are {presets}");
        assert_eq!(fault(&of_preset(Path::new(given))), sentence);
    }
    // The message names the command that was given, which is not `--preset`.
    let Command::Presets(show) = read("lightfall presets show galaxy") else {
        panic!()
    };
    let error = commands::presets(&show, &mut Vec::new()).unwrap_err();
    assert_eq!(
        error.to_string(),
        format!("presets show galaxy: there is no such preset or file; the presets are {presets}")
    );
    assert_eq!(error.status, 2);
}

#[test]
fn a_misspelled_preset_leads_to_the_one_that_was_meant() {
    for (given, meant) in [
        ("edge_on", "edge-on"),
        ("edgeon", "edge-on"),
        ("Einstein", "einstein-ring"),
        ("extermal", "extremal"),
        ("telescop", "telescope"),
    ] {
        let sentence =
            format!("--preset {given}: there is no such preset or file; did you mean {meant}?");
        assert_eq!(fault(&of_preset(Path::new(given))), sentence);
    }
}

#[test]
fn a_preset_file_that_cannot_be_read_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("my.toml");
    let named = |rest: &str| format!("{}: {rest}", path.display());
    assert_eq!(
        fault(&of_preset(&path)),
        named("cannot be read: there is no such file")
    );
    assert!(fault(&of_preset(folder.path())).ends_with(": cannot be read: it is a folder"));
    for empty in ["", " \n\t\n", "\u{feff}", "# r = 3\n"] {
        fs::write(&path, empty).unwrap();
        let sentence = named("is empty; presets, missions and journeys are short TOML texts");
        assert_eq!(fault(&of_preset(&path)), sentence);
        let journey = commands::journey(Some(&path), &preset()).unwrap_err();
        assert_eq!(journey.to_string(), sentence);
    }
    fs::write(&path, [b'#', 0xff, b'\n']).unwrap();
    assert_eq!(
        fault(&of_preset(&path)),
        named(
            "is not UTF-8 text: line 1 has the byte 0xFF, as in Windows-1252 or Latin-1; save it as UTF-8, in PowerShell with `Get-Content OLD | Set-Content -Encoding utf8 NEW`; presets, missions and journeys are short TOML texts"
        )
    );
    fs::write(&path, vec![b'#'; (1 << 20) + 1]).unwrap();
    assert_eq!(
        fault(&of_preset(&path)),
        named("is longer than 1048576 bytes; presets, missions and journeys are short TOML texts")
    );
    fs::write(&path, "camera.r = 0.5").unwrap();
    let sentence = "line 1: camera.r = 0.5 is refused: it must be a number above 1 and at most 10000000 r_s (outside the \
                    horizon at hole.spin = 0; observer rain goes on inside)";
    assert_eq!(fault(&of_preset(&path)), named(sentence));
}

#[cfg(target_os = "linux")]
#[test]
fn an_endless_preset_file_is_read_only_up_to_the_limit() {
    let sentence = "/dev/zero: is longer than 1048576 bytes; presets, missions and journeys are short TOML texts";
    assert_eq!(fault(&of_preset(Path::new("/dev/zero"))), sentence);
}

#[test]
fn presets_are_listed_with_number_name_and_title() {
    let list = answer("lightfall presets list");
    let lines: Vec<&str> = list.lines().collect();
    assert_eq!(lines.len(), PRESETS.len());
    for (line, preset) in lines.iter().zip(PRESETS) {
        let mut words = line.split_whitespace();
        assert_eq!(words.next(), Some(preset.number.to_string().as_str()));
        assert_eq!(words.next(), Some(preset.name));
        assert!(line.ends_with(&preset.scene(&[]).unwrap().title));
    }
}

#[test]
fn a_shown_preset_is_a_preset_file_of_the_same_scene() {
    let file = tempfile::NamedTempFile::new().unwrap();
    for preset in PRESETS {
        fs::write(
            &file,
            answer(&format!("lightfall presets show {}", preset.name)),
        )
        .unwrap();
        assert_eq!(
            commands::scene(&of_preset(file.path())).unwrap(),
            preset.scene(&[]).unwrap()
        );
        assert_eq!(
            answer(&format!(
                "lightfall presets check {}",
                file.path().display()
            )),
            format!("{}: ok\n", file.path().display())
        );
    }
}

#[test]
fn presets_are_checked_by_number_name_and_path() {
    for preset in ["2", "edge-on", "orion"] {
        let line = format!("lightfall presets check {preset}");
        assert_eq!(answer(&line), format!("{preset}: ok\n"));
    }
    let Command::Presets(check) = read("lightfall presets check edge_on") else {
        panic!()
    };
    assert_eq!(
        commands::presets(&check, &mut Vec::new())
            .unwrap_err()
            .to_string(),
        "presets check edge_on: there is no such preset or file; did you mean edge-on?"
    );
}

#[test]
fn a_wrong_preset_file_does_not_pass_the_check() {
    let file = tempfile::NamedTempFile::new().unwrap();
    fs::write(&file, "hole.spin = 3").unwrap();
    let error = commands::presets(
        &PresetsCommand::Check {
            preset: file.path().into(),
        },
        &mut Vec::new(),
    )
    .unwrap_err();
    assert_eq!(error.status, 2);
    let sentence = "line 1: hole.spin = 3 is refused: it must be a number above -1 and below 1";
    assert_eq!(
        error.to_string(),
        format!("{}: {sentence}", file.path().display())
    );
}

/// A writer that always fails in one way.
struct Fails(io::ErrorKind);

impl Write for Fails {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(self.0.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Err(self.0.into())
    }
}

#[test]
fn a_closed_pipe_is_no_failure_but_a_full_disk_is() {
    assert!(
        commands::presets(&PresetsCommand::List, &mut Fails(io::ErrorKind::BrokenPipe)).is_ok()
    );
    let error = commands::presets(
        &PresetsCommand::List,
        &mut Fails(io::ErrorKind::StorageFull),
    )
    .unwrap_err();
    assert_eq!(error.status, 1);
}

#[test]
fn the_scene_without_options_passes_the_check() {
    assert_eq!(
        commands::scene(&SceneArgs::default()).unwrap().check(),
        Ok(())
    );
    assert_ne!(
        commands::scene(&SceneArgs::default()).unwrap(),
        Scene::default()
    );
}

/// A mission's solution is flown.
#[test]
fn missions_are_checked_by_name_and_path_and_one_that_its_solution_misses_is_refused() {
    let checked = |file: &str| {
        let preset = file.into();
        let mut out = Vec::new();
        commands::presets(&PresetsCommand::Check { preset }, &mut out)
            .map(|()| String::from_utf8(out).unwrap())
            .map_err(|stop| stop.to_string())
    };
    let ok = "ok, a mission; its solution reaches 1 goal with a rapidity of 0.0517\n";
    assert_eq!(checked("two-burns").unwrap(), format!("two-burns: {ok}"));
    let text = fs::read_to_string("assets/missions/two-burns.toml").unwrap();
    let with = |from: &str, to: &str| {
        assert!(text.contains(from));
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(&file, text.replacen(from, to, 1)).unwrap();
        let name = file.path().to_str().unwrap().to_owned();
        checked(&name).map_err(|fault| fault.replace(&name, "FILE"))
    };
    assert!(with("Two burns", "Three burns").unwrap().ends_with(ok));
    let missed = with("E <= 0.9622504486", "E <= 0.97").unwrap_err();
    assert_eq!(missed, "FILE: the solution reaches 0 of 1 goal");
    let unknown = with("brief = ", "brieff = ").unwrap_err();
    assert!(
        unknown.starts_with("FILE: line 11: unknown field `brieff`; did you mean `brief`?"),
        "{unknown}"
    );
    let no_start = with("r = 10.0", "r = 0.5").unwrap_err();
    assert!(
        no_start.contains("the start of the mission is refused"),
        "{no_start}"
    );
    let (without, _) = text.split_once("[[solution]]").unwrap();
    let file = tempfile::NamedTempFile::new().unwrap();
    fs::write(&file, without).unwrap();
    let answer = checked(file.path().to_str().unwrap()).unwrap();
    assert!(
        answer.ends_with("ok, a mission without a solution\n"),
        "{answer}"
    );
}

/// The same sentences as those of the check.
#[test]
fn missions_open_like_presets_and_wrong_ones_are_refused_as_the_check_refuses_them() {
    let text = fs::read_to_string("assets/missions/graze.toml").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    let opened = |args: &SceneArgs| commands::opened(args).unwrap().into_parts();
    fs::write(&file, &text).unwrap();
    for given in [Path::new("graze"), &file] {
        let (scene, mission) = opened(&of_preset(given));
        assert_eq!(mission.unwrap().name, "graze");
        assert_eq!((scene.camera.r, scene.hole.spin), (20.0, 0.0));
        // What needs a preset says how a mission is flown.
        let given = given.display();
        assert_eq!(
            fault(&of_preset(Path::new(&given.to_string()))),
            format!(
                "{given}: is a mission and not a preset; `lightfall --preset {given}` flies it"
            )
        );
    }
    // A preset is none.
    assert!(opened(&of_preset(Path::new("close"))).1.is_none());
    // Other fields may be set, but not those of the start.
    let (scene, mission) = opened(&fly(
        "lightfall --preset graze --set camera.fov_deg=90 --cells off",
    ));
    assert_eq!((scene.camera.fov_deg, scene.picture.bypass), (90.0, true));
    assert_eq!(mission.unwrap().scene(), &scene);
    let refused = |line: &str| commands::opened(&fly(line)).unwrap_err().to_string();
    assert_eq!(
        refused("lightfall --preset graze --spin 0.5"),
        "--spin: hole.spin is refused: the mission \"Graze the photon sphere\" sets it"
    );
    assert!(refused("lightfall --preset graze --set sky.mode=none").starts_with("--set: sky.mode"));

    for (from, to, sentence) in [
        ("brief = ", "brieff = ", "unknown field `brieff`"),
        ("r = 20.0", "r = 0.5", "the start of the mission is refused"),
        ("spin = 0.0", "spin = 0.5", "verlet"),
    ] {
        assert!(text.contains(from), "{from}");
        let wrong = text.replacen(from, to, 1);
        // A preset whose method traces no spin.
        let preset = "preset = \"article\"";
        let wrong = match text.lines().find(|line| line.starts_with("preset = ")) {
            Some(line) if sentence == "verlet" => wrong.replacen(line, preset, 1),
            _ => wrong,
        };
        fs::write(&file, wrong).unwrap();
        let check = PresetsCommand::Check {
            preset: file.clone().into(),
        };
        let checked = commands::presets(&check, &mut Vec::new()).unwrap_err();
        let opened = commands::opened(&of_preset(&file)).unwrap_err();
        assert_eq!(opened, checked);
        assert_eq!(opened.status, 2);
        let opened = opened.to_string();
        assert!(
            opened.starts_with(&file.display().to_string()) && opened.contains(sentence),
            "{opened}"
        );
    }
}

/// A journey is flown in its preset, with what its stops switch.
#[test]
fn journeys_are_checked_by_name_and_path_and_one_whose_stop_cannot_be_drawn_is_refused() {
    let checked = |file: &str| {
        let preset = file.into();
        let mut out = Vec::new();
        commands::presets(&PresetsCommand::Check { preset }, &mut out)
            .map(|()| String::from_utf8(out).unwrap())
            .map_err(|stop| stop.to_string())
    };
    let shadow = "ok, a journey of 11 s with 7 stops\n";
    assert_eq!(checked("shadow").unwrap(), format!("shadow: {shadow}"));
    let default = "assets/journeys/default.toml";
    assert_eq!(
        checked(default).unwrap(),
        format!("{default}: ok, a journey of 132 s\n")
    );
    let text = fs::read_to_string("assets/journeys/shadow.toml").unwrap();
    let with = |from: &str, to: &str| {
        assert!(text.contains(from));
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(&file, text.replacen(from, to, 1)).unwrap();
        let name = file.path().to_str().unwrap().to_owned();
        checked(&name).map_err(|fault| fault.replace(&name, "FILE"))
    };
    assert!(
        with("What is the shadow?", "The shadow")
            .unwrap()
            .ends_with(shadow)
    );
    let unknown = with("effects.lensing = false", "effects.lens = false").unwrap_err();
    let line = 1 + text
        .lines()
        .position(|line| line == "effects.lensing = false")
        .unwrap();
    let start = format!("FILE: line {line}: stop 3: there is no effects.lens; ");
    assert!(unknown.starts_with(&start), "{unknown}");
    let undrawable = with(
        "effects.lensing = false",
        "disk.inner = 20.0\ndisk.outer = 12.0",
    )
    .unwrap_err();
    assert!(undrawable.starts_with("FILE: "), "{undrawable}");
    assert!(undrawable.contains("disk.outer"), "{undrawable}");
}

/// A lesson is recognized by its tables, as a mission is; what needs a preset says how a lesson is flown.
#[test]
fn lessons_open_like_missions_and_where_a_preset_is_needed_they_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    fs::copy("assets/journeys/shadow.toml", &file).unwrap();
    for given in [Path::new("shadow"), file.as_path()] {
        let opened = commands::opened(&of_preset(given)).unwrap();
        let Opened::Journey(lesson) = opened else {
            panic!("{opened:?}")
        };
        assert_eq!(lesson.title, "What is the shadow?");
        let refused = commands::scene(&of_preset(given)).unwrap_err();
        let given = given.display();
        assert_eq!(
            refused.to_string(),
            format!(
                "{given}: this is a journey or a lesson, not a preset; fly it with `lightfall --journey {given}`"
            )
        );
    }
    // A wrong one is named by its line, and not by fields of presets that have similar names.
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replacen("ending = ", "endig = ", 1)).unwrap();
    let refused = commands::opened(&of_preset(&file)).unwrap_err().to_string();
    let line = 1 + text
        .lines()
        .position(|line| line.starts_with("ending"))
        .unwrap();
    let start = format!("{}: line {line}: endig = ", file.display());
    assert!(refused.starts_with(&start), "{refused}");
}

/// The check tells all faults of a lesson, each in a line.
#[test]
fn the_check_of_a_lesson_tells_all_of_its_faults() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let name = file.path().display().to_string();
    let text = "[[keyframe]]\ntime = 0\n[[keyframe]]\ntime = 2\n[[stop]]\nat = 0\nguides = \"on\"\n[[stop]]\nat = 3\n";
    fs::write(&file, text).unwrap();
    let check = PresetsCommand::Check {
        preset: file.path().into(),
    };
    let refused = commands::presets(&check, &mut Vec::new()).unwrap_err();
    assert_eq!(refused.status, 2);
    let sentence = refused.to_string();
    let lines: Vec<&str> = sentence.lines().collect();
    assert_eq!(lines.len(), 2, "{sentence}");
    for (line, (number, stop)) in lines.iter().zip([(7, 1), (9, 2)]) {
        let start = format!("{name}: line {number}: stop {stop}: ");
        assert!(line.starts_with(&start), "{line}");
    }
}
