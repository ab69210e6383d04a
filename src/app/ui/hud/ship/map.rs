//! The map: the path ahead from above and from the side, with the radii that matter.

use crate::app::motion::ship::ShipFlight;
use crate::app::state::overlays::{Overlays, PathShown};
use crate::app::state::preferences::Preferences;
use crate::app::ui::hud::board::{BRIGHT, QUIET};
use crate::app::ui::layout::Slide;
use crate::app::ui::screen::{BOX, Screen};
use crate::app::ui::theme::ACCENT;
use bevy::prelude::*;
use bevy_egui::egui::{
    Align2, Color32, FontId, LayerId, Order, Painter, Pos2, Rect, Shape, Stroke, pos2, vec2,
};
use glam::{DVec2, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::ship::Ship;
use lightfall_core::numbers::three_digits;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::path_ahead;
use std::f64::consts::TAU;
use std::time::Duration;

/// Widths in which the map is tried, in points.
const WIDTHS: [f32; 2] = [230.0, 150.0];
/// Height of the view from the side, as a share of the width.
const SIDE: f32 = 0.55;
/// Height of a line of words, and their size, in points.
const LINE: f32 = 16.0;
const WORDS: f32 = 12.0;
/// Room inside the box, in points.
const PADDING: f32 = 8.0;
/// How much larger the map is than the path.
const ROOM: f64 = 1.12;
/// How long a path is drawn before it is computed again, which takes half a millisecond.
const PATH_AGE: Duration = Duration::from_millis(100);
/// Number of points of the path: two turns.
const PATH_POINTS: usize = 256;
/// Number of sides of a circle.
const SIDES: usize = 72;

const HORIZON: Color32 = Color32::from_gray(150);
const ERGOSPHERE: Color32 = Color32::from_rgb(190, 130, 255);
const PHOTON: Color32 = Color32::from_rgb(255, 225, 120);
const ISCO: Color32 = Color32::from_rgb(130, 220, 160);

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
}

/// A closed curve in the plane of two axes, by its radius.
fn circle(radius: impl Fn(f64) -> f64, [right, up]: [DVec3; 2]) -> impl Iterator<Item = DVec3> {
    (0..=SIDES).map(move |side| {
        let angle = side as f64 / SIDES as f64 * TAU;
        let DVec2 { x, y } = DVec2::from_angle(angle);
        radius(y) * (x * right + y * up)
    })
}

pub(in crate::app::ui::hud) fn show_map(
    mut screen: Screen,
    ship: Res<ShipFlight>,
    overlays: Res<Overlays>,
    preferences: Res<Preferences>,
    time: Res<Time<Real>>,
    mut known: Local<Option<(Duration, Vec<DVec3>)>>,
) {
    let Some(voyage) = ship
        .voyage()
        .filter(|_| overlays.path == PathShown::MapAndLine)
    else {
        return;
    };
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let wish = layout.at(Align2::RIGHT_TOP, Slide::Upright);
    let placed = WIDTHS.into_iter().find_map(|width| {
        let height = width * (1.0 + SIDE) + 3.0 * LINE + 3.0 * PADDING;
        layout.place("map", vec2(width + 2.0 * PADDING, height), wish)
    });
    let Some(place) = placed else {
        return;
    };
    let ship = &voyage.flight.ship;
    let now = time.elapsed();
    if known
        .as_ref()
        .is_none_or(|(since, _)| now.saturating_sub(*since) > PATH_AGE)
    {
        let path = path_ahead(ship, PATH_POINTS).into_iter();
        *known = Some((now, path.map(|point| point.place).collect()));
    }
    let Some((_, path)) = &*known else {
        return;
    };
    let layer = LayerId::new(Order::Background, "map".into());
    let painter = context.layer_painter(layer);
    painter.rect_filled(place, 5.0, BOX);
    draw(
        &painter,
        place.shrink(PADDING),
        (ship, path),
        preferences.settings.units(),
    );
}

fn draw(painter: &Painter, inside: Rect, (ship, path): (&Ship, &[DVec3]), units: Units) {
    let place = ship.place();
    let now = place.r * place.n;
    let farthest = path.iter().map(|place| place.length()).fold(1.5, f64::max);
    let width = inside.width();
    let highest = path.iter().map(|place| place.z.abs()).fold(0.0, f64::max);
    // One scale for both views.
    let largest = farthest.max(highest / f64::from(SIDE));
    let scale = 0.5 * width / (ROOM * largest) as f32;
    let words = |at: Pos2, anchor, text: &str, colour| {
        painter.text(at, anchor, text, FontId::proportional(WORDS), colour);
    };
    let above = Rect::from_min_size(inside.min + vec2(0.0, LINE), vec2(width, width));
    let side = Rect::from_min_size(
        above.left_bottom() + vec2(0.0, LINE + PADDING),
        vec2(width, SIDE * width),
    );
    words(inside.min, Align2::LEFT_TOP, "from above", QUIET);
    let reach = units.length(farthest, three_digits);
    words(inside.right_top(), Align2::RIGHT_TOP, &reach, BRIGHT);
    words(
        side.min - vec2(0.0, LINE),
        Align2::LEFT_TOP,
        "from the side",
        QUIET,
    );
    let out = now.with_z(0.0).try_normalize().unwrap_or(DVec3::X);
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
        draw_hole(&view, ship.kerr());
        view.line(path.iter().copied(), ACCENT, 1.6);
        draw_ship(&view, now, path);
    }
    draw_key(painter, side.left_bottom() + vec2(0.0, 2.0), ship.kerr());
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
    let radius = kerr.horizon() as f32 * view.scale;
    let middle = view.frame.center();
    view.painter
        .circle(middle, radius, Color32::BLACK, Stroke::new(1.5, HORIZON));
}

/// The ship, with a line along its way, and the lowest point of the path.
fn draw_ship(view: &View, place: DVec3, path: &[DVec3]) {
    let lowest = path
        .iter()
        .min_by(|a, b| a.length().total_cmp(&b.length()))
        .copied();
    if let Some(lowest) = lowest {
        view.painter
            .circle_stroke(view.at(lowest), 3.0, Stroke::new(1.4, ACCENT));
    }
    let now = view.at(place);
    if let [first, second, ..] = path {
        let way = (view.at(*second) - view.at(*first)).normalized();
        if way.is_finite() {
            view.painter
                .line_segment([now, now + 10.0 * way], Stroke::new(2.0, BRIGHT));
        }
    }
    view.painter.circle_filled(now, 3.5, BRIGHT);
}

/// What the colours mean.
fn draw_key(painter: &Painter, at: Pos2, kerr: Kerr) {
    let mut words = vec![
        ("horizon", HORIZON),
        ("light's", PHOTON),
        ("stable orbits", ISCO),
    ];
    if kerr.spin != 0.0 {
        words.insert(1, ("ergosphere", ERGOSPHERE));
    }
    let mut left = at.x;
    for (word, colour) in words {
        let font = FontId::proportional(0.88 * WORDS);
        let drawn = painter.text(pos2(left, at.y), Align2::LEFT_TOP, word, font, colour);
        left = drawn.right() + 6.0;
    }
}
