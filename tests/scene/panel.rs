//! The panel's page of the scene: every field has its words, and a row that is dimmed says why.

use lightfall::app::{SECTIONS, Shown};
use lightfall_core::scene::{
    DiskStructure, FIELDS, HotSpotKind, Kind, Method, Output, Scene, SkyMode, View,
};
use lightfall_core::words::Choice;
use std::collections::BTreeSet;

/// The fields that leave the user no choice.
const FIXED: [&str; 1] = ["schema"];

#[test]
fn every_field_has_one_row_with_a_label_of_its_own() {
    let mut listed = BTreeSet::new();
    for section in SECTIONS {
        let mut labels = BTreeSet::new();
        for row in section.rows {
            assert!(
                FIELDS.iter().any(|field| field.key == row.key),
                "{} is no field",
                row.key
            );
            assert!(listed.insert(row.key), "{} has two rows", row.key);
            assert!(
                labels.insert(row.label),
                "two rows are called {}",
                row.label
            );
            // A label is a few words and no name of a field.
            assert!(row.label.starts_with(char::is_uppercase), "{}", row.label);
            assert!(
                row.label.len() <= 20 && !row.label.contains('_'),
                "{}",
                row.label
            );
        }
    }
    for field in FIELDS.iter() {
        assert_ne!(
            listed.contains(field.key),
            FIXED.contains(&field.key),
            "{} needs a row in src/app/controls/sections.rs",
            field.key
        );
    }
}

#[test]
fn every_choice_has_a_name_and_a_meaning() {
    for field in FIELDS.iter() {
        let Kind::Choice(choices) = field.kind else {
            continue;
        };
        let names: BTreeSet<_> = choices.iter().map(|choice| choice.name).collect();
        assert_eq!(names.len(), choices.len(), "{}: {names:?}", field.key);
        for Choice {
            word,
            name,
            meaning,
        } in choices
        {
            assert!(
                name.starts_with(char::is_uppercase) && !meaning.is_empty(),
                "{} = {word} needs a name beside its word",
                field.key
            );
        }
    }
}

#[test]
fn sliders_reach_the_default_of_their_field() {
    let scene = Scene::default();
    for row in SECTIONS.iter().flat_map(|section| section.rows) {
        let (Shown::Linear(low, high) | Shown::Logarithmic(low, high)) = row.shown else {
            continue;
        };
        let field = FIELDS.iter().find(|field| field.key == row.key).unwrap();
        let value = field.get(&scene).number().unwrap();
        assert!((low..=high).contains(&value), "{} = {value}", row.key);
        let logarithmic = matches!(row.shown, Shown::Logarithmic(..));
        assert!(!logarithmic || low > 0.0, "{}", row.key);
    }
    let distance = SECTIONS[0].rows[0].shown;
    assert!(matches!(distance, Shown::Logarithmic(..)));
}

/// The fields that are dimmed in one scene and not in another.
fn dimmed_between(idle: &Scene, other: &Scene) -> Vec<&'static str> {
    FIELDS
        .iter()
        .map(|field| field.key)
        .filter(|key| {
            idle.idle(key, Output::Window).is_some() && other.idle(key, Output::Window).is_none()
        })
        .collect()
}

#[test]
fn rows_are_dimmed_where_they_change_nothing() {
    let mut lit = Scene::default();
    lit.picture.bypass = false;
    let with = |change: fn(&mut Scene)| {
        let mut scene = lit.clone();
        change(&mut scene);
        scene
    };
    let dark = with(|scene| scene.disk.enabled = false);
    let dimmed = dimmed_between(&dark, &lit);
    assert!(dimmed.contains(&"disk.temperature_k") && dimmed.contains(&"disk.inner"));
    assert!(!dimmed.contains(&"disk.enabled"), "it brings the disk back");

    let plain = with(|scene| scene.picture.bypass = true);
    assert_eq!(
        dimmed_between(&plain, &lit),
        ["picture.grid_height", "picture.levels", "picture.dither"]
    );
    let grid = with(|scene| scene.sky.mode = SkyMode::Grid);
    let of_stars = [
        "sky.seed",
        "sky.ra_deg",
        "sky.dec_deg",
        "sky.roll_deg",
        "sky.magnitude_limit",
    ];
    assert_eq!(dimmed_between(&grid, &lit), of_stars);
    let procedural = with(|scene| scene.sky.mode = SkyMode::Procedural);
    assert_eq!(dimmed_between(&procedural, &lit), of_stars[1..]);
    let picture = with(|scene| scene.sky.mode = SkyMode::Picture);
    let of_picture = ["sky.picture", "sky.frame", "sky.mirror", "sky.stars"];
    assert_eq!(dimmed_between(&lit, &picture), of_picture);
    let of_points = ["sky.seed", "sky.magnitude_limit"];
    assert_eq!(dimmed_between(&picture, &lit), of_points);
    let isco = with(|scene| scene.disk.follow_isco = true);
    assert_eq!(dimmed_between(&isco, &lit), ["disk.inner"]);
    let order = with(|scene| scene.view = View::Order);
    assert!(dimmed_between(&order, &lit).contains(&"effects.doppler"));
    let turbulent = with(|scene| scene.disk.structure = DiskStructure::Turbulent);
    let spot = with(|scene| scene.hot_spot.kind = HotSpotKind::Rigid);
    let structure = [
        "disk.contrast",
        "disk.scale",
        "disk.aspect",
        "disk.pitch_deg",
        "disk.lifetime",
        "disk.period",
        "disk.waves",
        "disk.seed",
    ];
    let clock = ["disk.time", "disk.rate"];
    assert_eq!(
        dimmed_between(&lit, &turbulent),
        [&structure[..], &clock].concat()
    );
    let of_spot = dimmed_between(&lit, &spot);
    assert_eq!(of_spot[..2], clock);
    assert_eq!(of_spot.len(), 2 + 6, "{of_spot:?}");
    assert_eq!(dimmed_between(&spot, &turbulent), structure);
    // The two settings of accuracy belong to different methods.
    let mino = with(|scene| scene.method = Method::Mino);
    let verlet = with(|scene| scene.method = Method::Verlet);
    assert_eq!(dimmed_between(&verlet, &mino), ["quality.max_error_px"]);
    assert_eq!(
        dimmed_between(&mino, &verlet),
        [
            "quality.step_scale",
            "quality.max_steps",
            "quality.max_affine",
            "quality.escape_radius",
            "quality.min_step"
        ]
    );
    let many_steps = with(|scene| {
        scene.method = Method::Verlet;
        scene.quality.max_steps = 769;
    });
    assert_eq!(dimmed_between(&many_steps, &verlet), ["picture.antialias"]);
}
