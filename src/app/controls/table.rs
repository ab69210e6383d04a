//! The control table: every control, its default keys and what it does. Input, help and settings
//! all read it; buttons of a gamepad stand in `buttons.rs`.

use super::control::Action::{Do, Edit, Hold, Load, StepPreset};
use super::control::Edit::{By, Expose, Flip, Show, SwitchOff};
use super::control::{Action, AppCommand, Control, FlightInput, Group, Modifier};
use super::edits::{ALL_LEVELS, next_observer, next_sky, switch_spin};
use super::statement;
use bevy::prelude::KeyCode;
use lightfall_core::scene::{Value, View};

/// Rows of `"name" [default keys] "what it does" action`, under the heading of the help. `Alt +`,
/// `Ctrl +` or `Shift +` before the keys means that this modifier is held with them. What the
/// control says may follow the action. For a key of a view, `_` stands for the view's own words.
macro_rules! controls {
    ($($group:ident {
        $($id:literal $($modifier:ident +)? [$($key:ident),+] $description:tt $action:expr
            $(, $says:expr)?;)+
    })+) => {
        &[$($(Control {
            id: $id,
            keys: &[$(KeyCode::$key),+],
            modifier: controls!(@modifier $($modifier)?),
            group: Group::$group,
            description: controls!(@words $description $action),
            action: $action,
            says: controls!(@says $($says)?),
        },)+)+]
    };
    (@words _ $action:expr) => { view_words(&$action) };
    (@words $description:literal $action:expr) => { $description };
    (@says $says:expr) => { Some($says) };
    (@says) => { None };
    (@modifier $modifier:ident) => { Some(Modifier::$modifier) };
    (@modifier) => { None };
}

/// The words of the view that a control shows.
const fn view_words(action: &Action) -> &'static str {
    match action {
        Edit(Show(view)) => view.properties().words,
        _ => panic!("only a control that shows a view has the view's words"),
    }
}

/// One press of an exposure key, in powers of two.
const EXPOSURE_STEP: f64 = 0.25;

/// Every control, in the order of the help.
pub const CONTROLS: &[Control] = controls! {
    Flight {
        "fly.forward" [KeyW] "fly" Hold(FlightInput::Forward);
        "fly.left" [KeyA] "fly" Hold(FlightInput::Left);
        "fly.backward" [KeyS] "fly" Hold(FlightInput::Backward);
        "fly.right" [KeyD] "fly" Hold(FlightInput::Right);
        "fly.up" [Space] "up, down" Hold(FlightInput::Up);
        "fly.down" [ControlLeft, ControlRight] "up, down" Hold(FlightInput::Down);
        "fly.look_left" [ArrowLeft] "look around" Hold(FlightInput::LookLeft);
        "fly.look_right" [ArrowRight] "look around" Hold(FlightInput::LookRight);
        "fly.look_up" [ArrowUp] "look around" Hold(FlightInput::LookUp);
        "fly.look_down" [ArrowDown] "look around" Hold(FlightInput::LookDown);
        "fly.roll_left" [KeyQ] "roll" Hold(FlightInput::RollLeft);
        "fly.roll_right" [KeyE] "roll" Hold(FlightInput::RollRight);
        "fly.faster" [ShiftLeft, ShiftRight] "fly faster" Hold(FlightInput::Faster);
        "fly.slower" [AltLeft, AltRight] "fly slower" Hold(FlightInput::Slower);
        "fly.face" [KeyY] "face the hole, or outward" Do(AppCommand::Face);
        "fly.face_back" Shift + [KeyY] "face the hole, or outward" Do(AppCommand::Face);
        "fly.orbit" [KeyK] "orbit camera: round the hole" Do(AppCommand::OrbitCamera);
        "fly.narrower" [BracketLeft] "field of view" Hold(FlightInput::Narrower);
        "fly.wider" [BracketRight] "field of view" Hold(FlightInput::Wider);
        "fly.mouse" [Tab] "mouse looks around" Do(AppCommand::MouseLook);
        "journey.fly" [KeyJ] "journey: start, stop" Do(AppCommand::Journey);
        "journey.again" [Enter] "journey from its start" Do(AppCommand::RestartJourney);
        "journey.back" Shift + [ArrowLeft] "journey: 5 seconds back, ahead" Do(AppCommand::JourneyBack);
        "journey.ahead" Shift + [ArrowRight] "journey: 5 seconds back, ahead" Do(AppCommand::JourneyAhead);
        "lesson.add_stop" Shift + [KeyL] "lesson: add this as a stop" Do(AppCommand::AddStop);
        "lesson.save" Ctrl + [KeyL] "lesson: save it" Do(AppCommand::SaveLesson);
        "motion.pause" [Slash] "pause what moves, go on" Do(AppCommand::Pause);
        "motion.let_go" [KeyF] "let go (free fall or orbit)" Do(AppCommand::LetGo);
        "motion.slower" [Comma] "slow down, speed up time" Do(AppCommand::SlowerTime);
        "motion.faster" [Period] "slow down, speed up time" Do(AppCommand::FasterTime);
        "ship.fly" Shift + [KeyF] "ship: take, leave its controls" Do(AppCommand::TakeControls);
        "ship.map" Shift + [KeyM] "map of the ship's path" Do(AppCommand::Map);
        "ship.missions" Shift + [KeyJ] "missions" Do(AppCommand::Missions);
    }
    Scene {
        "preset.1" [Digit1] "presets" Load(1);
        "preset.2" [Digit2] "presets" Load(2);
        "preset.3" [Digit3] "presets" Load(3);
        "preset.4" [Digit4] "presets" Load(4);
        "preset.5" [Digit5] "presets" Load(5);
        "preset.6" [Digit6] "presets" Load(6);
        "preset.7" [Digit7] "presets" Load(7);
        "preset.8" [Digit8] "presets" Load(8);
        "preset.9" [Digit9] "presets" Load(9);
        "preset.previous" [PageUp] "previous, next preset" StepPreset(-1);
        "preset.next" [PageDown] "previous, next preset" StepPreset(1);
        "scene.undo" [Backspace] "undo the last change" Do(AppCommand::Undo);
        "scene.disk" [F2] "disk" Edit(Flip("disk.enabled"));
        "scene.isco" [KeyU] "disk from the innermost stable orbit" Edit(Flip("disk.follow_isco"));
        "scene.sky" [F3, Home] "sky" Edit(SwitchOff("sky.mode", &Value::Word("off"))), statement::sky;
        "scene.sky_mode" [KeyG] "sky: what it shows" Edit(By(next_sky)), statement::sky;
        "scene.probe" [F4] "probe" Edit(Flip("probe.enabled")), statement::probe;
        "scene.spin" [KeyT] "spin" Edit(By(switch_spin)), statement::spin;
        "scene.observer" [KeyO] "observer: how the camera moves" Edit(By(next_observer)), statement::observer;
    }
    Light {
        "light.lensing" [KeyL] "lensing" Edit(Flip("effects.lensing"));
        "light.doppler" [KeyZ] "Doppler shift" Edit(Flip("effects.doppler"));
        "light.beaming" [KeyX] "beaming" Edit(Flip("effects.beaming"));
        "light.gravitational_shift" [KeyC] "gravitational shift" Edit(Flip("effects.gravitational_shift"));
    }
    View {
        "view.unfinished" [F11] _ Edit(Show(View::Unfinished));
        "view.classes" [KeyB] _ Edit(Show(View::Classes));
        "view.residual" [KeyM] _ Edit(Show(View::Residual));
        "view.order" [KeyN] _ Edit(Show(View::Order));
        "view.delay" Shift + [KeyN] _ Edit(Show(View::Delay));
        "view.steps" [Semicolon] _ Edit(Show(View::Steps));
        "view.redshift" [KeyR] _ Edit(Show(View::Redshift));
        "view.error" [Quote] _ Edit(Show(View::Error));
        "view.depth" Shift + [KeyB] _ Edit(Show(View::Depth));
        "view.samples" Shift + [Semicolon] _ Edit(Show(View::Samples));
        "view.light_error" Shift + [Quote] _ Edit(Show(View::LightError));
    }
    Picture {
        "picture.bloom" [F5, End] "bloom" Edit(SwitchOff("picture.bloom", &Value::Float(0.0)));
        "picture.antialias" [F6, Delete] "smooth edges of the probe" Edit(Flip("probe.antialias"));
        "picture.bypass" [F7, Backslash] "pixel look" Edit(Flip("picture.bypass")), statement::pixel_look;
        "picture.dither" [F8] "dither" Edit(Flip("picture.dither"));
        "picture.levels" [KeyV] "posterise" Edit(SwitchOff("picture.levels", &Value::Integer(ALL_LEVELS as i64))), statement::tones;
        "picture.brighter" [Equal, NumpadAdd] "brighter, darker" Edit(Expose(EXPOSURE_STEP)), statement::exposure_in_words;
        "picture.darker" [Minus, NumpadSubtract] "brighter, darker" Edit(Expose(-EXPOSURE_STEP)), statement::exposure_in_words;
        "picture.compare" [Digit0] "side by side; two whole pictures" Do(AppCommand::Compare);
        "picture.difference" Shift + [Digit0] "difference of the sides, amplified" Do(AppCommand::Difference);
        "picture.automatic_exposure" [F9] "automatic exposure" Edit(Flip("picture.automatic_exposure")), statement::exposure_in_words;
    }
    Window {
        "fly.escape" [Escape] "menu, or close, or free the mouse" Do(AppCommand::Escape);
        "window.help" [F1, Backquote] "this help" Do(AppCommand::Help);
        "window.panel" [KeyP] "panel: every setting" Do(AppCommand::Panel);
        "window.inspector" [KeyI] "ray inspector: then click a pixel" Do(AppCommand::Inspector);
        "window.guides" [F10] "guides: shadow, orbits, scale" Do(AppCommand::Guides);
        "window.star_names" Shift + [KeyG] "names of the bright stars" Do(AppCommand::StarNames);
        "window.hide" [KeyH] "photo mode: only the picture" Do(AppCommand::Hide);
        "window.screenshot" [F12, PrintScreen, Insert] "save the picture" Do(AppCommand::Screenshot);
        "window.screenshot_of_window" Shift + [F12, Insert] "save the window as it is" Do(AppCommand::ScreenshotOfWindow);
        "window.fullscreen" Alt + [Enter] "full screen" Do(AppCommand::Fullscreen);
        "window.quit" Ctrl + [KeyQ] "quit" Do(AppCommand::Quit);
    }
};

/// The control with this name.
#[must_use]
pub fn control_named(id: &str) -> Option<&'static Control> {
    CONTROLS.iter().find(|control| control.id == id)
}
