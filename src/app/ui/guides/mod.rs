//! Guides over the picture, as in a figure of a textbook: the edge of the shadow, the innermost
//! stable orbit, the ergosphere, and where the hole would be seen without bending.

mod key;
mod labels;
mod place;
mod style;

use crate::app::motion::ship::ShipFlight;
use crate::app::state::overlays::Overlays;
use crate::app::state::preferences::Preferences;
use crate::app::ui::layout::Importance;
use crate::app::ui::picture_in_window::{PictureInWindow, SceneSide};
use crate::app::ui::screen::{MARGIN, Screen, draw_below_boxes};
use bevy::prelude::*;
use bevy_egui::{EguiPrimaryContextPass, egui};
use key::{Key, Tracing, show_key};
use labels::{Label, draw_labels};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::optics::guides::{Guide, quick_guides, traced_guides};
use lightfall_core::scene::Scene;
use lightfall_platform::worker::Follower;
use lightfall_render::DrawnScene;
pub(in crate::app::ui) use place::Placement;
use place::draw_line;
use style::{Style, name};

/// Opacity of the slow guides while they belong to an earlier place of the camera.
const STALE: f32 = 0.3;

/// The guides, each kind after the scene that it belongs to, as [`sky_of`] gives it.
#[derive(Resource)]
struct Guides {
    quick: Option<(Scene, Vec<Guide>)>,
    /// The thread that traces the slow guides.
    slow: Follower<Scene, Vec<Guide>>,
}

pub(crate) fn plugin(app: &mut App) {
    let guides = Guides {
        quick: None,
        // A drawn scene has an observer, and so has guides.
        slow: Follower::new(|sky| traced_guides(sky).unwrap_or_default()),
    };
    app.insert_resource(guides)
        .add_systems(
            Update,
            trace_guides.run_if(|overlays: Res<Overlays>| overlays.shows_guides()),
        )
        .add_systems(
            EguiPrimaryContextPass,
            show_guides.in_set(Importance::Guides),
        );
}

/// A scene with only the fields that decide where guides are on the observer's sky. Without a tilted
/// disk, everything is the same at every azimuth.
pub(in crate::app::ui) fn sky_of(scene: &Scene) -> Scene {
    let mut sky = Scene {
        hole: scene.hole,
        observer: scene.observer,
        effects: scene.effects,
        ..Scene::default()
    };
    (sky.camera.r, sky.camera.theta_deg) = (scene.camera.r, scene.camera.theta_deg);
    if scene.disk.is_tilted() {
        sky.camera.phi_deg = scene.camera.phi_deg;
        (sky.disk.tilt_deg, sky.disk.node_deg) = (scene.disk.tilt_deg, scene.disk.node_deg);
    }
    sky
}

fn trace_guides(scene: Res<DrawnScene>, mut guides: ResMut<Guides>) {
    let sky = sky_of(&scene);
    guides.slow.follow(sky.clone());
    if guides.quick.as_ref().is_none_or(|(quick, _)| *quick != sky) {
        let found = quick_guides(&sky).unwrap_or_default();
        guides.quick = Some((sky, found));
    }
}

fn show_guides(
    mut screen: Screen,
    picture: PictureInWindow,
    overlays: Res<Overlays>,
    (preferences, ship): (Res<Preferences>, Res<ShipFlight>),
    guides: Res<Guides>,
) {
    let quick = guides.quick.as_ref().filter(|_| overlays.guides);
    let (Some((context, layout)), Some((sky, quick))) = (screen.texts(), quick) else {
        return;
    };
    let (placement, scene) = (picture.placement(context), picture.scene());
    let shown = picture.shown_part(SceneSide::Current, context);
    let visible = shown.intersect(layout.bounds().expand(MARGIN));
    if !visible.is_positive() {
        return;
    }
    let traced = guides.slow.newest();
    let waiting = traced.is_none_or(|(traced, _)| traced != sky);
    let slow = traced
        .filter(|(traced, _)| traced.effects == sky.effects)
        .map_or(&[][..], |(_, guides)| guides);

    let known: Vec<Guide> = quick.iter().chain(slow).cloned().collect();
    let key = Key {
        scene,
        guides: &known,
        placement: &placement,
        units: ship.units(&preferences.settings),
        mass: ship.hole_mass(&preferences.settings),
        tracing: Tracing {
            waiting,
            right_side: picture.divider(context).is_some(),
        },
    };
    show_key((context, layout), key);
    let strength = if waiting { STALE } else { 1.0 };
    draw_below_boxes(context, "guides", visible, |painter| {
        let labels = draw_lines(painter, &placement, scene.kerr(), quick, slow, strength);
        draw_labels(painter, labels, visible, layout);
    });
}

/// Draws the lines, and returns the labels of the guides that belong to the present sky. Flat guides are
/// drawn first, below the traced ones. `slow_strength` is the opacity of the slow guides.
fn draw_lines(
    painter: &egui::Painter,
    placement: &Placement,
    kerr: Kerr,
    quick: &[Guide],
    slow: &[Guide],
    slow_strength: f32,
) -> Vec<Label> {
    let (flat, bent): (Vec<_>, Vec<_>) = quick.iter().partition(|guide| guide.flat);
    let lines = flat
        .into_iter()
        .map(|guide| (guide, 1.0))
        .chain(slow.iter().map(|guide| (guide, slow_strength)))
        .chain(bent.into_iter().map(|guide| (guide, 1.0)));
    let mut labels = Vec::new();
    for (guide, strength) in lines {
        let style = Style::of(guide);
        let curves = guide.curves.iter();
        let parts: Vec<_> = curves
            .flat_map(|curve| placement.visible_parts(curve))
            .collect();
        for part in &parts {
            draw_line(painter, part, style, strength);
        }
        if strength == 1.0 {
            let flat = if guide.flat { " (flat)" } else { "" };
            labels.push(Label {
                text: format!("{}{flat}", name(guide, kerr)),
                colour: style.colour,
                points: parts.concat(),
                toward: style.toward,
            });
        }
    }
    labels
}
