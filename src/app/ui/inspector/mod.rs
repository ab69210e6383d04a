//! The ray inspector: click a pixel, and its light is traced again, told in numbers and drawn.

mod drawing;
mod numbers;
mod worker;

use crate::app::session::clipboard::Clipboard;
use crate::app::session::window::Overlays;
use crate::app::state::toast::Toast;
use crate::app::ui::dock::{Side, docked, look, over_picture};
use crate::render::{CurrentScene, letterbox};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use drawing::{LEGEND, Sketch, View, path_colour};
use glam::DVec2;
use lightfall_core::accuracy::Ray;
use lightfall_core::scene::{Picture, Scene};
pub(crate) use worker::Worker;
use worker::{Answer, GpuState, Job};

/// Width of the inspector's panel, in points.
pub(crate) const WIDTH: f32 = 390.0;
/// Fans: how many rays a side.
const FANS: [u32; 3] = [1, 3, 5];
/// Height of the drawing, as a share of the window's, at most.
const DRAWING: f32 = 0.35;

/// What the inspector remembers.
#[derive(Resource)]
struct Inspector {
    sketch: Sketch,
    /// Rays a side of the fan, and pixels between them.
    fan: u32,
    spacing: f64,
    /// The scene and the place on its picture that were clicked last.
    asked: Option<(Scene, DVec2)>,
    answer: Option<Answer>,
}

impl Default for Inspector {
    fn default() -> Self {
        Self {
            sketch: Sketch::default(),
            fan: 1,
            spacing: 12.0,
            asked: None,
            answer: None,
        }
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Inspector>()
        .insert_resource(Worker::start())
        .add_systems(Update, (click.after(look).run_if(over_picture), receive))
        .add_systems(EguiPrimaryContextPass, show);
}

/// The pixel of the picture at a place of the window, in pixels from the picture's upper left
/// corner; none beside it.
#[must_use]
pub fn pixel_at(picture: &Picture, place: Vec2, window: UVec2) -> Option<DVec2> {
    if window.min_element() == 0 {
        return None;
    }
    let shown = letterbox(picture, window);
    let share = ((place - shown.offset) / shown.extent).as_dvec2();
    let inside = share.min_element() >= 0.0 && share.max_element() < 1.0;
    // Rays are traced through the middle of pixels.
    inside.then(|| (share * size(picture)).floor() + 0.5)
}

/// The place of the window at which a pixel of the picture is shown.
fn place_of(picture: &Picture, pixel: DVec2, window: UVec2) -> Vec2 {
    let shown = letterbox(picture, window);
    shown.offset + shown.extent * (pixel / size(picture)).as_vec2()
}

fn size(picture: &Picture) -> DVec2 {
    DVec2::new(f64::from(picture.width), f64::from(picture.height))
}

fn click(
    buttons: Res<ButtonInput<MouseButton>>,
    window: Single<&Window, With<PrimaryWindow>>,
    shown: Res<Overlays>,
    scene: Res<CurrentScene>,
    worker: Res<Worker>,
    mut inspector: ResMut<Inspector>,
) {
    if !shown.inspector_seen() || !buttons.just_pressed(MouseButton::Left) {
        return;
    }
    let pixel = window
        .physical_cursor_position()
        .and_then(|place| pixel_at(&scene.picture, place, window.physical_size()));
    if let Some(pixel) = pixel {
        inspector.asked = Some((scene.scene().clone(), pixel));
        inspector.ask(&worker);
    }
}

impl Inspector {
    /// Has the ray that was clicked last, and the fan about it, traced.
    fn ask(&self, worker: &Worker) {
        let Some((scene, pixel)) = &self.asked else {
            return;
        };
        let half = i64::from(self.fan / 2);
        let offsets = (-half..=half)
            .flat_map(|y| (-half..=half).map(move |x| DVec2::new(x as f64, y as f64)));
        // The one that was clicked comes first.
        let mut offsets: Vec<DVec2> = offsets.collect();
        offsets.sort_by_key(|offset| *offset != DVec2::ZERO);
        let ray = |offset: DVec2| {
            let place = *pixel + self.spacing * offset;
            (
                Ray::toward(scene.camera.looking(place, size(&scene.picture))),
                place.to_array(),
            )
        };
        worker.trace(Job {
            scene: scene.clone(),
            rays: offsets.into_iter().map(ray).collect(),
        });
    }
}

fn receive(worker: Res<Worker>, mut inspector: ResMut<Inspector>, mut notice: ResMut<Toast>) {
    match worker.answer() {
        Some(Ok(answer)) => inspector.answer = Some(answer),
        Some(Err(fault)) => notice.say(fault),
        None => {}
    }
}

fn show(
    mut contexts: EguiContexts,
    window: Single<&Window, With<PrimaryWindow>>,
    scene: Res<CurrentScene>,
    worker: Res<Worker>,
    clipboard: Res<Clipboard>,
    mut shown: ResMut<Overlays>,
    mut inspector: ResMut<Inspector>,
    mut notice: ResMut<Toast>,
) -> Result {
    if !shown.inspector_seen() {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let inspector = &mut *inspector;
    mark(context, inspector, &scene, &window);
    docked(context, "inspector", Side::Left, WIDTH, |ui| {
        ui.horizontal(|ui| {
            ui.strong("Ray inspector");
            fan(ui, inspector, &worker);
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button("×").on_hover_text("Close").clicked() {
                    shown.inspector = false;
                }
            });
        });
        ui.separator();
        let Inspector { answer, sketch, .. } = inspector;
        let Some(Answer {
            scene: seen,
            rays,
            gpu,
        }) = answer
        else {
            ui.label("Click a pixel of the picture: its light is traced again, by the f64 reference and on the GPU.");
            return;
        };
        let Some(first) = rays.first() else { return };
        ui.horizontal(|ui| {
            if ui.button("Copy text").clicked() {
                clipboard.copy(first.numbers.to_text());
                notice.say("The ray's numbers are on the clipboard, as text");
            }
            if ui.button("Copy JSON").clicked() {
                clipboard.copy(first.numbers.to_json());
                notice.say("The ray's numbers are on the clipboard, as JSON");
            }
        });
        heading(ui, first, seen, &scene, gpu);
        let tallest = ui.max_rect().height() * DRAWING;
        let left = (ui.available_height() - tallest - 60.0).max(80.0);
        egui::ScrollArea::both()
            .id_salt("numbers")
            .max_height(left)
            .auto_shrink([false, true])
            .show(ui, |ui| {
                numbers::show(ui, &first.numbers, gpu);
            });
        ui.horizontal(|ui| {
            for (view, name) in [
                (View::Side, "Side"),
                (View::Top, "Top"),
                (View::Orbit, "3-D"),
            ] {
                ui.selectable_value(&mut sketch.view, view, name);
            }
            if ui.button("Fit").clicked() {
                sketch.half_width = None;
            }
        });
        let height = (ui.available_height() - 26.0).clamp(60.0, tallest);
        sketch.show(ui, seen, rays, egui::vec2(ui.available_width(), height));
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 9.0;
            for (colour, name) in LEGEND {
                ui.label(egui::RichText::new(name).color(colour).size(12.0));
            }
        });
    });
    Ok(())
}

/// Which pixel of what it was.
fn heading(
    ui: &mut egui::Ui,
    first: &lightfall_core::reports::inspection::Inspected,
    seen: &Scene,
    now: &Scene,
    gpu: &GpuState,
) {
    let [x, y] = first.numbers.pixel.unwrap_or_default().map(f64::floor);
    let earlier = if seen == now {
        ""
    } else {
        ", of an earlier picture"
    };
    let asked = if *gpu == GpuState::Waiting {
        ", GPU is asked"
    } else {
        ""
    };
    ui.label(format!(
        "Pixel {x}, {y} of {} x {}{earlier}{asked}",
        seen.picture.width, seen.picture.height
    ));
}

fn fan(ui: &mut egui::Ui, inspector: &mut Inspector, worker: &Worker) {
    let before = (inspector.fan, inspector.spacing);
    ui.label("rays");
    for fan in FANS {
        ui.selectable_value(&mut inspector.fan, fan, (fan * fan).to_string());
    }
    if inspector.fan > 1 {
        let spacing = egui::DragValue::new(&mut inspector.spacing)
            .range(0.1..=200.0)
            .speed(0.3)
            .suffix(" px");
        ui.add(spacing)
            .on_hover_text("Pixels between the rays of the fan");
    }
    if before != (inspector.fan, inspector.spacing) {
        inspector.ask(worker);
    }
}

/// Marks the rays on the picture, as long as it is the one that was clicked on.
fn mark(context: &egui::Context, inspector: &Inspector, scene: &CurrentScene, window: &Window) {
    let Some(answer) = inspector
        .answer
        .as_ref()
        .filter(|answer| answer.scene == *scene.scene())
    else {
        return;
    };
    let painter = context.layer_painter(egui::LayerId::new(
        egui::Order::Background,
        "inspected".into(),
    ));
    let points = context.pixels_per_point();
    for (i, inspected) in answer.rays.iter().enumerate() {
        let pixel = DVec2::from_array(inspected.numbers.pixel.unwrap_or_default());
        let place = place_of(&scene.picture, pixel, window.physical_size()) / points;
        let centre = egui::pos2(place.x, place.y);
        let (radius, width) = if i == 0 { (7.0, 2.0) } else { (3.0, 1.0) };
        painter.circle_stroke(
            centre,
            radius + 1.0,
            egui::Stroke::new(width, egui::Color32::BLACK),
        );
        painter.circle_stroke(
            centre,
            radius,
            egui::Stroke::new(width, path_colour(inspected)),
        );
    }
}
