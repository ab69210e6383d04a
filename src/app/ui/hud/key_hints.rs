//! The most important keys, in the lower right corner: a few at first, until the user has used some
//! of them, and afterwards only the key of the help, while the mouse moves.

use super::board::{BRIGHT, Board, MARGIN, MIN_WIDTH, QUIET, TEXT, free_room};
use super::presence::{Presence, keep_fading};
use super::read_outs::ReadOutsWidth;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::input::held::HeldControls;
use crate::app::input::typing::Typing;
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::state::overlays::Overlays;
use crate::app::state::preferences::Preferences;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use std::collections::BTreeSet;

/// After so many different controls the keys are no longer named.
const ENOUGH_CONTROLS: usize = 8;
/// After so many seconds of flying by hand, too.
const ENOUGH_FLIGHT: f32 = 60.0;

/// Room between two keys, and between a key and what it does, in points.
const GAP: f32 = 12.0;
const SPACE: f32 = 4.0;

/// What a newcomer has tried since the keys were last named anew.
#[derive(Resource, Default)]
struct Tried {
    controls: BTreeSet<&'static str>,
    /// Seconds of flying by hand.
    flight: f32,
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Tried>()
        .add_systems(Update, (watch_use, name_keys_again))
        .add_systems(EguiPrimaryContextPass, show_key_hints);
}

/// Stops naming the keys once they have been used.
fn watch_use(
    time: Res<Time<Real>>,
    keys: Res<ButtonInput<KeyCode>>,
    bindings: Res<Bindings>,
    typing: Res<Typing>,
    held: HeldControls,
    mut tried: ResMut<Tried>,
    mut preferences: ResMut<Preferences>,
) {
    if !preferences.settings.key_hints || typing.0 {
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

/// Names the keys again once the help has been asked for.
fn name_keys_again(
    mut commands: MessageReader<AppCommand>,
    mut tried: ResMut<Tried>,
    mut preferences: ResMut<Preferences>,
) {
    if commands.read().any(|command| *command == AppCommand::Help) {
        *tried = Tried::default();
        preferences.settings.key_hints = true;
    }
}

/// A key as it is bound, and what it does.
struct KeyHint {
    key: String,
    does: &'static str,
    /// Where the room is narrow, the hints of the lowest rank are left out first.
    rank: u8,
}

/// Keys that are named together: the controls, what stands between their keys, what they do, and
/// the rank of the hint.
type Row = (&'static [&'static str], &'static str, &'static str, u8);

/// The keys that a newcomer needs, besides the mouse.
const NEWCOMERS_KEYS: &[Row] = &[
    (
        &["fly.forward", "fly.left", "fly.backward", "fly.right"],
        "",
        "fly",
        5,
    ),
    (&["preset.1", "preset.9"], "–", "places", 1),
    (&["motion.let_go"], "", "fall", 2),
    (&["journey.fly"], "", "journey", 3),
    (&["picture.bypass"], "", "pixel look", 6),
    (&["fly.escape"], "", "menu", 4),
    (&["window.help"], "", "all keys", 7),
];

/// The keys that matter during a journey.
const JOURNEY_KEYS: &[Row] = &[
    (&["motion.pause"], "", "pause", 3),
    (&["journey.back", "journey.ahead"], " · ", "back, ahead", 1),
    (&["journey.fly"], "", "stop", 2),
    (&["scene.undo"], "", "back to the start", 0),
    (&["window.help"], "", "all keys", 4),
];

/// The keys that matter during a fall.
const FALL_KEYS: &[Row] = &[
    (&["motion.pause"], "", "pause", 3),
    (
        &["motion.slower", "motion.faster"],
        " · ",
        "slower, faster",
        2,
    ),
    (&["fly.face"], "", "face", 0),
    (&["scene.undo"], "", "back", 1),
    (&["window.help"], "", "all keys", 4),
];

/// The hints of these rows, with the keys as they are bound.
fn hints(rows: &[Row], bindings: &Bindings) -> Vec<KeyHint> {
    let hint = |&(ids, between, does, rank): &Row| {
        let keys: Vec<_> = ids.iter().map(|id| bindings.first_label(id)).collect();
        KeyHint {
            key: keys.join(between),
            does,
            rank,
        }
    };
    rows.iter().map(hint).collect()
}

/// The keys that a newcomer needs. The mouse comes after the keys that fly.
fn newcomers_keys(bindings: &Bindings) -> Vec<KeyHint> {
    let mut keys = hints(NEWCOMERS_KEYS, bindings);
    let mouse = KeyHint {
        key: "right mouse button".into(),
        does: "drag to look",
        rank: 0,
    };
    keys.insert(1, mouse);
    keys
}

fn show_key_hints(
    mut contexts: EguiContexts,
    bindings: Res<Bindings>,
    overlays: Res<Overlays>,
    preferences: Res<Preferences>,
    presence: Res<Presence>,
    (player, free_fall): (Res<JourneyPlayer>, Res<FreeFall>),
    beside: Res<ReadOutsWidth>,
) -> Result {
    let context = contexts.ctx_mut()?;
    let room = free_room(context, &overlays);
    if overlays.hidden || room.width() < MIN_WIDTH {
        return Ok(());
    }
    // A newcomer's keys stay until they have been used.
    let named = preferences.settings.key_hints;
    let strength = if named { 1.0 } else { presence.of_mouse() };
    if strength <= 0.0 {
        return Ok(());
    }
    keep_fading(context, strength);
    let free = room.width() - beside.0 - 3.0 * MARGIN;
    let mut keys = if player.is_playing() {
        hints(JOURNEY_KEYS, &bindings)
    } else if free_fall.is_moving() {
        hints(FALL_KEYS, &bindings)
    } else {
        newcomers_keys(&bindings)
    };
    if !named && !player.is_playing() && !free_fall.is_moving() {
        keys.drain(..keys.len() - 1);
    }
    while !keys.is_empty() {
        let mut board = Board::new(context, "key hints", strength);
        if put_keys(&mut board, &keys) <= free {
            board.paint(egui::Align2::RIGHT_BOTTOM, room.right_bottom());
            break;
        }
        let lowest = keys.iter().map(|hint| hint.rank).min();
        keys.retain(|hint| Some(hint.rank) != lowest);
    }
    Ok(())
}

/// Puts keys and what they do into a line. Returns its width.
fn put_keys(board: &mut Board, keys: &[KeyHint]) -> f32 {
    let mut right = 0.0;
    for (place, KeyHint { key, does, .. }) in keys.iter().enumerate() {
        if place > 0 {
            right += GAP;
        }
        for (text, colour) in [(key.as_str(), BRIGHT), (*does, QUIET)] {
            let text = board.text(text, TEXT, colour, f32::INFINITY);
            let width = text.size().x;
            board.put(egui::vec2(right, 0.0), text);
            right += width + SPACE;
        }
    }
    right - SPACE
}
