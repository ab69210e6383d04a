//! What single keys make of a scene. Switches that are more than on and off come back to what was
//! loaded.

use lightfall_core::gpu::Drawable;
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::scene::{Method, ObserverKind, Picture, Scene, SkyMode, View, presets};

use crate::app::controls::table::{Action, Control};

/// Spin that is switched on where the scene was loaded without.
const SPIN: f64 = 0.9;
/// As many levels as eight bits can tell.
pub(crate) const ALL_LEVELS: u32 = 256;
/// The kinds of observer, in the order of their key.
pub(crate) const OBSERVERS: [ObserverKind; ObserverKind::ALL.len()] = ObserverKind::ALL;
/// One press of the exposure keys, in powers of two.
const EXPOSURE_STEP: f64 = 0.25;

/// What a control makes of a scene, given the one that was loaded, if such a scene can be drawn.
/// None for controls that change no scene.
///
/// # Errors
/// Why it cannot be drawn, in one sentence.
pub fn edited(control: &Control, scene: &Scene, loaded: &Scene) -> Option<Result<Scene, String>> {
    let mut changed = scene.clone();
    match control.action {
        Action::Edit(edit) => edit(&mut changed, loaded),
        Action::Load(number) => {
            let preset = presets::PRESETS
                .iter()
                .find(|preset| preset.number == number)?;
            return Some(preset.scene(&[]).map_err(|error| error.to_string()));
        }
        Action::Turn(places) => {
            let preset = &presets::PRESETS[turned(&scene.name, places)];
            return Some(preset.scene(&[]).map_err(|error| error.to_string()));
        }
        Action::Do(_) | Action::Hold(_) => return None,
    }
    Some(
        Drawable::new(changed)
            .map(Drawable::into_scene)
            .map_err(|reason| reason.to_string()),
    )
}

/// The place of the preset that is so many places on from the one of this name; one end or the
/// other from a scene that is none of them.
fn turned(name: &str, places: i32) -> usize {
    let count = presets::PRESETS.len();
    match presets::PRESETS
        .iter()
        .position(|preset| preset.name == name)
    {
        Some(now) => (now as i32 + places).rem_euclid(count as i32) as usize,
        None if places > 0 => 0,
        None => count - 1,
    }
}

pub(crate) fn flip(switch: &mut bool) {
    *switch = !*switch;
}

pub(crate) fn switch_spin(scene: &mut Scene, loaded: &Scene) {
    let spin = if loaded.hole.spin == 0.0 {
        SPIN
    } else {
        loaded.hole.spin
    };
    scene.hole.spin = if scene.hole.spin == 0.0 { spin } else { 0.0 };
    // Some methods know no spin; without any, what was loaded serves again.
    if scene.hole.spin == 0.0 && loaded.hole.spin == 0.0 {
        scene.method = loaded.method;
    } else if !scene.method.properties().spins {
        scene.method = Method::Auto;
    }
}

/// Shows a view, or the light again where that view is shown already.
pub(crate) fn toggle(scene: &mut Scene, view: View) {
    scene.view = if scene.view == view {
        View::Colour
    } else {
        view
    };
}

pub(crate) fn switch_sky(scene: &mut Scene, loaded: &Scene) {
    let on = if loaded.sky.mode == SkyMode::Off {
        SkyMode::default()
    } else {
        loaded.sky.mode
    };
    scene.sky.mode = if scene.sky.mode == SkyMode::Off {
        on
    } else {
        SkyMode::Off
    };
}

pub(crate) fn next_sky(scene: &mut Scene) {
    scene.sky.mode = scene.sky.mode.next();
}

/// The next kind of observer that can exist at the camera's place.
pub(crate) fn next_observer(scene: &mut Scene) {
    let now = OBSERVERS
        .iter()
        .position(|kind| *kind == scene.observer.kind)
        .unwrap_or(0);
    for next in 1..OBSERVERS.len() {
        scene.observer.kind = OBSERVERS[(now + next) % OBSERVERS.len()];
        if CameraRays::new(scene).is_ok() {
            return;
        }
    }
    scene.observer.kind = OBSERVERS[now];
}

pub(crate) fn switch_bloom(scene: &mut Scene, loaded: &Scene) {
    let on = if loaded.picture.bloom == 0.0 {
        Picture::default().bloom
    } else {
        loaded.picture.bloom
    };
    scene.picture.bloom = if scene.picture.bloom == 0.0 { on } else { 0.0 };
}

pub(crate) fn switch_levels(scene: &mut Scene, loaded: &Scene) {
    let few = if loaded.picture.levels == ALL_LEVELS {
        Picture::default().levels
    } else {
        loaded.picture.levels
    };
    scene.picture.levels = if scene.picture.levels == ALL_LEVELS {
        few
    } else {
        ALL_LEVELS
    };
}

pub(crate) fn expose(scene: &mut Scene, steps: f64) {
    scene.picture.exposure_ev += steps * EXPOSURE_STEP;
}
