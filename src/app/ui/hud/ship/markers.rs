//! Marks in the picture: the nose, and the directions along and against the ship's motion.

use crate::app::motion::ship::ShipFlight;
use crate::app::ui::hud::board::{BRIGHT, TEXT};
use crate::app::ui::layout::Layout;
use crate::app::ui::picture_in_window::{PictureInWindow, SceneSide};
use crate::app::ui::screen::{BOX, MARGIN, Screen, draw_below_boxes};
use crate::app::ui::theme::ACCENT;
use bevy::prelude::*;
use bevy_egui::egui::{self, Align2, Color32, FontId, Painter, Pos2, Rect, Stroke, vec2};
use lightfall_core::optics::ship::Heading;
use lightfall_core::scene::mission::Look;

/// Radius of a mark, in points, and of the dot of the nose.
const MARK: f32 = 9.0;
const NOSE: f32 = 5.0;
/// Distances of a mark's name from it, in points.
const DISTANCES: [f32; 2] = [14.0, 24.0];
/// Room inside the box of a name, in points.
const PADDING: egui::Vec2 = vec2(5.0, 2.0);

pub(in crate::app::ui::hud) fn show_markers(
    mut screen: Screen,
    picture: PictureInWindow,
    ship: Res<ShipFlight>,
) {
    let Some(voyage) = ship.voyage() else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let shown = picture.shown_part(SceneSide::Current, context);
    let visible = shown.intersect(layout.bounds().expand(MARGIN));
    if !visible.is_positive() {
        return;
    }
    let placement = picture.placement(context);
    // The headings are on the axes of the ship, from which the camera is turned and its picture tilted.
    let own = &picture.scene().camera;
    let tilt = own.tetrad_from_camera().transpose() * own.heading();
    let camera = tilt * ship.mount().0.transpose();
    let headings = [
        (Heading::Prograde, "prograde"),
        (Heading::Retrograde, "retrograde"),
    ];
    let marks = headings.into_iter().filter_map(|(heading, name)| {
        let direction = heading.direction(&voyage.flight.ship)?;
        let place = placement.of_looking(camera * direction)?;
        visible.contains(place).then_some((heading, name, place))
    });
    let marks: Vec<_> = marks.collect();
    let nose = placement.of_looking(camera * glam::DVec3::X);
    let looks_elsewhere = ship.look() != Look::Nose;
    draw_below_boxes(context, "ship's marks", visible, |painter| {
        if let Some(nose) = nose {
            draw_nose(painter, nose);
            if looks_elsewhere && visible.contains(nose) {
                draw_name((painter, layout), "nose", nose, visible);
            }
        }
        for (heading, name, place) in marks {
            draw_mark(painter, place, heading == Heading::Prograde);
            draw_name((painter, layout), name, place, visible);
        }
    });
}

/// A line on a dark one, so that it is seen on every picture.
fn draw_line(painter: &Painter, ends: [Pos2; 2], colour: Color32) {
    painter.line_segment(ends, Stroke::new(4.0, Color32::from_black_alpha(150)));
    painter.line_segment(ends, Stroke::new(1.8, colour));
}

/// Four short lines around the point to which the nose points.
fn draw_nose(painter: &Painter, at: Pos2) {
    for way in [
        vec2(1.0, 0.0),
        vec2(-1.0, 0.0),
        vec2(0.0, 1.0),
        vec2(0.0, -1.0),
    ] {
        draw_line(painter, [at + NOSE * way, at + 2.4 * NOSE * way], BRIGHT);
    }
}

/// A ring: with lines outward along the motion, and with a cross in it against the motion.
fn draw_mark(painter: &Painter, at: Pos2, along: bool) {
    painter.circle_stroke(at, MARK, Stroke::new(4.0, Color32::from_black_alpha(150)));
    painter.circle_stroke(at, MARK, Stroke::new(1.8, ACCENT));
    let ways = [vec2(-1.0, 0.0), vec2(1.0, 0.0), vec2(0.0, -1.0)];
    let slanting = [vec2(0.7, 0.7), vec2(0.7, -0.7)];
    if along {
        for way in ways {
            draw_line(painter, [at + MARK * way, at + 1.7 * MARK * way], ACCENT);
        }
        painter.circle_filled(at, 2.0, ACCENT);
    } else {
        for way in slanting {
            draw_line(painter, [at - MARK * way, at + MARK * way], ACCENT);
        }
    }
}

/// Draws the name of a mark beside it, if there is room.
pub(super) fn draw_name(
    (painter, layout): (&Painter, &mut Layout),
    name: &'static str,
    at: Pos2,
    within: Rect,
) {
    let font = FontId::proportional(TEXT);
    let words = painter.layout_no_wrap(name.to_owned(), font, ACCENT);
    let size = words.size() + 2.0 * PADDING;
    if let Some(place) = layout.place_beside(name, at, size, &DISTANCES, within) {
        painter.rect_filled(place, 4.0, BOX);
        let corner = Align2::LEFT_TOP.pos_in_rect(&place) + PADDING;
        painter.galley(corner, words, ACCENT);
    }
}
