//! The lessons of docs/TEACHING.md: their presets can be drawn, and the numbers on the page are those
//! of its command lines.

use crate::program::program_with;
use lightfall::commands;
use lightfall::commands::cli::SceneArgs;
use lightfall_core::gpu::Drawable;
use std::fs;
use std::path::{Path, PathBuf};

const PAGE: &str = include_str!("../../docs/TEACHING.md");

fn lessons() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons");
    let files = fs::read_dir(folder).unwrap();
    let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    files.sort();
    files
}

#[test]
fn every_lesson_is_a_preset_that_can_be_drawn_and_is_on_the_page() {
    let lessons = lessons();
    for file in &lessons {
        let args = SceneArgs {
            preset: Some(file.into()),
            ..SceneArgs::default()
        };
        let scene = commands::scene(&args).unwrap();
        assert_eq!(file.file_stem(), Some(scene.name.as_ref()));
        assert!(
            PAGE.contains(&format!("`{}`", scene.name)),
            "{}",
            scene.name
        );
        Drawable::new(scene).unwrap();
    }
    // The page shows no other.
    let shown = PAGE.matches("`lesson-").count();
    assert!(shown >= lessons.len(), "{shown} of {}", lessons.len());
}

/// The rays of the page, each with the rest of its command line.
fn command_lines() -> impl Iterator<Item = (&'static str, &'static str)> {
    let lines = PAGE
        .lines()
        .filter_map(|line| line.strip_prefix("    echo "));
    lines.map(|line| line.split_once(" | lightfall ").unwrap())
}

#[test]
fn the_numbers_of_the_lessons_are_those_of_their_command_lines() {
    // The lessons lie where the page says: in the folder of the download.
    let folder = tempfile::tempdir().unwrap();
    let unpacked = folder.path().join("lessons");
    fs::create_dir_all(&unpacked).unwrap();
    for file in lessons() {
        fs::copy(&file, unpacked.join(file.file_name().unwrap())).unwrap();
    }
    let answers: Vec<String> = command_lines()
        .map(|(ray, line)| {
            let home = [("XDG_CONFIG_HOME", folder.path()), ("HOME", folder.path())];
            let (status, out, err) = program_with(&home, folder.path(), line, ray);
            assert_eq!(status, 0, "{line}: {err}");
            out.lines().nth(1).unwrap().to_owned()
        })
        .collect();
    let [above, inside, outside, weak] = &answers[..] else {
        panic!("{} command lines", answers.len())
    };
    let numbers = |answer: &str| -> Vec<f64> {
        let fields = answer.split(',').skip(1);
        fields
            .map(|field| field.parse().unwrap_or(f64::NAN))
            .collect()
    };
    let [r, g] = [numbers(above)[3], numbers(above)[5]];
    assert!(
        PAGE.contains(&format!("`hit1_r` = {r:.5} with `hit1_g` = {g:.6}")),
        "{above}"
    );
    let formula = (1.0 - 1.5 / r).sqrt() / (1.0_f64 - 1.0 / 20.0).sqrt();
    assert!((g - formula).abs() < 1e-12, "{g} {formula}");
    assert!(inside.starts_with("captured") && outside.starts_with("sky"));
    let [x, y] = [numbers(weak)[0], numbers(weak)[1]];
    assert!(PAGE.contains(&format!("({x:.6}, {y:.6}, 0)")), "{weak}");
    let (turned, b) = (y.abs().atan2(-x) + 5e-5, 50.0_f64);
    let pi = std::f64::consts::PI;
    let series = 2.0 / b
        + 15.0 * pi / (16.0 * b.powi(2))
        + 16.0 / (3.0 * b.powi(3))
        + 3465.0 * pi / (1024.0 * b.powi(4));
    // The series goes on with terms below 1e-7 here.
    assert!((turned - series).abs() < 2e-7, "{turned} {series}");
    assert!(PAGE.contains(&format!("{series:.5}")) && PAGE.contains(&format!("{turned:.5}")));
}
