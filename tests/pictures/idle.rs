//! Fields of every preset, each changed by itself: where the scene says that the field changes
//! nothing, the picture is the same to the byte.

use glam::UVec2;
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{FIELDS, Field, Kind, Output, Scene, Value};
use lightfall_picture::{Studio, filled};

const SIZE: UVec2 = UVec2::new(64, 36);

/// The usual run changes every fourth field of a preset, so that each field is changed in at least three
/// presets. With this variable it changes every field of every preset.
const EVERY_FIELD: &str = "LIGHTFALL_EVERY_FIELD";
const SHARE: usize = 4;

/// Other values of a field: the ends of its range as far as they are finite, or other words.
fn other_values(scene: &Scene, field: &Field) -> Vec<Value> {
    let own = field.get(scene);
    let values = match (field.kind, &own) {
        (Kind::Boolean, Value::Boolean(on)) => vec![Value::Boolean(!on)],
        // The first of these that the scene allows is tried.
        (Kind::Float(_), Value::Float(own)) => [own * 2.0, own * 0.5, own + 0.25]
            .map(Value::Float)
            .to_vec(),
        (Kind::Integer(_), Value::Integer(own)) => [own * 2, own / 2].map(Value::Integer).to_vec(),
        (Kind::Choice(choices), _) => choices
            .iter()
            .map(|choice| Value::Word(choice.word))
            .collect(),
        (Kind::Velocity, _) => vec![Value::Velocity([0.1, 0.0, 0.2])],
        (Kind::Pair, _) => vec![Value::Pair([0.1, 0.2])],
        _ => vec![Value::Text("another".into())],
    };
    values.into_iter().filter(|value| *value != own).collect()
}

fn picture(studio: &mut Studio, scene: &Scene) -> Vec<u8> {
    studio.show(&filled(scene)).unwrap();
    studio.settle().unwrap();
    studio.picture().unwrap().rgb
}

/// Changes every field of a preset, and counts the changes that show, those that the scene explains,
/// and those that are too small for this picture.
fn change_every_field(number: usize) -> [u32; 3] {
    let mut scene = crate::preset(number);
    (scene.picture.width, scene.picture.height) = SIZE.into();
    (scene.picture.grid_width, scene.picture.grid_height) = SIZE.into();
    scene.picture.samples = 1;
    let mut studio = Studio::open(&filled(&scene), SIZE).unwrap();
    let plain = picture(&mut studio, &scene);
    let mut counts = [0; 3];
    let every = std::env::var_os(EVERY_FIELD).is_some();
    let fields = FIELDS.iter().enumerate();
    let chosen = fields.filter(|(index, _)| every || index % SHARE == number % SHARE);
    for (_, field) in chosen {
        let is_choice = matches!(field.kind, Kind::Choice(_));
        let mut tried = 0;
        for value in other_values(&scene, field) {
            let Ok(changed) = scene.with([(field.key, value.clone())]) else {
                continue;
            };
            if tried > 0 && !is_choice || studio.show(&filled(&changed)).is_err() {
                continue;
            }
            tried += 1;
            let idle = changed.idle_value(field.key, Output::Still);
            let differs = picture(&mut studio, &changed) != plain;
            assert!(
                !(differs && idle.is_some() && scene.idle(field.key, Output::Still).is_some()),
                "preset {number}: {} = {value} changes the picture, and the scene says {idle:?}",
                field.key
            );
            match (differs, idle.is_some()) {
                (true, _) => counts[0] += 1,
                (false, true) => counts[1] += 1,
                (false, false) => {
                    println!("preset {number}: {} = {value} is too small", field.key);
                    counts[2] += 1;
                }
            }
        }
    }
    counts
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_field_that_is_said_to_change_nothing_changes_no_pixel() {
    for preset in PRESETS {
        let began = std::time::Instant::now();
        let [shown, explained, small] = change_every_field(preset.number);
        println!(
            "preset {}: {shown} changes show, {explained} are explained, {small} are too small, {:.1} s",
            preset.name,
            began.elapsed().as_secs_f64()
        );
        assert!(
            shown > 4 && explained > 3,
            "{}: {shown}, {explained}",
            preset.name
        );
    }
}
