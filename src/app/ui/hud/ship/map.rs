//! The map: the path ahead and, beside the card at the end of a mission, the path that was flown.

use super::map_view::{Chart, draw_map, key_lines, map_height, outside_horizon};
use crate::app::motion::ship::ShipFlight;
use crate::app::state::overlays::{Overlays, PathShown};
use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use crate::app::ui::layout::{GAP, Layout, Slide, Wish};
use crate::app::ui::screen::{BOX, Screen};
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2, LayerId, Order, Rect, Vec2, vec2};
use glam::DVec3;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::ship::{Attempt, path_ahead};
use std::time::Duration;

/// Widths in which the map is tried, in points.
const WIDTHS: [f32; 2] = [230.0, 150.0];
/// Room inside the box, in points.
const PADDING: f32 = 8.0;
/// How long a path is drawn before it is computed again, which takes half a millisecond.
const PATH_AGE: Duration = Duration::from_millis(100);
/// Number of points of the path: two turns.
const PATH_POINTS: usize = 256;
/// What is said where the map is chosen and has no place.
const NO_ROOM: &str =
    "The map has no room in this window: a larger window, or smaller texts, make room for it";

pub(super) fn map_painter(context: &egui::Context) -> egui::Painter {
    context.layer_painter(LayerId::new(Order::Background, "map".into()))
}

pub(in crate::app::ui::hud) fn show_map(
    mut screen: Screen,
    ship: Res<ShipFlight>,
    overlays: Res<Overlays>,
    preferences: Res<Preferences>,
    (time, mut toast): (Res<Time<Real>>, ResMut<Toast>),
    mut known: Local<Option<(Duration, Vec<DVec3>)>>,
    mut before: Local<PathShown>,
) {
    let Some(voyage) = ship.voyage() else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let is_chosen = overlays.path == PathShown::MapAndLine && *before != overlays.path;
    *before = overlays.path;
    if is_chosen && layout.place_of("map").is_none() {
        toast.say(NO_ROOM);
    }
    let at_end = ship.attempt().and_then(|attempt| end_of(attempt, layout));
    let painter = map_painter(context);
    let kerr = voyage.flight.ship.kerr();
    let placed = match &at_end {
        // In a window that has no place for the map, the path that was flown has what is left.
        Some((_, card)) => layout
            .place_of("map")
            .or_else(|| place((&painter, layout), beside(*card), kerr)),
        None if overlays.path == PathShown::MapAndLine => layout.place_of("map"),
        None => None,
    };
    let Some(place) = placed else {
        return;
    };
    let now = time.elapsed();
    let is_old = |(since, _): &(Duration, Vec<DVec3>)| now.saturating_sub(*since) > PATH_AGE;
    if at_end.is_none() && known.as_ref().is_none_or(is_old) {
        let path = path_ahead(&voyage.flight.ship, PATH_POINTS).into_iter();
        let path: Vec<DVec3> = path.map(|point| point.place).collect();
        *known = Some((now, outside_horizon(kerr.horizon(), &path)));
    }
    let flown: Vec<DVec3> = match (&at_end, ship.track()) {
        (Some(_), Some(track)) => track.places().collect(),
        _ => Vec::new(),
    };
    let ahead = match (&at_end, &*known) {
        (None, Some((_, path))) => &path[..],
        _ => &[],
    };
    let drawn = at_end.as_ref().map_or(&voyage.flight.ship, |end| end.0);
    let here = drawn.place();
    let chart = Chart {
        kerr: drawn.kerr(),
        ship: here.r * here.n,
        ahead,
        flown: &flown,
        goals: &ship.goal_radii(),
    };
    painter.rect_filled(place, 5.0, BOX);
    let inside = place.shrink(PADDING);
    let key = key_lines(&painter, kerr, inside.width());
    let units = ship.units(&preferences.settings);
    draw_map(&painter, inside, (&chart, &key), units);
}

/// The ship at the end of a mission, and the card that tells it, while it is shown.
fn end_of<'a>(attempt: &'a Attempt, layout: &Layout) -> Option<(&'a Ship, Rect)> {
    let card = layout.place_of("end card").filter(|_| attempt.is_over())?;
    Some((&attempt.scored().flight.ship, card))
}

/// A wish for the left side of a card, over the hole if need be.
fn beside(card: Rect) -> Wish {
    Wish {
        anchor: Align2::RIGHT_TOP,
        at: card.left_top() - vec2(GAP, 0.0),
        slide: Slide::Anywhere,
        covers_hole: true,
    }
}

/// The sizes in which the map is tried, the largest first.
pub(super) fn map_sizes(painter: &egui::Painter, kerr: Kerr) -> Vec<Vec2> {
    let size = |width: f32| {
        let lines = key_lines(painter, kerr, width).len();
        vec2(width, map_height(width, lines)) + 2.0 * vec2(PADDING, PADDING)
    };
    WIDTHS.into_iter().map(size).collect()
}

/// The place of the largest map for which there is room.
fn place((painter, layout): (&egui::Painter, &mut Layout), wish: Wish, kerr: Kerr) -> Option<Rect> {
    let sizes = map_sizes(painter, kerr);
    sizes
        .into_iter()
        .find_map(|size| layout.place("map", size, wish))
}
