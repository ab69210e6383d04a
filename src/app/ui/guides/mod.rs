//! Guides over the picture, as in a figure of a textbook: the edge of the shadow, the innermost
//! stable orbit, the ergosphere, and where the hole would be seen without bending.

mod key;
mod labels;
mod place;
mod style;

use crate::app::state::overlays::Overlays;
use crate::app::state::preferences::Preferences;
use crate::app::ui::legend::LEGEND;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use glam::DVec2;
use key::{KEY, Tracing, show_key};
use labels::{Label, draw_labels};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::optics::guides::{Guide, quick_guides, traced_guides};
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::scene::{Scene, View};
use lightfall_platform::worker::Follower;
use lightfall_render::{ComparedScene, ComparisonLayout, DrawnScene};
pub(in crate::app::ui) use place::Placement;
use place::draw_line;
use style::{Style, label};

/// Opacity of the slow guides while they belong to an earlier place of the camera.
const STALE: f32 = 0.3;
/// Room for the read-outs at the bottom, in points.
const READ_OUT_HEIGHT: f32 = 104.0;
/// Room at the edge of the window, in points.
const MARGIN: f32 = 12.0;

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
        .add_systems(EguiPrimaryContextPass, show_guides);
}

/// A scene with only the fields that decide where guides are on the observer's sky. Without a tilted
/// disk, everything is the same at every azimuth.
fn sky_of(scene: &Scene) -> Scene {
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
    mut contexts: EguiContexts,
    window: Single<&Window, With<PrimaryWindow>>,
    scene: Res<DrawnScene>,
    overlays: Res<Overlays>,
    preferences: Res<Preferences>,
    (guides, compared): (Res<Guides>, Res<ComparedScene>),
) -> Result {
    let Some((sky, quick)) = guides.quick.as_ref().filter(|_| overlays.shows_guides()) else {
        return Ok(());
    };
    let context = contexts.ctx_mut()?;
    let placement = Placement::new(&scene, &window, context);
    let screen = context.content_rect();
    let room = egui::Rect::from_x_y_ranges(
        screen.left() + overlays.left_width()..=screen.right() - overlays.right_width(),
        screen.y_range(),
    );
    // In a comparison the guides belong to the present scene, which is on the right side.
    let divider = match compared.drawn() {
        Some((_, ComparisonLayout::SideBySide { columns })) => {
            Some(placement.of_pixel(DVec2::new(columns.into(), 0.0)).x)
        }
        _ => None,
    };
    let mut visible = placement.picture.intersect(room);
    visible.min.x = divider.map_or(visible.min.x, |divider| visible.min.x.max(divider));
    if !visible.is_positive() {
        return Ok(());
    }
    let traced = guides.slow.newest();
    let waiting = traced.is_none_or(|(traced, _)| traced != sky);
    let slow = traced
        .filter(|(traced, _)| traced.effects == sky.effects)
        .map_or(&[][..], |(_, guides)| guides);

    let legend = context
        .memory(|memory| memory.area_rect(LEGEND))
        .filter(|_| scene.view != View::Colour);
    let top = legend.map_or(room.top(), |legend| legend.bottom());
    let known: Vec<Guide> = quick.iter().chain(slow).cloned().collect();
    let key = show_key(
        context,
        &scene,
        &known,
        &placement,
        HoleMass {
            name: "chosen",
            suns: preferences.settings.hole_mass_suns,
        },
        [room.right() - MARGIN, top + MARGIN],
        Tracing {
            waiting,
            right_side: divider.is_some(),
        },
    );

    let free = egui::Rect::from_x_y_ranges(
        visible.x_range(),
        visible.top().max(screen.top() + MARGIN)
            ..=visible.bottom().min(screen.bottom() - READ_OUT_HEIGHT),
    );
    let taken: Vec<_> = legend.into_iter().chain([key]).collect();
    let figure = Figure {
        kerr: scene.kerr(),
        placement,
        quick,
        slow,
        slow_strength: if waiting { STALE } else { 1.0 },
    };
    // The lines have an area of their own, below every box.
    egui::Area::new("guides".into())
        .fixed_pos(visible.min)
        .interactable(false)
        .fade_in(false)
        .order(egui::Order::Background)
        .show(context, |ui| {
            let painter = ui.painter().with_clip_rect(visible);
            let labels = figure.draw(&painter);
            if free.is_positive() {
                draw_labels(&painter, labels, free, &taken);
            }
        });
    for name in [LEGEND, KEY].map(egui::Id::new) {
        context.move_to_top(egui::LayerId::new(egui::Order::Background, name));
    }
    Ok(())
}

/// The guides of one frame.
struct Figure<'a> {
    kerr: Kerr,
    placement: Placement,
    quick: &'a [Guide],
    slow: &'a [Guide],
    /// Opacity of the slow guides.
    slow_strength: f32,
}

impl Figure<'_> {
    /// Draws the lines, and returns the labels of the guides that belong to the present sky. Flat
    /// guides are drawn first, below the traced ones.
    fn draw(&self, painter: &egui::Painter) -> Vec<Label> {
        let (flat, bent): (Vec<_>, Vec<_>) = self.quick.iter().partition(|guide| guide.flat);
        let lines = flat
            .into_iter()
            .map(|guide| (guide, 1.0))
            .chain(self.slow.iter().map(|guide| (guide, self.slow_strength)))
            .chain(bent.into_iter().map(|guide| (guide, 1.0)));
        let mut labels = Vec::new();
        for (guide, strength) in lines {
            let style = Style::of(guide);
            let curves = guide.curves.iter();
            let parts: Vec<_> = curves
                .flat_map(|curve| self.placement.visible_parts(curve))
                .collect();
            for part in &parts {
                draw_line(painter, part, style, strength);
            }
            if strength == 1.0 {
                labels.push(Label {
                    text: label(guide, self.kerr),
                    colour: style.colour,
                    points: parts.concat(),
                    toward: style.toward,
                });
            }
        }
        labels
    }
}
