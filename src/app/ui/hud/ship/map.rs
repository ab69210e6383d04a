//! The map: the path ahead and, beside the card at the end of a mission, the path that was flown.

use super::map_view::{Chart, draw_map, map_height};
use crate::app::motion::ship::ShipFlight;
use crate::app::state::overlays::{Overlays, PathShown};
use crate::app::state::preferences::Preferences;
use crate::app::ui::layout::{GAP, Layout, Slide, Wish};
use crate::app::ui::screen::{BOX, Screen};
use bevy::prelude::*;
use bevy_egui::egui::{Align2, LayerId, Order, Rect, vec2};
use glam::DVec3;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::ship::{Attempt, path_ahead};
use std::time::Duration;

/// Widths in which the map is tried, in points, and those beside the card at the end.
const WIDTHS: [f32; 2] = [230.0, 150.0];
const WIDTHS_AT_END: [f32; 3] = [300.0, 230.0, 150.0];
/// Room inside the box, in points.
const PADDING: f32 = 8.0;
/// How long a path is drawn before it is computed again, which takes half a millisecond.
const PATH_AGE: Duration = Duration::from_millis(100);
/// Number of points of the path: two turns.
const PATH_POINTS: usize = 256;

pub(in crate::app::ui::hud) fn show_map(
    mut screen: Screen,
    ship: Res<ShipFlight>,
    overlays: Res<Overlays>,
    preferences: Res<Preferences>,
    time: Res<Time<Real>>,
    mut known: Local<Option<(Duration, Vec<DVec3>)>>,
) {
    let Some(voyage) = ship.voyage() else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let at_end = ship.attempt().and_then(|attempt| end_of(attempt, layout));
    let placed = match &at_end {
        Some((_, card)) => place(layout, &WIDTHS_AT_END, beside(*card)),
        None if overlays.path == PathShown::MapAndLine => {
            let wish = layout.at(Align2::RIGHT_TOP, Slide::Upright);
            place(layout, &WIDTHS, wish)
        }
        None => None,
    };
    let Some(place) = placed else {
        return;
    };
    let now = time.elapsed();
    let is_old = |(since, _): &(Duration, Vec<DVec3>)| now.saturating_sub(*since) > PATH_AGE;
    if at_end.is_none() && known.as_ref().is_none_or(is_old) {
        let path = path_ahead(&voyage.flight.ship, PATH_POINTS).into_iter();
        *known = Some((now, path.map(|point| point.place).collect()));
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
    let layer = LayerId::new(Order::Background, "map".into());
    let painter = context.layer_painter(layer);
    painter.rect_filled(place, 5.0, BOX);
    draw_map(
        &painter,
        place.shrink(PADDING),
        &chart,
        preferences.settings.units(),
    );
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

/// The place of the largest map for which there is room.
fn place(layout: &mut Layout, widths: &[f32], wish: Wish) -> Option<Rect> {
    widths.iter().find_map(|width| {
        let size = vec2(*width, map_height(*width)) + 2.0 * vec2(PADDING, PADDING);
        layout.place("map", size, wish)
    })
}
