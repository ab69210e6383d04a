//! The most important keys, in the lower right corner. At first these are the keys that a newcomer
//! needs. Once some have been used, only the key of the help appears, while the mouse moves.

use super::board::{BRIGHT, Board, QUIET, TEXT};
use super::presence::Presence;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::input::held::HeldControls;
use crate::app::input::typing::Typing;
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::motion::ship::ShipFlight;
use crate::app::state::helm::Helm;
use crate::app::state::kiosk::Kiosk;
use crate::app::state::preferences::Preferences;
use crate::app::ui::layout::Slide;
use crate::app::ui::screen::Screen;
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2};
use std::collections::BTreeSet;

/// Number of different controls after which the user counts as experienced.
const ENOUGH_CONTROLS: usize = 8;
/// Seconds of flying by hand after which the user counts as experienced.
const ENOUGH_FLIGHT: f32 = 60.0;

/// Room between two keys, and between a key and what it does, in points.
const GAP: f32 = 12.0;
const SPACE: f32 = 4.0;

/// What a newcomer has tried so far.
#[derive(Resource, Default)]
struct Tried {
    controls: BTreeSet<&'static str>,
    /// Seconds of flying by hand.
    flight: f32,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Tried>().add_systems(Update, watch_use);
}

/// Hides the newcomer's keys once they have been used, and shows them again after the help was asked
/// for, unless the user has chosen whether they are shown.
fn watch_use(
    mut commands: MessageReader<AppCommand>,
    time: Res<Time<Real>>,
    keys: Res<ButtonInput<KeyCode>>,
    bindings: Res<Bindings>,
    typing: Res<Typing>,
    held: HeldControls,
    mut tried: ResMut<Tried>,
    mut preferences: ResMut<Preferences>,
) {
    let asks_for_help = AppCommand::Help.count(&mut commands) > 0;
    if preferences.settings.keep_key_hints {
        return;
    }
    if asks_for_help {
        *tried = Tried::default();
        preferences.settings.key_hints = true;
    }
    if !preferences.settings.key_hints || typing.is_on() {
        return;
    }
    let used = bindings
        .iter()
        .filter(|(_, own)| keys.any_just_pressed(own.iter().copied()));
    for (control, _) in used {
        tried.controls.insert(control.id);
    }
    if held.any_flight() {
        tried.flight += time.delta_secs();
    }
    if tried.controls.len() >= ENOUGH_CONTROLS || tried.flight >= ENOUGH_FLIGHT {
        *tried = Tried::default();
        preferences.settings.key_hints = false;
    }
}

/// A hint: the controls, the text between their keys, what they do, and a rank. Without controls it is a
/// remark. If there is not enough room, the hints of the lowest rank are left out first.
type Hint = (&'static [&'static str], &'static str, &'static str, u8);

/// The keys that a newcomer needs.
const NEWCOMERS_KEYS: &[Hint] = &[
    (
        &["fly.forward", "fly.left", "fly.backward", "fly.right"],
        "",
        "fly",
        6,
    ),
    (&[MOUSE], "", "drag to look", 0),
    (&["preset.1", "preset.9"], "–", "places", 1),
    (&["motion.let_go"], "", "fall", 2),
    (&["journey.fly"], "", "journey", 3),
    (&["ship.fly"], "", "ship", 4),
    (&["picture.bypass"], "", "pixel look", 6),
    (&["fly.escape"], "", "menu", 5),
    ALL_KEYS,
];

/// The keys that matter during a journey.
const JOURNEY_KEYS: &[Hint] = &[
    (&["motion.pause"], "", "pause", 3),
    (&["journey.back", "journey.ahead"], " · ", "back, ahead", 1),
    (&["journey.fly"], "", "stop", 2),
    (&["scene.undo"], "", "back to the start", 0),
    ALL_KEYS,
];

/// The keys that matter during a lesson.
const LESSON_KEYS: &[Hint] = &[
    (&["fly.up", "preset.next"], " · ", "go on", 3),
    (&["preset.previous"], "", "back", 2),
    (&["journey.fly"], "", "leave", 1),
    ALL_KEYS,
];

/// The keys that matter during a fall.
const FALL_KEYS: &[Hint] = &[
    (&["motion.pause"], "", "pause", 3),
    (
        &["motion.slower", "motion.faster"],
        " · ",
        "slower, faster",
        2,
    ),
    (&["fly.face"], "", "face", 0),
    (&["scene.undo"], "", "back", 1),
    ALL_KEYS,
];

/// The keys that matter at the ship's controls.
const SHIP_KEYS: &[Hint] = &[
    (
        &["fly.forward", "fly.left", "fly.backward", "fly.right"],
        "",
        "push",
        7,
    ),
    (&["fly.face"], "", "nose", 5),
    (&["scene.spin"], "", "look", 4),
    (&["fly.orbit"], "", "orbit", 3),
    (&["scene.observer"], "", "still", 2),
    (&["motion.let_go"], "", "engine off", 4),
    (&["motion.slower", "motion.faster"], " · ", "time", 6),
    (&["ship.fly"], "", "leave", 1),
    ALL_KEYS,
];

/// The keys that matter aboard a ship whose tank is empty.
const EMPTY_KEYS: &[Hint] = &[
    (&[], "", "the tank is empty", 6),
    (&["fly.face"], "", "nose", 4),
    (&["scene.spin"], "", "look", 3),
    (&["motion.slower", "motion.faster"], " · ", "time", 6),
    (&["scene.undo"], "", "back", 5),
    (&["ship.fly"], "", "leave", 1),
    ALL_KEYS,
];

/// The keys that matter aboard a ship without an engine.
const DRIFT_KEYS: &[Hint] = &[
    (&["scene.spin"], "", "look", 4),
    (&["motion.slower", "motion.faster"], " · ", "time", 6),
    (&["ship.fly"], "", "leave", 1),
    ALL_KEYS,
];

/// The key of the help.
const ALL_KEYS: Hint = (&["window.help"], "", "all keys", 7);

/// The mouse, among the names of controls. It cannot be bound.
const MOUSE: &str = "right mouse button";

pub(super) fn show_key_hints(
    mut screen: Screen,
    bindings: Res<Bindings>,
    preferences: Res<Preferences>,
    presence: Res<Presence>,
    (player, free_fall): (Res<JourneyPlayer>, Res<FreeFall>),
    (helm, ship, kiosk): (Res<Helm>, Res<ShipFlight>, Res<Kiosk>),
) {
    // A newcomer's keys stay until they have been used.
    let named = preferences.settings.key_hints;
    let stays = named || helm.has_ship() && !preferences.settings.keep_key_hints;
    let strength = if stays { 1.0 } else { presence.of_mouse() };
    let Some((context, layout)) = screen.texts().filter(|_| strength > 0.0) else {
        return;
    };
    let wish = layout.at(Align2::RIGHT_BOTTOM, Slide::Nowhere);
    let mut hints = if player.has_lesson() {
        LESSON_KEYS.to_vec()
    } else if player.is_playing() {
        JOURNEY_KEYS.to_vec()
    } else if free_fall.is_moving() {
        FALL_KEYS.to_vec()
    } else if helm.has_ship() {
        if ship.can_push() {
            SHIP_KEYS.to_vec()
        } else if ship.has_engine() {
            EMPTY_KEYS.to_vec()
        } else {
            DRIFT_KEYS.to_vec()
        }
    } else if named || kiosk.is_on() {
        NEWCOMERS_KEYS.to_vec()
    } else {
        vec![ALL_KEYS]
    };
    // What visitors may not do is not offered.
    hints.retain(|(ids, ..)| ids.iter().all(|id| kiosk.offers_control(id)));
    while !hints.is_empty() {
        let mut board = Board::new(context, "key hints", strength);
        put_hints(&mut board, &hints, &bindings);
        if board.paint(layout, wish).is_some() {
            break;
        }
        let lowest = hints.iter().map(|(.., rank)| *rank).min();
        hints.retain(|(.., rank)| Some(*rank) != lowest);
    }
}

/// Puts hints into a line.
fn put_hints(board: &mut Board, hints: &[Hint], bindings: &Bindings) {
    let key = |id: &&str| match *id {
        MOUSE => MOUSE.to_owned(),
        id => bindings.first_name(id),
    };
    let mut right = 0.0;
    for (ids, between, does, _) in hints {
        let keys = ids.iter().map(key).collect::<Vec<_>>().join(between);
        for (text, colour) in [(keys.as_str(), BRIGHT), (does, QUIET)] {
            if text.is_empty() {
                continue;
            }
            let text = board.text(text, TEXT, colour, f32::INFINITY);
            let width = text.size().x;
            board.put(egui::vec2(right, 0.0), text);
            right += width + SPACE;
        }
        right += GAP;
    }
}
