//! The key table: every control, what it does and which keys it has by default. The handlers, the
//! help and the settings all read it from here.

use crate::app::controls::edits;
use bevy::prelude::{KeyCode, Message};
use lightfall_core::scene::{Scene, View};

/// One control.
#[derive(Clone, Copy, Debug)]
pub struct Control {
    /// Its name in the settings file.
    pub id: &'static str,
    /// Its keys, by their place on the keyboard, where the settings say nothing else.
    pub keys: &'static [KeyCode],
    /// Whether Alt must be held with them. Without, a key with Alt belongs to the desktop.
    pub alt: bool,
    /// Under which heading the help shows it.
    pub group: Group,
    /// What it does, in a few words; controls in a row with the same words are one entry of the
    /// help.
    pub does: &'static str,
    /// What happens.
    pub action: Action,
}

/// The headings of the help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Moving and looking.
    Flight,
    /// What there is.
    Scene,
    /// What light does.
    Light,
    /// What is shown of it.
    View,
    /// From light to pixels.
    Picture,
    /// Everything around the picture.
    Window,
}

impl Group {
    /// Every heading, in the order of the help.
    pub const ALL: [Self; 6] = [
        Self::Flight,
        Self::Scene,
        Self::Light,
        Self::View,
        Self::Picture,
        Self::Window,
    ];

    /// The heading itself.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Flight => "Flying",
            Self::Scene => "Scene",
            Self::Light => "Light: off breaks the physics on purpose",
            Self::View => "Views",
            Self::Picture => "Picture",
            Self::Window => "Window",
        }
    }
}

/// What a control does.
#[derive(Clone, Copy, Debug)]
pub enum Action {
    /// Changes the scene, given the one that was loaded.
    Edit(fn(&mut Scene, &Scene)),
    /// Puts the preset with this number in its place.
    Load(usize),
    /// Puts the preset so many places on in its place, round and round.
    Turn(i32),
    /// Does something beside the scene.
    Do(Command),
    /// Moves the camera for as long as it is held.
    Hold(FlightInput),
}

/// What a control does beside the scene.
#[derive(Message, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// The overlay of all controls.
    Help,
    /// The panel.
    Panel,
    /// Everything but the picture.
    Hide,
    /// The ray inspector.
    Inspect,
    /// A picture file of what the window shows.
    Screenshot,
    /// The whole monitor, or a window.
    Fullscreen,
    /// Without the last change of the scene.
    Undo,
    /// The mouse looks around, or not.
    MouseLook,
    /// Free the mouse; close what is open.
    Escape,
    /// Exposure by itself.
    AutomaticExposure,
    /// The guided journey starts, or stops.
    Journey,
    /// The journey begins again.
    JourneyAgain,
    /// The observer is let go and moves by herself, or stays.
    LetGo,
    /// Her time runs faster.
    TimeFaster,
    /// Her time runs slower.
    TimeSlower,
}

/// Ways to move while a key is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "their names say it")]
pub enum FlightInput {
    Forward,
    Backward,
    Left,
    Right,
    Up,
    Down,
    RollLeft,
    RollRight,
    Faster,
    Slower,
}

const PRESETS: &str = "presets";
const TURN: &str = "previous, next preset";
const FLY: &str = "fly";
const UP_DOWN: &str = "up, down";
const ROLL: &str = "roll";
const EXPOSURE: &str = "brighter, darker";
const TIME: &str = "own time slower, faster";

const fn control(
    id: &'static str,
    keys: &'static [KeyCode],
    group: Group,
    does: &'static str,
    action: Action,
) -> Control {
    Control {
        id,
        keys,
        alt: false,
        group,
        does,
        action,
    }
}

const fn hold(
    id: &'static str,
    keys: &'static [KeyCode],
    does: &'static str,
    motion: FlightInput,
) -> Control {
    control(id, keys, Group::Flight, does, Action::Hold(motion))
}

const fn preset(id: &'static str, keys: &'static [KeyCode], number: usize) -> Control {
    control(id, keys, Group::Scene, PRESETS, Action::Load(number))
}

const fn turn(id: &'static str, keys: &'static [KeyCode], places: i32) -> Control {
    control(id, keys, Group::Scene, TURN, Action::Turn(places))
}

const fn scene(
    id: &'static str,
    keys: &'static [KeyCode],
    does: &'static str,
    edit: fn(&mut Scene, &Scene),
) -> Control {
    control(id, keys, Group::Scene, does, Action::Edit(edit))
}

const fn light(
    id: &'static str,
    keys: &'static [KeyCode],
    does: &'static str,
    edit: fn(&mut Scene, &Scene),
) -> Control {
    control(id, keys, Group::Light, does, Action::Edit(edit))
}

const fn view(
    id: &'static str,
    keys: &'static [KeyCode],
    does: &'static str,
    edit: fn(&mut Scene, &Scene),
) -> Control {
    control(id, keys, Group::View, does, Action::Edit(edit))
}

const fn picture(
    id: &'static str,
    keys: &'static [KeyCode],
    does: &'static str,
    edit: fn(&mut Scene, &Scene),
) -> Control {
    control(id, keys, Group::Picture, does, Action::Edit(edit))
}

const fn window(
    id: &'static str,
    keys: &'static [KeyCode],
    does: &'static str,
    command: Command,
) -> Control {
    control(id, keys, Group::Window, does, Action::Do(command))
}

/// Every control, in the order of the help.
pub const CONTROLS: &[Control] = &[
    hold("fly.forward", &[KeyCode::KeyW], FLY, FlightInput::Forward),
    hold("fly.left", &[KeyCode::KeyA], FLY, FlightInput::Left),
    hold("fly.backward", &[KeyCode::KeyS], FLY, FlightInput::Backward),
    hold("fly.right", &[KeyCode::KeyD], FLY, FlightInput::Right),
    hold("fly.up", &[KeyCode::Space], UP_DOWN, FlightInput::Up),
    hold(
        "fly.down",
        &[KeyCode::ControlLeft, KeyCode::ControlRight],
        UP_DOWN,
        FlightInput::Down,
    ),
    hold(
        "fly.roll_left",
        &[KeyCode::KeyQ],
        ROLL,
        FlightInput::RollLeft,
    ),
    hold(
        "fly.roll_right",
        &[KeyCode::KeyE],
        ROLL,
        FlightInput::RollRight,
    ),
    hold(
        "fly.faster",
        &[KeyCode::ShiftLeft, KeyCode::ShiftRight],
        "fly faster",
        FlightInput::Faster,
    ),
    hold(
        "fly.slower",
        &[KeyCode::AltLeft, KeyCode::AltRight],
        "fly slower",
        FlightInput::Slower,
    ),
    control(
        "fly.mouse",
        &[KeyCode::Tab],
        Group::Flight,
        "mouse looks around",
        Action::Do(Command::MouseLook),
    ),
    control(
        "fly.escape",
        &[KeyCode::Escape],
        Group::Flight,
        "free the mouse",
        Action::Do(Command::Escape),
    ),
    control(
        "journey.fly",
        &[KeyCode::KeyJ],
        Group::Flight,
        "journey: start, stop",
        Action::Do(Command::Journey),
    ),
    control(
        "journey.again",
        &[KeyCode::Enter],
        Group::Flight,
        "journey from its start",
        Action::Do(Command::JourneyAgain),
    ),
    control(
        "motion.let_go",
        &[KeyCode::KeyF],
        Group::Flight,
        "let go: fall or orbit",
        Action::Do(Command::LetGo),
    ),
    control(
        "motion.slower",
        &[KeyCode::Comma],
        Group::Flight,
        TIME,
        Action::Do(Command::TimeSlower),
    ),
    control(
        "motion.faster",
        &[KeyCode::Period],
        Group::Flight,
        TIME,
        Action::Do(Command::TimeFaster),
    ),
    preset("preset.1", &[KeyCode::Digit1], 1),
    preset("preset.2", &[KeyCode::Digit2], 2),
    preset("preset.3", &[KeyCode::Digit3], 3),
    preset("preset.4", &[KeyCode::Digit4], 4),
    preset("preset.5", &[KeyCode::Digit5], 5),
    preset("preset.6", &[KeyCode::Digit6], 6),
    preset("preset.7", &[KeyCode::Digit7], 7),
    preset("preset.8", &[KeyCode::Digit8], 8),
    preset("preset.9", &[KeyCode::Digit9], 9),
    turn("preset.previous", &[KeyCode::PageUp], -1),
    turn("preset.next", &[KeyCode::PageDown], 1),
    control(
        "scene.undo",
        &[KeyCode::Backspace],
        Group::Scene,
        "undo the last change",
        Action::Do(Command::Undo),
    ),
    scene("scene.disk", &[KeyCode::F2], "disk", |scene, _| {
        edits::flip(&mut scene.disk.enabled)
    }),
    scene(
        "scene.isco",
        &[KeyCode::KeyU],
        "disk from the innermost stable orbit",
        |scene, _| {
            edits::flip(&mut scene.disk.follow_isco);
        },
    ),
    scene("scene.sky", &[KeyCode::F3], "sky", edits::switch_sky),
    scene(
        "scene.sky_mode",
        &[KeyCode::KeyG],
        "sky: stars, grid, nothing",
        |scene, _| edits::next_sky(scene),
    ),
    scene("scene.probe", &[KeyCode::F4], "probe", |scene, _| {
        edits::flip(&mut scene.probe.enabled)
    }),
    scene("scene.spin", &[KeyCode::KeyT], "spin", edits::switch_spin),
    scene(
        "scene.observer",
        &[KeyCode::KeyO],
        "observer: at rest, zamo, orbit, free fall",
        |scene, _| {
            edits::next_observer(scene);
        },
    ),
    light("light.lensing", &[KeyCode::KeyL], "lensing", |scene, _| {
        edits::flip(&mut scene.effects.lensing)
    }),
    light(
        "light.doppler",
        &[KeyCode::KeyZ],
        "Doppler shift",
        |scene, _| edits::flip(&mut scene.effects.doppler),
    ),
    light("light.beaming", &[KeyCode::KeyX], "beaming", |scene, _| {
        edits::flip(&mut scene.effects.beaming)
    }),
    light(
        "light.gravitational_shift",
        &[KeyCode::KeyC],
        "gravitational shift",
        |scene, _| {
            edits::flip(&mut scene.effects.gravitational_shift);
        },
    ),
    view(
        "view.unfinished",
        &[KeyCode::F11],
        "unfinished rays in magenta",
        |scene, _| {
            edits::toggle(scene, View::Unfinished);
        },
    ),
    view(
        "view.classes",
        &[KeyCode::KeyB],
        "ray classes",
        |scene, _| edits::toggle(scene, View::Classes),
    ),
    view(
        "view.residual",
        &[KeyCode::KeyM],
        "residual of the null constraint",
        |scene, _| {
            edits::toggle(scene, View::Residual);
        },
    ),
    view(
        "view.order",
        &[KeyCode::KeyN],
        "order of the image",
        |scene, _| edits::toggle(scene, View::Order),
    ),
    view(
        "view.redshift",
        &[KeyCode::KeyR],
        "redshift g",
        |scene, _| edits::toggle(scene, View::Redshift),
    ),
    picture(
        "picture.bloom",
        &[KeyCode::F5],
        "bloom",
        edits::switch_bloom,
    ),
    picture(
        "picture.antialias",
        &[KeyCode::F6],
        "smooth edges of the probe",
        |scene, _| {
            edits::flip(&mut scene.probe.antialias);
        },
    ),
    picture(
        "picture.bypass",
        &[KeyCode::F7],
        "whole cells, or the window filled",
        |scene, _| {
            edits::flip(&mut scene.picture.bypass);
        },
    ),
    picture("picture.dither", &[KeyCode::F8], "dither", |scene, _| {
        edits::flip(&mut scene.picture.dither)
    }),
    picture(
        "picture.levels",
        &[KeyCode::KeyV],
        "few tones, or all",
        edits::switch_levels,
    ),
    picture(
        "picture.brighter",
        &[KeyCode::Equal, KeyCode::NumpadAdd],
        EXPOSURE,
        |scene, _| edits::expose(scene, 1.0),
    ),
    picture(
        "picture.darker",
        &[KeyCode::Minus, KeyCode::NumpadSubtract],
        EXPOSURE,
        |scene, _| edits::expose(scene, -1.0),
    ),
    control(
        "picture.automatic_exposure",
        &[KeyCode::F9],
        Group::Picture,
        "exposure by itself",
        Action::Do(Command::AutomaticExposure),
    ),
    window("window.help", &[KeyCode::F1], "this help", Command::Help),
    window(
        "window.panel",
        &[KeyCode::KeyP],
        "panel: every setting",
        Command::Panel,
    ),
    window(
        "window.inspector",
        &[KeyCode::KeyI],
        "ray inspector: then click a pixel",
        Command::Inspect,
    ),
    window(
        "window.hide",
        &[KeyCode::KeyH],
        "hide everything but the picture",
        Command::Hide,
    ),
    window(
        "window.screenshot",
        &[KeyCode::F12, KeyCode::PrintScreen],
        "screenshot",
        Command::Screenshot,
    ),
    Control {
        alt: true,
        ..window(
            "window.fullscreen",
            &[KeyCode::Enter],
            "whole screen",
            Command::Fullscreen,
        )
    },
];

/// The control with this name.
#[must_use]
pub fn control_named(id: &str) -> Option<&'static Control> {
    CONTROLS.iter().find(|control| control.id == id)
}
