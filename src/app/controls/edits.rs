//! How controls edit a scene. A switch that is more than on and off returns to the value that was
//! loaded.

use super::control::{Action, Control, Edit};
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{Method, Scene, SkyMode, Value, View, field};

/// The spin that is switched on where the loaded scene has none.
const DEFAULT_SPIN: f64 = 0.9;
/// The keys of the exposure round it to one part in so many.
const EXPOSURE_DIGITS: f64 = 1e6;
/// As many levels as eight bits can tell apart.
pub(crate) const ALL_LEVELS: u32 = 256;

impl Edit {
    fn apply(self, scene: &mut Scene, loaded: &Scene) {
        match self {
            Self::Flip(key) => {
                let on = value(scene, key) == Some(Value::Boolean(true));
                set(scene, key, Some(Value::Boolean(!on)));
            }
            Self::SwitchOff(key, off) => {
                let values = [&*scene, loaded, &Scene::default()].map(|scene| value(scene, key));
                let is_on = |value: &Option<Value>| value.as_ref() != Some(off);
                let [now, loaded, default] = values;
                let on = if is_on(&loaded) { loaded } else { default };
                set(scene, key, if is_on(&now) { Some(off.clone()) } else { on });
            }
            Self::Show(view) if scene.view == view => scene.view = View::Colour,
            Self::Show(view) => scene.view = view,
            Self::Expose(step) => {
                scene.picture.automatic_exposure = false;
                // Decimals stay decimals: up and down again leaves what was.
                let exposure = scene.picture.exposure_ev + step;
                scene.picture.exposure_ev = (exposure * EXPOSURE_DIGITS).round() / EXPOSURE_DIGITS;
            }
            Self::By(edit) => edit(scene, loaded),
        }
    }

    /// Whether what it switches is on in a scene. None for edits that are no switches.
    pub(super) fn is_on(self, scene: &Scene) -> Option<bool> {
        match self {
            Self::Flip(key) => Some(value(scene, key)? == Value::Boolean(true)),
            Self::SwitchOff(key, off) => Some(value(scene, key)? != *off),
            Self::Show(_) | Self::Expose(_) | Self::By(_) => None,
        }
    }
}

fn value(scene: &Scene, key: &str) -> Option<Value> {
    field(key).map(|field| field.get(scene))
}

/// Sets a field. A test uses every control, so that a wrong key or kind of value is found.
fn set(scene: &mut Scene, key: &str, value: Option<Value>) {
    if let Some((field, value)) = field(key).zip(value) {
        let _ = field.set(scene, value);
    }
}

/// The scene that a control makes of `scene`, where `loaded` is the scene that was loaded. None
/// for controls that change no scene. The result is not checked.
#[must_use]
pub fn edited(control: &Control, scene: &Scene, loaded: &Scene) -> Option<Scene> {
    match control.action {
        Action::Edit(edit) => {
            let mut changed = scene.clone();
            edit.apply(&mut changed, loaded);
            Some(changed)
        }
        Action::Load(number) => PRESETS
            .iter()
            .find(|preset| preset.number == number)
            .map(|preset| preset.plain_scene().clone()),
        Action::StepPreset(_) | Action::Do(_) | Action::Hold(_) => None,
    }
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

pub(super) fn next_sky(scene: &mut Scene, _: &Scene) {
    scene.sky.mode = scene.sky.mode.next();
    // A picture needs a file.
    if scene.sky.mode == SkyMode::Picture && scene.sky.picture.is_empty() {
        scene.sky.mode = scene.sky.mode.next();
    }
}

/// The next kind of observer that can exist at the camera's place.
pub(super) fn next_observer(scene: &mut Scene, _: &Scene) {
    let now = scene.observer.kind;
    loop {
        scene.observer.kind = scene.observer.kind.next();
        if scene.observer.kind == now || CameraRays::new(scene).is_ok() {
            return;
        }
    }
}
