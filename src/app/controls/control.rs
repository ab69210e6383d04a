//! A control: one thing that a key or a button does.

use bevy::prelude::{KeyCode, Message, MessageReader};
use lightfall_core::scene::{Scene, Value, View};

/// One control.
#[derive(Clone, Copy, Debug)]
pub struct Control {
    /// Its name in the settings file.
    pub id: &'static str,
    /// Its default keys, by their place on the keyboard.
    pub keys: &'static [KeyCode],
    /// The modifier that must be held with them.
    pub modifier: Option<Modifier>,
    /// The heading under which the help lists it.
    pub group: Group,
    /// A few words that say what it does. Neighbouring controls with the same words share one entry
    /// of the help.
    pub description: &'static str,
    /// What happens.
    pub action: Action,
    /// What it says of the scene that it has led to, where its description does not say it with `on`
    /// or `off`.
    pub says: Option<fn(&Scene) -> String>,
}

/// A key that changes what other keys do while it is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Modifier {
    Alt,
    Ctrl,
    Shift,
}

impl Modifier {
    /// Every modifier. Of several that are held, the first one here counts.
    pub const ALL: [Self; 3] = [Self::Alt, Self::Ctrl, Self::Shift];

    /// Its keys, left and right.
    #[must_use]
    pub fn keys(self) -> [KeyCode; 2] {
        match self {
            Self::Alt => [KeyCode::AltLeft, KeyCode::AltRight],
            Self::Ctrl => [KeyCode::ControlLeft, KeyCode::ControlRight],
            Self::Shift => [KeyCode::ShiftLeft, KeyCode::ShiftRight],
        }
    }

    /// What stands before the name of a key, for example `Shift+`.
    #[must_use]
    pub fn prefix(self) -> &'static str {
        match self {
            Self::Alt => "Alt+",
            Self::Ctrl => "Ctrl+",
            Self::Shift => "Shift+",
        }
    }
}

/// The headings of the help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Moving and looking.
    Flight,
    /// The hole, the disk, the sky, the observer.
    Scene,
    /// The effects on light.
    Light,
    /// What the picture shows.
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

    /// The heading as text.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Flight => "Flying",
            Self::Scene => "Scene",
            Self::Light => "Physics: switch it off and on",
            Self::View => "Views",
            Self::Picture => "Picture",
            Self::Window => "Window",
        }
    }
}

/// What a control does.
#[derive(Clone, Copy, Debug)]
pub enum Action {
    /// Edits the scene.
    Edit(Edit),
    /// Loads the built-in preset with this number.
    Load(usize),
    /// Loads the built-in preset this many places after the present one, and wraps around.
    StepPreset(i32),
    /// Sends a command.
    Do(AppCommand),
    /// Moves the camera for as long as the control is held.
    Hold(FlightInput),
}

/// How a control edits a scene. Fields are named by their keys.
#[derive(Clone, Copy, Debug)]
pub enum Edit {
    /// Switches a field of the kind true or false.
    Flip(&'static str),
    /// Sets a field to this value, which means that something is off. If it is off already, sets the
    /// field to the value that was loaded, or to its default if it was loaded switched off.
    SwitchOff(&'static str, &'static Value),
    /// Shows a view, or the light again where that view is shown already.
    Show(View),
    /// Changes the exposure by this many powers of two, and lets no light meter choose it.
    Expose(f64),
    /// Edits the first scene; the second one is the scene as it was loaded.
    By(fn(&mut Scene, &Scene)),
}

/// What a control asks of the program, other than to change the scene. The descriptions in the
/// control table say what each does.
#[derive(Message, Clone, Copy, Debug, PartialEq, Eq)]
pub enum AppCommand {
    Help,
    Panel,
    /// Begin or end the photo mode: everything but the picture is hidden, and time stands still.
    Hide,
    Inspector,
    Guides,
    StarNames,
    Screenshot,
    ScreenshotOfWindow,
    /// Open the panel on its page of settings.
    Settings,
    Quit,
    Fullscreen,
    Undo,
    MouseLook,
    /// Free the mouse, or close what is open, or open the menu.
    Escape,
    /// Turn the camera to face the hole, or outward if it faces the hole.
    Face,
    /// Let the hand move the camera around the hole, or fly freely again.
    OrbitCamera,
    Journey,
    RestartJourney,
    JourneyBack,
    JourneyAhead,
    /// Go on from the stop of a lesson.
    GoOn,
    /// Go back to the stop before.
    GoBack,
    /// Add what is shown as the next stop of the lesson under construction.
    AddStop,
    /// Save the lesson under construction.
    SaveLesson,
    /// Begin another lesson.
    NewLesson,
    /// Pause what moves by itself, the journey, the fall or the disk, or let it go on.
    Pause,
    /// Let go of the observer, so that it falls or orbits, or hold it again.
    LetGo,
    /// Let the observer's proper time, or the disk's clock, run faster.
    FasterTime,
    /// Let the observer's proper time, or the disk's clock, run slower.
    SlowerTime,
    /// Take the controls of the ship, or leave them.
    TakeControls,
    /// Let the ship hold still. Only at its controls.
    Hover,
    /// Turn the ship's nose to the heading before. Only at its controls.
    FaceBack,
    /// Look along the ship's nose, or at the hole. Only at its controls.
    Look,
    /// Show or hide the map of the ship's path.
    Map,
    /// Open the menu at its list of missions.
    Missions,
    /// Pin the present settings to the left half of the picture, or end the comparison.
    Compare,
    /// Show the difference from the pinned settings, or amplify it more.
    Difference,
}

impl AppCommand {
    /// How many times this command was sent since the last reading. All other commands are read, too.
    pub(crate) fn count(self, commands: &mut MessageReader<Self>) -> usize {
        commands.read().filter(|command| **command == self).count()
    }
}

/// The ways to move while a control is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlightInput {
    Forward,
    Backward,
    Left,
    Right,
    Up,
    Down,
    LookLeft,
    LookRight,
    LookUp,
    LookDown,
    RollLeft,
    RollRight,
    Faster,
    Slower,
    Narrower,
    Wider,
}

impl FlightInput {
    /// Those that push.
    pub(crate) const THRUST: [Self; 6] = [
        Self::Forward,
        Self::Backward,
        Self::Left,
        Self::Right,
        Self::Up,
        Self::Down,
    ];
}
