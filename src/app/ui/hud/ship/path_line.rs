//! The path ahead as a line in the picture: where light from it arrives, as from a wire at rest.

use super::markers::draw_name;
use crate::app::motion::ship::ShipFlight;
use crate::app::state::overlays::{Overlays, PathShown};
use crate::app::ui::guides::{Placement, sky_of};
use crate::app::ui::picture_in_window::{PictureInWindow, SceneSide};
use crate::app::ui::screen::{MARGIN, Screen, draw_below_boxes};
use crate::app::ui::theme::ACCENT;
use bevy::prelude::*;
use bevy_egui::egui::{Color32, Painter, Pos2, Stroke};
use glam::DVec3;
use lightfall_core::optics::ship::{Apsis, SeenPath, seen_path};
use lightfall_core::scene::Scene;
use lightfall_platform::worker::Follower;
use lightfall_render::DrawnScene;

/// Width of the line and of its dark edge, in points, and the radius of a turning point's mark.
const WIDTH: f32 = 1.8;
const EDGE: f32 = 4.2;
const MARK: f32 = 4.5;
/// Opacity of the line's end. Its beginning is opaque, so that the line says which way the ship goes.
const LAST: f32 = 0.4;
/// A path belongs to the ship while its radius, as a share, its polar angle in degrees and its velocity in
/// c differ by less than this from those that the path was traced for.
const SAME_RADIUS: f64 = 0.02;
const SAME_ANGLE: f64 = 1.0;
const SAME_VELOCITY: f64 = 0.03;

/// The line of the path ahead.
#[derive(Resource)]
pub struct PathLine {
    /// The thread that traces it.
    tracer: Follower<Scene, SeenPath>,
    drawn: usize,
}

impl PathLine {
    /// How many points of it the last frame shows.
    #[must_use]
    pub fn drawn(&self) -> usize {
        self.drawn
    }
}

pub(in crate::app::ui::hud) fn path_plugin(app: &mut App) {
    let line = PathLine {
        // Where nothing can be flown there is no path.
        tracer: Follower::new(|sky| seen_path(sky).unwrap_or_default()),
        drawn: 0,
    };
    app.insert_resource(line).add_systems(Update, trace_path);
}

fn is_shown(ship: &ShipFlight, overlays: &Overlays) -> bool {
    ship.is_flown() && overlays.path != PathShown::Nothing && !overlays.hidden
}

fn trace_path(
    scene: Res<DrawnScene>,
    ship: Res<ShipFlight>,
    overlays: Res<Overlays>,
    mut line: ResMut<PathLine>,
) {
    line.drawn = 0;
    if is_shown(&ship, &overlays) {
        line.tracer.follow(sky_of(&scene));
    }
}

/// Whether a path that was traced for one scene is still that of another, as far as can be seen.
fn is_same_path(traced: &Scene, now: &Scene) -> bool {
    let velocity = |scene: &Scene| DVec3::from_array(scene.observer.velocity);
    traced.hole == now.hole
        && traced.effects == now.effects
        && traced.observer.kind == now.observer.kind
        && (traced.camera.r / now.camera.r - 1.0).abs() < SAME_RADIUS
        && (traced.camera.theta_deg - now.camera.theta_deg).abs() < SAME_ANGLE
        && velocity(traced).distance(velocity(now)) < SAME_VELOCITY
}

pub(in crate::app::ui::hud) fn show_path(
    mut screen: Screen,
    picture: PictureInWindow,
    ship: Res<ShipFlight>,
    overlays: Res<Overlays>,
    mut line: ResMut<PathLine>,
) {
    if !is_shown(&ship, &overlays) {
        return;
    }
    let Some((context, layout)) = screen.texts() else {
        return;
    };
    let now = sky_of(picture.scene());
    let traced = line.tracer.newest();
    let Some((_, path)) = traced.filter(|(traced, _)| is_same_path(traced, &now)) else {
        return;
    };
    let shown = picture.shown_part(SceneSide::Current, context);
    let visible = shown.intersect(layout.bounds().expand(MARGIN));
    if !visible.is_positive() {
        return;
    }
    let placement = picture.placement(context);
    let of = |direction: &Option<DVec3>| placement.of((*direction)?);
    let places: Vec<Option<Pos2>> = path.points.iter().map(of).collect();
    let marks = path.apsides.iter().filter_map(|(apsis, direction)| {
        let place = placement.of(*direction)?;
        visible.contains(place).then_some((*apsis, place))
    });
    let marks: Vec<_> = marks.collect();
    let is_visible = |place: &&Pos2| visible.contains(**place);
    let drawn = places.iter().flatten().filter(is_visible).count();
    draw_below_boxes(context, "path ahead", visible, |painter| {
        draw_line(painter, &placement, &places);
        for (apsis, place) in marks {
            let name = match apsis {
                Apsis::Low => "lowest point",
                Apsis::High => "highest point",
            };
            painter.circle(place, MARK, Color32::from_black_alpha(150), stroke(1.0));
            draw_name((painter, layout), name, place, visible);
        }
    });
    line.drawn = drawn;
}

fn stroke(strength: f32) -> Stroke {
    Stroke::new(WIDTH, ACCENT.gamma_multiply(strength))
}

/// Draws the parts between points that follow each other, with a dark edge below them.
fn draw_line(painter: &Painter, placement: &Placement, places: &[Option<Pos2>]) {
    let last = places.len().max(2) as f32 - 1.0;
    let strength = |index: usize| 1.0 - (1.0 - LAST) * index as f32 / last;
    for is_edge in [true, false] {
        for (index, pair) in places.windows(2).enumerate() {
            let [Some(from), Some(to)] = pair else {
                continue;
            };
            if !placement.is_short(*from, *to) {
                continue;
            }
            let strength = strength(index);
            let stroke = match is_edge {
                true => Stroke::new(EDGE, Color32::from_black_alpha((110.0 * strength) as u8)),
                false => stroke(strength),
            };
            painter.line_segment([*from, *to], stroke);
        }
    }
}
