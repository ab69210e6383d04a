//! The card over the picture that says where a flight has ended, and what can be done now.

use bevy::prelude::*;
use bevy::window::PrimaryWindow;

/// A control to name on the card: its name in the table, and what it does now.
pub(crate) type Way = (&'static str, &'static str);

/// What a lamp is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LampKind {
    Goals,
    Par,
    Time,
}

impl LampKind {
    /// Its word on the card.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Goals => "goals",
            Self::Par => "par",
            Self::Time => "time",
        }
    }
}

/// A lamp on the card: what it is for, and what it needed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Lamp {
    pub(crate) kind: LampKind,
    pub(crate) is_lit: bool,
    pub(crate) needed: String,
}

/// What closes the card.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Closes {
    /// Any key, click, touch or button.
    #[default]
    Anything,
    /// A key or a button of the ship, a click or a touch, which begins a mission.
    Flying,
    /// What the card names, and Esc: a key that is still pressed from the flight does not.
    Named,
}

/// What the card says. Empty while there is no card.
#[derive(Resource, Default)]
pub(crate) struct EndCard {
    pub(crate) title: String,
    pub(crate) text: String,
    pub(crate) lamps: Vec<Lamp>,
    /// What it says below the lamps.
    pub(crate) details: String,
    /// What can be done now, the nearest at hand first.
    pub(crate) ways: Vec<Way>,
    /// What closes it.
    pub(crate) closes: Closes,
}

impl EndCard {
    /// Shows the card. `first` is the nearest way to go on and `last` one more, if there is one;
    /// those between are the same everywhere.
    pub(crate) fn show(&mut self, title: &str, text: &str, first: Way, last: Option<Way>) {
        let others = [
            ("scene.undo", "back to where you were"),
            ("preset.next", "another place"),
            ("journey.again", "guided journey"),
        ];
        let others = others.into_iter().filter(|(id, _)| *id != first.0);
        *self = Self {
            title: title.into(),
            text: text.into(),
            ways: std::iter::once(first).chain(others).chain(last).collect(),
            ..Self::default()
        };
    }

    /// A card with these ways alone, which `closes` closes.
    pub(crate) fn new(title: &str, text: &str, ways: Vec<Way>, closes: Closes) -> Self {
        Self {
            title: title.into(),
            text: text.into(),
            ways,
            closes,
            ..Self::default()
        }
    }

    /// Whether the card names this control.
    pub(crate) fn names(&self, id: &str) -> bool {
        self.ways.iter().any(|(named, _)| *named == id)
    }

    pub(crate) fn close(&mut self) {
        *self = Self::default();
    }

    pub(crate) fn is_open(&self) -> bool {
        !self.title.is_empty()
    }
}

/// Where a click or a touch uses the card and does not close it: its buttons or, where it scrolls, all of
/// it. In logical pixels from the window's upper left corner.
#[derive(Resource, Default)]
pub(crate) struct CardButtons(pub(crate) Vec<Rect>);

impl CardButtons {
    /// Whether a place of the window is on them.
    pub(crate) fn have(&self, place: Vec2) -> bool {
        self.0.iter().any(|button| button.contains(place))
    }

    /// Whether the mouse is on them.
    pub(crate) fn have_mouse(&self, windows: &Query<&Window, With<PrimaryWindow>>) -> bool {
        let mouse = windows.iter().find_map(Window::cursor_position);
        mouse.is_some_and(|mouse| self.have(mouse))
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<EndCard>()
        .init_resource::<CardButtons>()
        .add_systems(PreUpdate, close_end_card.after(bevy::input::InputSystems));
}

/// The next key, click, touch or button closes a card that anything closes. Fingers have no keys: a touch
/// closes every card. A click or a touch on a button of the card uses it.
fn close_end_card(
    keys: Res<ButtonInput<KeyCode>>,
    buttons: Res<ButtonInput<MouseButton>>,
    touches: Res<Touches>,
    pads: Query<&Gamepad>,
    windows: Query<&Window, With<PrimaryWindow>>,
    card_buttons: Res<CardButtons>,
    mut end_card: ResMut<EndCard>,
) {
    let clicks = buttons.get_just_pressed().next().is_some();
    let used = keys.get_just_pressed().next().is_some()
        || clicks && !card_buttons.have_mouse(&windows)
        || pads
            .iter()
            .any(|pad| pad.get_just_pressed().next().is_some());
    let touched = touches
        .iter_just_pressed()
        .any(|touch| !card_buttons.have(touch.position()));
    let closes = used && end_card.closes == Closes::Anything || touched;
    if closes && end_card.is_open() {
        end_card.close();
    }
}
