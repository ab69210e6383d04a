//! The control table: every control, its default keys and what it does. Input, help and settings
//! all read it; buttons of a gamepad stand in `buttons.rs`.

use super::control::Action::{Do, Edit, Hold, Load, StepPreset};
use super::control::{AppCommand, Control, FlightInput, Group, Modifier};
use super::edits;
use bevy::prelude::KeyCode;

/// Rows of `"name" [default keys] "what it does" action`, under the heading of the help. `Alt +`,
/// `Ctrl +` or `Shift +` before the keys means that this modifier is held with them.
macro_rules! controls {
    ($($group:ident {
        $($id:literal $($modifier:ident +)? [$($key:ident),+] $description:literal $action:expr;)+
    })+) => {
        &[$($(Control {
            id: $id,
            keys: &[$(KeyCode::$key),+],
            modifier: controls!(@modifier $($modifier)?),
            group: Group::$group,
            description: $description,
            action: $action,
        },)+)+]
    };
    (@modifier $modifier:ident) => { Some(Modifier::$modifier) };
    (@modifier) => { None };
}

/// Every control, in the order of the help.
pub const CONTROLS: &[Control] = controls! {
    Flight {
        "fly.forward" [KeyW] "fly" Hold(FlightInput::Forward);
        "fly.left" [KeyA] "fly" Hold(FlightInput::Left);
        "fly.backward" [KeyS] "fly" Hold(FlightInput::Backward);
        "fly.right" [KeyD] "fly" Hold(FlightInput::Right);
        "fly.up" [Space] "up, down" Hold(FlightInput::Up);
        "fly.down" [ControlLeft, ControlRight] "up, down" Hold(FlightInput::Down);
        "fly.roll_left" [KeyQ] "roll" Hold(FlightInput::RollLeft);
        "fly.roll_right" [KeyE] "roll" Hold(FlightInput::RollRight);
        "fly.faster" [ShiftLeft, ShiftRight] "fly faster" Hold(FlightInput::Faster);
        "fly.slower" [AltLeft, AltRight] "fly slower" Hold(FlightInput::Slower);
        "fly.face" [KeyY] "face the hole, or outward" Do(AppCommand::Face);
        "fly.orbit" [KeyK] "orbit camera: round the hole" Do(AppCommand::OrbitCamera);
        "fly.narrower" [BracketLeft] "field of view" Hold(FlightInput::Narrower);
        "fly.wider" [BracketRight] "field of view" Hold(FlightInput::Wider);
        "fly.mouse" [Tab] "mouse looks around" Do(AppCommand::MouseLook);
        "journey.fly" [KeyJ] "journey: start, stop" Do(AppCommand::Journey);
        "journey.again" [Enter] "journey from its start" Do(AppCommand::RestartJourney);
        "journey.back" [ArrowLeft] "journey: 5 seconds back, ahead" Do(AppCommand::JourneyBack);
        "journey.ahead" [ArrowRight] "journey: 5 seconds back, ahead" Do(AppCommand::JourneyAhead);
        "motion.pause" [Slash] "pause what moves, go on" Do(AppCommand::Pause);
        "motion.let_go" [KeyF] "let go (free fall or orbit)" Do(AppCommand::LetGo);
        "motion.slower" [Comma] "slow down, speed up time" Do(AppCommand::SlowerTime);
        "motion.faster" [Period] "slow down, speed up time" Do(AppCommand::FasterTime);
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
        "scene.disk" [F2] "disk" Edit(edits::switch_disk);
        "scene.isco" [KeyU] "disk from the innermost stable orbit" Edit(edits::switch_isco);
        "scene.sky" [F3, Home] "sky" Edit(edits::switch_sky);
        "scene.sky_mode" [KeyG] "sky: stars, the article's stars, grid, nothing" Edit(edits::next_sky);
        "scene.probe" [F4] "probe" Edit(edits::switch_probe);
        "scene.spin" [KeyT] "spin" Edit(edits::switch_spin);
        "scene.observer" [KeyO] "observer: how the camera moves" Edit(edits::next_observer);
    }
    Light {
        "light.lensing" [KeyL] "lensing" Edit(edits::switch_lensing);
        "light.doppler" [KeyZ] "Doppler shift" Edit(edits::switch_doppler);
        "light.beaming" [KeyX] "beaming" Edit(edits::switch_beaming);
        "light.gravitational_shift" [KeyC] "gravitational shift" Edit(edits::switch_gravitational_shift);
    }
    View {
        "view.unfinished" [F11, ArrowDown] "unfinished rays in magenta" Edit(edits::toggle_unfinished);
        "view.classes" [KeyB] "ray classes" Edit(edits::toggle_classes);
        "view.residual" [KeyM] "residual of the null constraint" Edit(edits::toggle_residual);
        "view.order" [KeyN] "order of the image" Edit(edits::toggle_order);
        "view.delay" Shift + [KeyN] "delay of the disk's light" Edit(edits::toggle_delay);
        "view.steps" [Semicolon] "heat map of steps" Edit(edits::toggle_steps);
        "view.redshift" [KeyR] "redshift g" Edit(edits::toggle_redshift);
        "view.error" [Quote] "backward error" Edit(edits::toggle_error);
    }
    Picture {
        "picture.bloom" [F5, End] "bloom" Edit(edits::switch_bloom);
        "picture.antialias" [F6, Delete] "smooth edges of the probe" Edit(edits::switch_antialias);
        "picture.bypass" [F7, Backslash] "pixel look" Edit(edits::switch_bypass);
        "picture.dither" [F8] "dither" Edit(edits::switch_dither);
        "picture.levels" [KeyV] "posterise" Edit(edits::switch_levels);
        "picture.brighter" [Equal, NumpadAdd] "brighter, darker" Edit(edits::brighten);
        "picture.darker" [Minus, NumpadSubtract] "brighter, darker" Edit(edits::darken);
        "picture.compare" [Digit0] "side by side: pin the left half" Do(AppCommand::Compare);
        "picture.difference" Shift + [Digit0] "difference of the sides, amplified" Do(AppCommand::Difference);
        "picture.automatic_exposure" [F9] "automatic exposure" Edit(edits::switch_automatic_exposure);
    }
    Window {
        "fly.escape" [Escape] "menu, or close, or free the mouse" Do(AppCommand::Escape);
        "window.help" [F1, Backquote] "this help" Do(AppCommand::Help);
        "window.panel" [KeyP] "panel: every setting" Do(AppCommand::Panel);
        "window.inspector" [KeyI] "ray inspector: then click a pixel" Do(AppCommand::Inspector);
        "window.guides" [F10, ArrowUp] "guides: shadow, orbits, scale" Do(AppCommand::Guides);
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
