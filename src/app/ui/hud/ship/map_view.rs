//! Draws the map's two views of a path: from above and from the side, with the radii that matter.

use crate::app::ui::hud::board::{BRIGHT, QUIET};
use crate::app::ui::theme::ACCENT;
use bevy_egui::egui::{
    Align2, Color32, FontId, Galley, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2,
};
use glam::{DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::numbers::three_digits;
use lightfall_core::optics::readout::units::Units;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Height of the view from the side, as a share of the width.
const SIDE: f32 = 0.55;
/// Height of a line of words, and their size, in points.
const LINE: f32 = 16.0;
const WORDS: f32 = 12.0;
/// Height of a line of the key, size of its words and room between them, in points.
const KEY_LINE: f32 = 14.0;
const KEY_WORDS: f32 = 10.5;
const KEY_GAP: f32 = 6.0;
/// Room between the views, in points.
const BETWEEN: f32 = 8.0;
/// How much larger the map is than the path.
const ROOM: f64 = 1.12;
/// The smallest radius that a map shows, in r_s.
const LEAST: f64 = 1.5;
/// The smallest radius of the horizon's disk, in points.
const MIN_HOLE: f32 = 4.0;
/// Two points of a path that was flown are joined if they are no farther apart than this share of the
/// radius: a longer line would lead through the hole.
const MAX_CHORD: f64 = 0.7;
/// A point of a path below so many radii of the horizon is where it leads in.
const ABOVE_HORIZON: f64 = 1.000_001;
/// Number of sides of a circle.
const SIDES: usize = 72;

const HORIZON: Color32 = Color32::from_gray(150);
const ERGOSPHERE: Color32 = Color32::from_rgb(190, 130, 255);
const PHOTON: Color32 = Color32::from_rgb(255, 225, 120);
const ISCO: Color32 = Color32::from_rgb(130, 220, 160);
const GOAL: Color32 = Color32::from_rgb(110, 190, 255);

/// What a map shows. Places and radii are in r_s.
pub(super) struct Chart<'a> {
    pub(super) kerr: Kerr,
    /// Where the ship is.
    pub(super) ship: DVec3,
    /// The path ahead.
    pub(super) ahead: &'a [DVec3],
    /// The path that was flown.
    pub(super) flown: &'a [DVec3],
    /// The radii of the next goal.
    pub(super) goals: &'a [f64],
}

/// Height of a map of this width with so many lines of its key, in points.
pub(super) fn map_height(width: f32, key_lines: usize) -> f32 {
    width * (1.0 + SIDE) + 2.0 * LINE + BETWEEN + KEY_LINE * key_lines as f32 + 2.0
}

/// The part of a path outside the horizon. One that leads inside ends on its circle: inside, the azimuth
/// winds faster than the points follow each other.
#[must_use]
pub fn outside_horizon(horizon: f64, path: &[DVec3]) -> Vec<DVec3> {
    let is_outside = |place: &&DVec3| place.length() > horizon;
    let mut outside: Vec<DVec3> = path.iter().take_while(is_outside).copied().collect();
    if let (Some(last), Some(inside)) = (outside.last().copied(), path.get(outside.len())) {
        let [high, low] = [last, *inside].map(DVec3::length);
        let way = (high - horizon) / (high - low);
        let crossing = last.lerp(*inside, way);
        outside.push(horizon * crossing.normalize_or(last / high));
    }
    outside
}

/// Half the width of both views of a map, in r_s: the places and the whole horizon lie in them.
#[must_use]
pub fn map_half_width<'a>(horizon: f64, places: impl Iterator<Item = &'a DVec3>) -> f64 {
    let (mut farthest, mut highest) = (LEAST, horizon);
    for place in places {
        farthest = farthest.max(place.length());
        highest = highest.max(place.z.abs());
    }
    ROOM * farthest.max(highest / f64::from(SIDE))
}

/// A view: where a place of space lies in it.
struct View<'a> {
    painter: &'a Painter,
    frame: Rect,
    /// Points for an r_s.
    scale: f32,
    /// The directions to the right and up.
    axes: [DVec3; 2],
}

impl View<'_> {
    fn at(&self, place: DVec3) -> Pos2 {
        let [right, up] = self.axes.map(|axis| place.dot(axis) as f32 * self.scale);
        self.frame.center() + vec2(right, -up)
    }

    fn line(&self, places: impl IntoIterator<Item = DVec3>, colour: Color32, width: f32) {
        let points: Vec<Pos2> = places.into_iter().map(|place| self.at(place)).collect();
        self.painter
            .add(Shape::line(points, Stroke::new(width, colour)));
    }

    /// A circle about the axis in the hole's equator.
    fn ring(&self, radius: f64, colour: Color32) {
        self.line(circle(|_| radius, [DVec3::X, DVec3::Y]), colour, 1.2);
    }

    /// A path that was flown. Points that are far apart, and those inside the horizon, are dots.
    fn trail(&self, places: &[DVec3], horizon: f64) {
        let is_joined = |a: &DVec3, b: &DVec3| {
            let lower = a.length().min(b.length());
            lower > horizon && (*a - *b).length() <= MAX_CHORD * lower
        };
        for run in places.chunk_by(is_joined) {
            match run {
                [place] => {
                    self.painter.circle_filled(self.at(*place), 1.2, ACCENT);
                }
                _ => self.line(run.iter().copied(), ACCENT, 1.6),
            }
        }
    }
}

/// A closed curve in the plane of two axes, by its radius.
fn circle(radius: impl Fn(f64) -> f64, [right, up]: [DVec3; 2]) -> impl Iterator<Item = DVec3> {
    (0..=SIDES).map(move |side| {
        let angle = side as f64 / SIDES as f64 * TAU;
        let DVec2 { x, y } = DVec2::from_angle(angle);
        radius(y) * (x * right + y * up)
    })
}

/// Draws a map of a height of [`map_height`], with the lines of its key.
pub(super) fn draw_map(
    painter: &Painter,
    inside: Rect,
    (chart, key): (&Chart, &[KeyLine]),
    units: Units,
) {
    let places = || chart.ahead.iter().chain(chart.flown);
    let half_width = map_half_width(chart.kerr.horizon(), places());
    let width = inside.width();
    // One scale for both views.
    let scale = 0.5 * width / half_width as f32;
    let words = |at: Pos2, anchor, text: &str, colour| {
        painter.text(at, anchor, text, FontId::proportional(WORDS), colour);
    };
    let above = Rect::from_min_size(inside.min + vec2(0.0, LINE), vec2(width, width));
    let side = Rect::from_min_size(
        above.left_bottom() + vec2(0.0, LINE + BETWEEN),
        vec2(width, SIDE * width),
    );
    let farthest = places()
        .map(|place| place.length())
        .fold(chart.ship.length(), f64::max);
    let reach = units.length(farthest, three_digits);
    let font = || FontId::proportional(WORDS);
    let width_of = |text: &str| {
        let text = painter.layout_no_wrap(text.to_owned(), font(), QUIET);
        text.size().x
    };
    words(inside.right_top(), Align2::RIGHT_TOP, &reach, BRIGHT);
    let room = width - width_of(&reach) - KEY_GAP;
    let above_words = ["from above", "above"];
    if let Some(name) = above_words.into_iter().find(|name| width_of(name) <= room) {
        words(inside.min, Align2::LEFT_TOP, name, QUIET);
    }
    words(
        side.min - vec2(0.0, LINE),
        Align2::LEFT_TOP,
        "from the side",
        QUIET,
    );
    let out = chart.ship.with_z(0.0).try_normalize().unwrap_or(DVec3::X);
    let views = [
        (above, [DVec3::X, DVec3::Y]),
        // From the side the ship is at the right.
        (side, [out, DVec3::Z]),
    ];
    for (frame, axes) in views {
        let painter = &painter.with_clip_rect(frame);
        let view = View {
            painter,
            frame,
            scale,
            axes,
        };
        draw_hole(&view, chart.kerr);
        for goal in chart.goals {
            // A smaller ring is hidden by the hole's disk.
            if *goal as f32 * scale > MIN_HOLE {
                view.ring(*goal, GOAL);
            }
        }
        view.trail(chart.flown, chart.kerr.horizon());
        view.line(chart.ahead.iter().copied(), ACCENT, 1.6);
        draw_ship(&view, chart);
    }
    draw_key(painter, side.left_bottom() + vec2(0.0, 2.0), key);
}

/// The hole and the radii around it.
fn draw_hole(view: &View, kerr: Kerr) {
    let is_from_above = view.axes[1] == DVec3::Y;
    view.ring(kerr.isco(), ISCO);
    for radius in [kerr.photon_orbit_prograde(), kerr.photon_orbit_retrograde()] {
        view.ring(radius, PHOTON);
    }
    if kerr.spin != 0.0 {
        let limit = |sine: f64| kerr.static_limit(if is_from_above { 0.0 } else { sine });
        view.line(circle(limit, view.axes), ERGOSPHERE, 1.2);
    }
    let radius = (kerr.horizon() as f32 * view.scale).max(MIN_HOLE);
    let middle = view.frame.center();
    view.painter
        .circle(middle, radius, Color32::BLACK, Stroke::new(1.5, HORIZON));
}

/// The ship, with a line along its way, and the lowest point of the path.
fn draw_ship(view: &View, chart: &Chart) {
    let path = chart.ahead.iter().chain(chart.flown);
    let lowest = path.min_by(|a, b| a.length().total_cmp(&b.length()));
    // A path that ends in the hole has none.
    let is_outside = |place: &&DVec3| place.length() > ABOVE_HORIZON * chart.kerr.horizon();
    if let Some(lowest) = lowest.filter(is_outside) {
        view.painter
            .circle_stroke(view.at(*lowest), 3.0, Stroke::new(1.4, ACCENT));
    }
    let now = view.at(chart.ship);
    if let [first, second, ..] = chart.ahead {
        let way = (view.at(*second) - view.at(*first)).normalized();
        if way.is_finite() {
            view.painter
                .line_segment([now, now + 10.0 * way], Stroke::new(2.0, BRIGHT));
        }
    }
    view.painter.circle_filled(now, 3.5, BRIGHT);
}

/// A line of the key: its words, each with its distance from the left, and their colours.
pub(super) type KeyLine = Vec<(f32, Arc<Galley>, Color32)>;

/// What the colours mean, in lines of at most this width. The goal's has its place also where the next goal
/// has no radius, so that the map keeps its size.
pub(super) fn key_lines(painter: &Painter, kerr: Kerr, width: f32) -> Vec<KeyLine> {
    let ergosphere = (kerr.spin != 0.0).then_some(("ergosphere", ERGOSPHERE));
    let words = [("horizon", HORIZON)].into_iter().chain(ergosphere).chain([
        ("light orbits", PHOTON),
        ("stable", ISCO),
        ("goal", GOAL),
    ]);
    let mut lines = vec![KeyLine::new()];
    let mut left = 0.0;
    for (word, colour) in words {
        let font = FontId::proportional(KEY_WORDS);
        let drawn = painter.layout_no_wrap(word.to_owned(), font, colour);
        let word_width = drawn.size().x;
        if left > 0.0 && left + word_width > width {
            lines.push(KeyLine::new());
            left = 0.0;
        }
        if let Some(line) = lines.last_mut() {
            line.push((left, drawn, colour));
        }
        left += word_width + KEY_GAP;
    }
    lines
}

fn draw_key(painter: &Painter, at: Pos2, lines: &[KeyLine]) {
    for (number, line) in lines.iter().enumerate() {
        let top = at.y + KEY_LINE * number as f32;
        for (left, word, colour) in line {
            painter.galley(pos2(at.x + left, top), word.clone(), *colour);
        }
    }
}
