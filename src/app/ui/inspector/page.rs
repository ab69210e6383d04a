//! What the inspector shows: its page at the window's left side, and marks on the picture.

use super::colours::path_colour;
use super::drawing::{Viewpoint, legend};
use super::ray_worker::InspectedRays;
use super::{Inspector, handout, numbers, plane_figure};
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::motion::ship::ShipFlight;
use crate::app::session::clipboard::Clipboard;
use crate::app::session::handout_file::save_handout;
use crate::app::state::kiosk::Kiosk;
use crate::app::state::overlays::{INSPECTOR_WIDTH, Overlays, Side};
use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use crate::app::ui::dock::docked;
use crate::app::ui::picture_in_window::PictureInWindow;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, egui};
use glam::DVec2;
use lightfall_core::accuracy::inspection::Inspected;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::Scene;

/// The fans to choose from: rays per side.
const FANS: [u32; 3] = [1, 3, 5];
/// Minimum height of the drawing, as a share of the room for it and everything below it.
const MIN_DRAWING_SHARE: f32 = 0.52;

/// The viewpoints to choose from, with their names.
const VIEWPOINTS: [(Viewpoint, &str); 4] = [
    (Viewpoint::Plane, "Ray's plane"),
    (Viewpoint::Side, "Side"),
    (Viewpoint::Top, "Top"),
    (Viewpoint::Orbit, "3-D"),
];

/// Shows the inspector's page, and marks the rays of its answer on the picture.
pub(super) fn show_inspector(
    mut contexts: EguiContexts,
    (preferences, player, ship): (Res<Preferences>, Res<JourneyPlayer>, Res<ShipFlight>),
    kiosk: Res<Kiosk>,
    picture: PictureInWindow,
    clipboard: Res<Clipboard>,
    mut overlays: ResMut<Overlays>,
    mut inspector: ResMut<Inspector>,
    mut toast: ResMut<Toast>,
) -> Result {
    if !overlays.shows_inspector() {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let inspector = &mut *inspector;
    let units = ship.units(&preferences.settings);
    let journey = Some(player.journey()).filter(|_| player.has_lesson());
    let lesson = journey.map(|journey| journey.title.trim());
    let lesson = lesson.filter(|title| !title.is_empty());
    // The scene that was clicked, as it is now.
    let scene = picture
        .scene_of(inspector.side)
        .unwrap_or_else(|| picture.scene());
    mark_rays(context, inspector, scene, &picture);
    docked(context, "inspector", Side::Left, INSPECTOR_WIDTH, |ui| {
        ui.horizontal(|ui| {
            ui.strong("Ray inspector");
            choose_fan(ui, inspector);
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if ui.button("×").on_hover_text("Close").clicked() {
                    overlays.inspector = false;
                }
            });
        });
        ui.separator();
        let Some(answer) = &inspector.answer else {
            ui.label("Click a point of the picture to see the path of its light.");
            return;
        };
        let Some(first) = answer.rays.first() else {
            return;
        };
        let (seen, sketch) = (&answer.scene, &mut inspector.sketch);
        ui.horizontal(|ui| {
            // Visitors leave nothing on the machine.
            if kiosk.is_on() {
                return;
            }
            if ui.button("Copy text").clicked() {
                clipboard.copy(first.numbers.to_text());
                toast.say("The ray's numbers are on the clipboard, as text");
            }
            if ui.button("Copy JSON").clicked() {
                clipboard.copy(first.numbers.to_json());
                toast.say("The ray's numbers are on the clipboard, as JSON");
            }
            let hint = "The figure on white paper with its caption and numbers, as a file to print";
            // In a lesson the picture is no longer that of the preset.
            let title = lesson.unwrap_or_else(|| handout::title(seen));
            if ui.button("Handout").on_hover_text(hint).clicked()
                && let Some(page) = handout::handout(title, seen, &answer.rays, sketch, units)
            {
                toast.say(save_handout(&seen.name, &page));
            }
        });
        let waits = first.numbers.gpu.is_none() && answer.gpu_fault.is_none();
        heading(ui, first, seen, scene, waits, units);
        ui.horizontal(|ui| {
            for (viewpoint, name) in VIEWPOINTS {
                ui.selectable_value(&mut sketch.viewpoint, viewpoint, name);
            }
            if ui.button("Fit").clicked() {
                sketch.half_width = None;
            }
        });
        // The numbers take the room that they need, up to their share, and the drawing the rest.
        let room = ui.available_height();
        let below = inspector.text_height.min((1.0 - MIN_DRAWING_SHARE) * room);
        let height = (room - below).max(60.0);
        let size = egui::vec2(ui.available_width(), height);
        sketch.show(ui, seen, &answer.rays, units, size);
        let top = ui.cursor().top();
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 9.0;
            for (colour, name) in legend(sketch.viewpoint, seen, units) {
                ui.label(egui::RichText::new(name).color(colour).size(12.0));
            }
        });
        if sketch.viewpoint == Viewpoint::Plane {
            ui.label(plane_figure::explanation(seen, first, units));
        }
        ui.separator();
        let shown = egui::ScrollArea::both()
            .id_salt("numbers")
            .auto_shrink([false, true])
            .show(ui, |ui| {
                numbers::show(ui, first, seen, answer.gpu_fault.as_deref(), units);
            });
        // Next frame the drawing makes room for them.
        let wanted = shown.inner_rect.top() - top + shown.content_size.y + 8.0;
        if (inspector.text_height - wanted).abs() > 0.5 {
            inspector.text_height = wanted;
            context.request_repaint();
        }
    });
    Ok(())
}

/// Says which pixel of which picture was clicked.
fn heading(
    ui: &mut egui::Ui,
    first: &Inspected,
    seen: &Scene,
    now: &Scene,
    waits: bool,
    units: Units,
) {
    let [x, y] = first.numbers.pixel.unwrap_or_default().map(f64::floor);
    let (picture, method) = (&seen.picture, seen.resolved_method().word());
    let mut text = format!("Pixel {x}, {y} of {} x {}", picture.width, picture.height);
    if !units.are_simple() {
        text += &format!(", method {method}");
    }
    if seen != now {
        text += "; the picture has changed since";
    }
    if waits {
        text += ", waiting for the GPU";
    }
    ui.label(text);
}

fn choose_fan(ui: &mut egui::Ui, inspector: &mut Inspector) {
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
        inspector.ask();
    }
}

/// Marks the rays on the picture, unless the picture has changed since the click.
fn mark_rays(
    context: &egui::Context,
    inspector: &Inspector,
    scene: &Scene,
    picture: &PictureInWindow,
) {
    let is_shown = |answer: &&InspectedRays| answer.scene.without_clock() == scene.without_clock();
    let Some(answer) = inspector.answer.as_ref().filter(is_shown) else {
        return;
    };
    let layer = egui::LayerId::new(egui::Order::Background, "inspected".into());
    let painter = context.layer_painter(layer);
    let Some(placement) = picture.placement_of(inspector.side, context) else {
        return;
    };
    let shown = picture.shown_part(inspector.side, context);
    for (i, inspected) in answer.rays.iter().enumerate() {
        let pixel = DVec2::from_array(inspected.numbers.pixel.unwrap_or_default());
        let centre = placement.of_pixel(pixel);
        if !shown.contains(centre) {
            continue;
        }
        let (radius, width) = if i == 0 { (7.0, 2.0) } else { (3.0, 1.0) };
        for (radius, colour) in [
            (radius + 1.0, egui::Color32::BLACK),
            (radius, path_colour(inspected)),
        ] {
            painter.circle_stroke(centre, radius, egui::Stroke::new(width, colour));
        }
    }
}
