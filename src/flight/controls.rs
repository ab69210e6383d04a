//! The key table: what each key does to the scene. The handler and the hint on the screen both read it.

use crate::gpu::GpuScene;
use crate::render::CurrentScene;
use crate::scene::{Method, Scene, SkyMode, View, presets};
use bevy::prelude::*;
use bevy_egui::input::egui_wants_any_keyboard_input;

/// One key of the table.
pub struct Key {
    /// The physical key.
    pub code: KeyCode,
    /// Its name, as printed on it.
    pub name: &'static str,
    /// What it does, in a word or two; keys with the same words are one entry of the hint.
    pub does: &'static str,
    /// The change of the scene.
    pub edit: fn(&mut Scene),
}

/// Every key that changes the scene. Those that move the camera are in `pilot.rs`.
pub const KEYS: &[Key] = &[
    Key { code: KeyCode::Digit1, name: "1", does: PRESETS, edit: |scene| preset(scene, 1) },
    Key { code: KeyCode::Digit2, name: "2", does: PRESETS, edit: |scene| preset(scene, 2) },
    Key { code: KeyCode::Digit3, name: "3", does: PRESETS, edit: |scene| preset(scene, 3) },
    Key { code: KeyCode::Digit4, name: "4", does: PRESETS, edit: |scene| preset(scene, 4) },
    Key { code: KeyCode::Digit5, name: "5", does: PRESETS, edit: |scene| preset(scene, 5) },
    Key { code: KeyCode::Digit6, name: "6", does: PRESETS, edit: |scene| preset(scene, 6) },
    Key { code: KeyCode::Digit7, name: "7", does: PRESETS, edit: |scene| preset(scene, 7) },
    Key { code: KeyCode::Digit8, name: "8", does: PRESETS, edit: |scene| preset(scene, 8) },
    Key { code: KeyCode::Digit9, name: "9", does: PRESETS, edit: |scene| preset(scene, 9) },
    Key { code: KeyCode::F2, name: "F2", does: "disk", edit: |scene| scene.disk.enabled = !scene.disk.enabled },
    Key { code: KeyCode::F7, name: "F7", does: "cells", edit: |scene| scene.picture.bypass = !scene.picture.bypass },
    Key { code: KeyCode::F11, name: "F11", does: "unfinished rays", edit: |scene| toggle(scene, View::Unfinished) },
    Key { code: KeyCode::KeyG, name: "G", does: "sky", edit: cycle_sky },
    Key { code: KeyCode::KeyT, name: "T", does: "spin", edit: toggle_spin },
    Key { code: KeyCode::KeyU, name: "U", does: "disk from the ISCO", edit: |scene| flip(&mut scene.disk.follow_isco) },
    Key { code: KeyCode::KeyL, name: "L", does: EFFECTS, edit: |scene| flip(&mut scene.effects.lensing) },
    Key { code: KeyCode::KeyZ, name: "Z", does: EFFECTS, edit: |scene| flip(&mut scene.effects.doppler) },
    Key { code: KeyCode::KeyX, name: "X", does: EFFECTS, edit: |scene| flip(&mut scene.effects.beaming) },
    Key { code: KeyCode::KeyC, name: "C", does: EFFECTS, edit: |scene| flip(&mut scene.effects.gravitational_shift) },
    Key { code: KeyCode::KeyB, name: "B", does: VIEWS, edit: |scene| toggle(scene, View::Classes) },
    Key { code: KeyCode::KeyM, name: "M", does: VIEWS, edit: |scene| toggle(scene, View::Residual) },
    Key { code: KeyCode::KeyN, name: "N", does: VIEWS, edit: |scene| toggle(scene, View::Order) },
    Key { code: KeyCode::KeyR, name: "R", does: VIEWS, edit: |scene| toggle(scene, View::Redshift) },
];

const PRESETS: &str = "presets";
const EFFECTS: &str = "effects";
const VIEWS: &str = "views";

fn preset(scene: &mut Scene, number: usize) {
    let preset = presets::PRESETS.iter().find(|preset| preset.number == number);
    // A built-in preset without overrides always loads; a test says so.
    if let Some(Ok(preset)) = preset.map(|preset| preset.scene(&[])) {
        *scene = preset;
    }
}

fn flip(switch: &mut bool) {
    *switch = !*switch;
}

/// Spin that T switches on.
const SPIN: f64 = 0.9;

fn toggle_spin(scene: &mut Scene) {
    scene.hole.spin = if scene.hole.spin == 0.0 { SPIN } else { 0.0 };
    // Some methods know no spin.
    if matches!(scene.method, Method::Verlet | Method::Closed) {
        scene.method = Method::Auto;
    }
}

/// Shows a view, or the light again where that view is shown already.
fn toggle(scene: &mut Scene, view: View) {
    scene.view = if scene.view == view { View::Colour } else { view };
}

fn cycle_sky(scene: &mut Scene) {
    scene.sky.mode = match scene.sky.mode {
        SkyMode::Stars => SkyMode::Grid,
        SkyMode::Grid => SkyMode::Off,
        SkyMode::Off => SkyMode::Stars,
    };
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Notice>()
        .add_systems(PreUpdate, apply.run_if(not(egui_wants_any_keyboard_input)).after(bevy::input::InputSystems));
}

/// Why the last key was refused; empty when it was not.
#[derive(Resource, Default)]
pub(super) struct Notice(pub(super) String);

/// What a key makes of a scene, if such a scene can be drawn.
///
/// # Errors
/// Why it cannot, in one sentence.
pub fn pressed(key: &Key, scene: &Scene) -> Result<Scene, String> {
    let mut changed = scene.clone();
    (key.edit)(&mut changed);
    changed.check().map_err(|refusal| refusal.to_string())?;
    let size = UVec2::new(changed.picture.width, changed.picture.height);
    GpuScene::new(&changed, size).map_err(|error| error.to_string())?;
    Ok(changed)
}

fn apply(keys: Res<ButtonInput<KeyCode>>, mut scene: ResMut<CurrentScene>, mut notice: ResMut<Notice>) {
    // Alt+F-keys and the like belong to the desktop.
    if keys.any_pressed([KeyCode::AltLeft, KeyCode::AltRight, KeyCode::SuperLeft, KeyCode::SuperRight]) {
        return;
    }
    for key in KEYS {
        if keys.just_pressed(key.code) {
            match pressed(key, &scene) {
                Ok(changed) => (scene.0, notice.0) = (changed, String::new()),
                Err(reason) => notice.0 = format!("{}: {reason}", key.name),
            }
        }
    }
}
