//! The places of what a pilot always sees: the instruments with their clocks, the map, the goals and the
//! messages. They follow from the free part of the window and from what the flight shows from its beginning
//! to its end. Nothing that is said on the way moves them.

use crate::app::ui::layout::GAP;
use bevy::prelude::Resource;
use bevy_egui::egui::{Align2, Rect, Vec2, pos2, vec2};

/// Width of the instruments, and the least one, in points.
const INSTRUMENTS: f32 = 398.0;
const MIN_INSTRUMENTS: f32 = 200.0;
/// The largest share of the height that the instruments take, and the clocks alone.
const MAX_INSTRUMENTS: f32 = 0.52;
const MAX_CLOCKS: f32 = 0.5;
/// The largest share of the width that the map takes.
const MAX_MAP: f32 = 1.0 / 3.0;
/// The room for messages: the least width, and the height, which two lines of small letters need, in points.
const MIN_MESSAGE: f32 = 200.0;
const MESSAGE: f32 = 46.0;
/// Largest width of the goals with the edges of their box, in points.
const GOALS: f32 = 450.0;
/// Least width of a caption beside the goals, and the height that is left for one below them, in points.
const MIN_CAPTION: f32 = 300.0;
const CAPTION: f32 = 90.0;

/// What a flight shows from its beginning to its end.
#[derive(Clone, Debug)]
pub struct PilotNeeds {
    /// Height of the clocks with the edges of their box, in points.
    pub clocks: f32,
    /// Height of a row of the instruments with the room above it, in points.
    pub row: f32,
    /// The most rows: of all instruments, of those that are not minor, and of those that are needed.
    pub rows: [usize; 3],
    /// Sizes of the map, the largest first. Empty where it is hidden.
    pub maps: Vec<Vec2>,
}

/// What a pilot always sees, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PilotPlaces {
    /// The instruments with their clocks. None in a window that has no room for them, as for the others.
    pub instruments: Option<Rect>,
    /// Which instruments they are, as a place in [`PilotNeeds::rows`], and how many of them have room.
    pub choice: usize,
    /// See `choice`.
    pub rows: usize,
    /// The map.
    pub map: Option<Rect>,
    /// What is kept free for messages.
    pub messages: Option<Rect>,
    /// The largest place of the goals.
    pub goals: Rect,
}

/// The places of this frame. None without a pilot.
#[derive(Resource, Default)]
pub(in crate::app::ui::hud) struct PlacesNow(pub(super) Option<PilotPlaces>);

/// Divides the free part of the window: the instruments have its lower left corner, the map the upper right
/// one, the messages the lower right one or, where it is too narrow, a strip above the instruments, and the
/// goals the upper left corner.
#[must_use]
pub fn pilot_places(room: Rect, needs: &PilotNeeds) -> PilotPlaces {
    let height = room.height();
    let spare = MAX_INSTRUMENTS * height - needs.clocks;
    let most = (spare / needs.row).max(0.0) as usize;
    let fitting = needs.rows.iter().position(|rows| *rows <= most);
    let choice = fitting.unwrap_or(needs.rows.len() - 1);
    let rows = needs.rows[choice].min(most);
    let size = vec2(
        INSTRUMENTS.min(room.width()),
        needs.clocks + rows as f32 * needs.row,
    );
    let has_clocks = room.width() >= MIN_INSTRUMENTS && needs.clocks <= MAX_CLOCKS * height;
    let instruments = has_clocks.then(|| rounded(Align2::LEFT_BOTTOM, size, room));
    let map = needs.maps.iter().find_map(|size| {
        let place = rounded(Align2::RIGHT_TOP, *size, room);
        let is_small = size.x <= MAX_MAP * room.width() && size.y + GAP + MESSAGE <= height;
        let is_free = instruments.is_none_or(|other| !other.expand(GAP).intersects(place));
        (is_small && is_free).then_some(place)
    });
    let right = map.map_or(room.right(), |map| map.left() - GAP);
    let floor = instruments.map_or(room.bottom(), |it| it.top() - GAP);
    let above = Rect::from_min_max(room.min, pos2(right, floor));
    let beside = instruments.map(|it| Rect {
        min: pos2(it.right() + GAP, room.top()),
        ..room
    });
    let beside = beside.filter(|part| part.width() >= MIN_MESSAGE);
    let strip = lower_part(beside.unwrap_or(above));
    let has_strip = strip.top() >= room.top() && strip.width() >= MIN_MESSAGE;
    let messages = has_strip.then_some(strip);
    let floor = match (beside, messages) {
        (None, Some(strip)) => strip.top() - GAP,
        _ => floor,
    };
    PilotPlaces {
        instruments,
        choice,
        rows,
        map,
        messages,
        goals: goals(above, floor),
    }
}

/// A place of this size at a corner, at whole points, which keep the letters sharp.
fn rounded(corner: Align2, size: Vec2, room: Rect) -> Rect {
    let place = corner.align_size_within_rect(size, room);
    Rect::from_min_size(place.min.round(), size)
}

/// The part at the lower edge that messages have.
fn lower_part(room: Rect) -> Rect {
    Rect {
        min: pos2(room.left(), room.bottom() - MESSAGE),
        ..room
    }
}

/// The largest place of the goals in the part that is left of the map: a caption has room beside them or,
/// in a narrow window, below them.
fn goals(room: Rect, floor: f32) -> Rect {
    let width = GOALS.min(room.width());
    let has_side = room.width() - width - GAP >= MIN_CAPTION;
    let below = if has_side { 0.0 } else { CAPTION + GAP };
    let height = (floor - room.top() - below).max(0.0);
    Rect::from_min_size(room.min, vec2(width, height))
}
