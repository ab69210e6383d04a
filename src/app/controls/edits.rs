//! How controls edit a scene. A switch that is more than on and off returns to the value that was
//! loaded.

use super::control::{Action, Control};
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{Method, ObserverKind, Picture, Scene, SkyMode, View};

/// The spin that is switched on where the loaded scene has none.
const DEFAULT_SPIN: f64 = 0.9;
/// As many levels as eight bits can tell apart.
pub(crate) const ALL_LEVELS: u32 = 256;
/// One press of an exposure key, in powers of two.
const EXPOSURE_STEP: f64 = 0.25;

/// The scene that a control makes of `scene`, where `loaded` is the scene that was loaded. None
/// for controls that change no scene. The result is not checked.
#[must_use]
pub fn edited(control: &Control, scene: &Scene, loaded: &Scene) -> Option<Scene> {
    match control.action {
        Action::Edit(edit) => {
            let mut changed = scene.clone();
            edit(&mut changed, loaded);
            Some(changed)
        }
        Action::Load(number) => PRESETS
            .iter()
            .find(|preset| preset.number == number)
            .map(|preset| preset.plain_scene().clone()),
        Action::StepPreset(places) => Some(turned_to(&scene.name, places).clone()),
        Action::Do(_) | Action::Hold(_) => None,
    }
}

/// The scene of the preset `places` further on from the one with this name, wrapping around. From
/// a scene that is no built-in preset: the first or the last preset.
fn turned_to(name: &str, places: i32) -> &'static Scene {
    let count = PRESETS.len();
    let next = match PRESETS.iter().position(|preset| preset.name == name) {
        Some(now) => (now as i32 + places).rem_euclid(count as i32) as usize,
        None if places > 0 => 0,
        None => count - 1,
    };
    PRESETS[next].plain_scene()
}

fn flip(switch: &mut bool) {
    *switch = !*switch;
}

pub(super) fn switch_disk(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.disk.enabled);
}

pub(super) fn switch_isco(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.disk.follow_isco);
}

pub(super) fn switch_probe(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.probe.enabled);
}

pub(super) fn switch_antialias(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.probe.antialias);
}

pub(super) fn switch_lensing(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.effects.lensing);
}

pub(super) fn switch_doppler(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.effects.doppler);
}

pub(super) fn switch_beaming(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.effects.beaming);
}

pub(super) fn switch_gravitational_shift(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.effects.gravitational_shift);
}

pub(super) fn switch_bypass(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.picture.bypass);
}

pub(super) fn switch_dither(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.picture.dither);
}

pub(super) fn switch_spin(scene: &mut Scene, loaded: &Scene) {
    let on = if loaded.hole.spin == 0.0 {
        DEFAULT_SPIN
    } else {
        loaded.hole.spin
    };
    scene.hole.spin = if scene.hole.spin == 0.0 { on } else { 0.0 };
    // Some methods trace no spin. Without spin, the loaded method serves again.
    if scene.hole.spin == 0.0 && loaded.hole.spin == 0.0 {
        scene.method = loaded.method;
    } else if !scene.method.properties().spins {
        scene.method = Method::Auto;
    }
}

/// Shows a view, or the light again where that view is shown already.
fn toggle(scene: &mut Scene, view: View) {
    scene.view = if scene.view == view {
        View::Colour
    } else {
        view
    };
}

pub(super) fn toggle_unfinished(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Unfinished);
}

pub(super) fn toggle_classes(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Classes);
}

pub(super) fn toggle_residual(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Residual);
}

pub(super) fn toggle_order(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Order);
}

pub(super) fn toggle_delay(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Delay);
}

pub(super) fn toggle_redshift(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Redshift);
}

pub(super) fn toggle_error(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Error);
}

pub(super) fn toggle_steps(scene: &mut Scene, _: &Scene) {
    toggle(scene, View::Steps);
}

pub(super) fn switch_sky(scene: &mut Scene, loaded: &Scene) {
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

pub(super) fn next_sky(scene: &mut Scene, _: &Scene) {
    scene.sky.mode = scene.sky.mode.next();
}

/// The next kind of observer that can exist at the camera's place.
pub(super) fn next_observer(scene: &mut Scene, _: &Scene) {
    let now = ObserverKind::ALL
        .iter()
        .position(|kind| *kind == scene.observer.kind)
        .unwrap_or(0);
    for next in 1..ObserverKind::ALL.len() {
        scene.observer.kind = ObserverKind::ALL[(now + next) % ObserverKind::ALL.len()];
        if CameraRays::new(scene).is_ok() {
            return;
        }
    }
    scene.observer.kind = ObserverKind::ALL[now];
}

pub(super) fn switch_bloom(scene: &mut Scene, loaded: &Scene) {
    let on = if loaded.picture.bloom == 0.0 {
        Picture::default().bloom
    } else {
        loaded.picture.bloom
    };
    scene.picture.bloom = if scene.picture.bloom == 0.0 { on } else { 0.0 };
}

pub(super) fn switch_levels(scene: &mut Scene, loaded: &Scene) {
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

/// Lets a light meter choose the exposure from here on, or keeps the exposure as it is now.
pub(super) fn switch_automatic_exposure(scene: &mut Scene, _: &Scene) {
    flip(&mut scene.picture.automatic_exposure);
}

pub(super) fn brighten(scene: &mut Scene, _: &Scene) {
    expose_by_hand(scene, EXPOSURE_STEP);
}

pub(super) fn darken(scene: &mut Scene, _: &Scene) {
    expose_by_hand(scene, -EXPOSURE_STEP);
}

fn expose_by_hand(scene: &mut Scene, step: f64) {
    scene.picture.automatic_exposure = false;
    scene.picture.exposure_ev += step;
}
