//! The compass: an arrow at the edge of the picture that points to the hole while it is out of view,
//! and to the sky while the hole fills the view. A hole too small to be seen gets a ring, unless there
//! is neither lensing nor a disk to be seen.

use crate::app::motion::facing::{Aim, aimed};
use crate::app::motion::ship::ShipFlight;
use crate::app::motion::steering::is_inside;
use crate::app::state::hole_in_view::{HoleInView, SeenHole};
use crate::app::state::preferences::Preferences;
use crate::app::ui::guides::Placement;
use crate::app::ui::layout::{Importance, Layout, Slide, Wish};
use crate::app::ui::picture_in_window::PictureInWindow;
use crate::app::ui::screen::{BOX, MARGIN, Screen};
use bevy::prelude::*;
use bevy_egui::EguiPrimaryContextPass;
use bevy_egui::egui::{self, Align2, Color32, FontId, Pos2, Rect, Stroke, Vec2};
use glam::DVec3;
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;

/// Free room between the arrow and the picture's edges, in points: left and right, and top and bottom.
/// The arrow moves on an ellipse, which stays clear of the corners.
const ROOM: [f32; 2] = [60.0, 130.0];
/// Half the length of the arrow's two strokes, in points.
const ARROW: f32 = 9.0;
/// Distance from the arrow to the middle of its label, in points: across and down.
const LABEL_DISTANCE: [f32; 2] = [58.0, 28.0];
/// Maximum radius in points of a hole with its disk that gets a ring: it is easy to overlook among stars.
const SMALL_RADIUS: f32 = 36.0;
/// The same for a hole without a disk, around which a ring would look like its photon ring.
const SMALL_BARE_RADIUS: f32 = 12.0;
/// Minimum radius of the ring, and its distance from the hole and disk, in points.
const MIN_RING: f32 = 14.0;
const RING_DISTANCE: f32 = 6.0;
/// Sine of the angle from straight back within which a target counts as behind the camera.
const BEHIND: f32 = 0.2;
/// Size of the label, in points.
const TEXT_SIZE: f32 = 14.0;
const BRIGHT: Color32 = Color32::from_gray(235);
const DARK: Color32 = Color32::from_black_alpha(215);
/// Number of steps from the edge to the middle in which the arrow looks for room.
const INWARD_STEPS: usize = 40;
/// Room around the label's text, in points.
const PADDING: Vec2 = egui::vec2(8.0, 4.0);

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        EguiPrimaryContextPass,
        show_compass.in_set(Importance::Compass),
    );
}

fn show_compass(
    mut screen: Screen,
    picture: PictureInWindow,
    hole: Res<HoleInView>,
    (preferences, ship): (Res<Preferences>, Res<ShipFlight>),
) {
    let (Some((context, layout)), Some(hole)) = (screen.texts(), hole.0) else {
        return;
    };
    let scene = picture.scene();
    let label = hole_label(scene, ship.units(&preferences.settings));
    let layer = egui::LayerId::new(egui::Order::Background, egui::Id::new("compass"));
    let painter = context.layer_painter(layer);
    if hole.fills_view {
        draw_arrow(&painter, layout, sky_direction(scene, &hole), "sky");
    } else if !hole.in_picture {
        draw_arrow(&painter, layout, hole.direction, &label);
    } else if scene.effects.lensing || scene.disk.enabled {
        let placement = picture.placement(context);
        draw_ring(&painter, layout, scene, (&hole, label), &placement);
    }
}

/// The direction of the sky on the camera's axes: straight away from the hole and, inside the horizon,
/// where the key that faces the sky turns the camera to.
fn sky_direction(scene: &Scene, hole: &SeenHole) -> DVec3 {
    let edge = aimed(scene, Aim::Edge).filter(|_| is_inside(scene));
    edge.map_or(-hole.direction, |axes| {
        scene.camera.tetrad_from_camera().transpose() * axes.z_axis
    })
}

/// Draws an arrow toward a target with this direction on the camera's axes.
fn draw_arrow(painter: &egui::Painter, layout: &mut Layout, target: DVec3, name: &str) {
    let free = layout.bounds().expand(MARGIN);
    if !free.is_positive() {
        return;
    }
    let aside = egui::vec2(target.x as f32, -target.y as f32);
    let behind = target.z < 0.0 && aside.length() < BEHIND;
    // No side is nearer to a target straight behind, so the arrow points down.
    let toward = if behind || aside == Vec2::ZERO {
        Vec2::DOWN
    } else {
        aside.normalized()
    };
    let axes = (0.5 * free.size() - Vec2::from(ROOM)).max(Vec2::ZERO);
    // As far out as nothing else is in the way.
    let box_at = |tip| Rect::from_center_size(tip, Vec2::splat(2.0 * ARROW));
    let tips = (0..=INWARD_STEPS).map(|step| {
        let share = 1.0 - step as f32 / INWARD_STEPS as f32;
        free.center() + share * toward * axes
    });
    let Some(tip) = tips.into_iter().find(|tip| layout.is_free(box_at(*tip))) else {
        return;
    };
    layout.take("arrow", box_at(tip));
    let back = -toward * ARROW;
    let side = toward.rot90() * ARROW;
    for stroke in [Stroke::new(6.0, DARK), Stroke::new(2.0, BRIGHT)] {
        for wing in [side, -side] {
            painter.line_segment([tip, tip + back + wing], stroke);
        }
    }
    let behind = if behind { ", behind you" } else { "" };
    let place = tip - toward * Vec2::from(LABEL_DISTANCE);
    draw_label(painter, layout, place, format!("{name}{behind}"));
}

/// Draws a ring around a hole and a disk that are too small on the screen to be found.
fn draw_ring(
    painter: &egui::Painter,
    layout: &mut Layout,
    scene: &Scene,
    (hole, label): (&SeenHole, String),
    placement: &Placement,
) {
    let Some(place) = placement.of_looking(hole.direction) else {
        return;
    };
    let (disk, small) = if scene.disk.enabled {
        (scene.disk.outer / scene.camera.r, SMALL_RADIUS)
    } else {
        (0.0, SMALL_BARE_RADIUS)
    };
    let radius = placement.radius(hole.radius.max(disk), scene);
    if radius > small {
        return;
    }
    let ring = (radius + RING_DISTANCE).max(MIN_RING);
    painter.circle_stroke(place, ring, Stroke::new(4.0, DARK));
    painter.circle_stroke(place, ring, Stroke::new(1.5, BRIGHT));
    draw_label(
        painter,
        layout,
        place + egui::vec2(0.0, ring + MIN_RING),
        label,
    );
}

/// The label of the hole, with its distance.
fn hole_label(scene: &Scene, units: Units) -> String {
    format!("hole  {}", units.length(scene.camera.r, four_digits))
}

/// Draws a line of text on a dark ground, with its middle near this point.
fn draw_label(painter: &egui::Painter, layout: &mut Layout, middle: Pos2, text: String) {
    let galley = painter.layout_no_wrap(text, FontId::proportional(TEXT_SIZE), BRIGHT);
    let wish = Wish {
        covers_hole: false,
        anchor: Align2::CENTER_CENTER,
        at: middle,
        slide: Slide::Anywhere,
    };
    let size = galley.size() + 2.0 * PADDING;
    if let Some(place) = layout.place("compass", size, wish) {
        painter.rect_filled(place, 6.0, BOX);
        painter.galley(place.min + PADDING, galley, BRIGHT);
    }
}
