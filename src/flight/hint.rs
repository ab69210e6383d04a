//! The lines at the bottom of the window: where the camera is, and which keys there are.

use super::controls::{KEYS, Notice};
use super::pilot::Pilot;
use crate::render::CurrentScene;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

const FLYING: &str = "WASD fly · Space/Ctrl up/down · Q/E roll · right mouse or Tab look · wheel speed · Shift/Alt fast/slow · Esc frees the mouse";

/// Room around the line, in points.
const MARGIN: f32 = 8.0;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show);
}

/// The line, made from the key table: keys in a row that do the same are one entry, numbers as a span.
fn line() -> String {
    let entries = KEYS.chunk_by(|a, b| a.does == b.does).map(|keys| {
        let (first, last) = (keys[0].name, keys[keys.len() - 1].name);
        let numbers = first.starts_with(|letter: char| letter.is_ascii_digit());
        let span = if keys.len() > 1 && numbers {
            format!("{first}-{last}")
        } else {
            keys.iter().map(|key| key.name).collect::<Vec<_>>().join(" ")
        };
        format!("{span} {}", keys[0].does)
    });
    std::iter::once(FLYING.to_owned()).chain(entries).collect::<Vec<_>>().join(" · ")
}

/// Where the camera is, how fast it flies, and what it looks at.
fn whereabouts(scene: &CurrentScene, pilot: &Pilot) -> String {
    let camera = scene.camera;
    format!(
        "{} · r {:.3} r_s · theta {:.1}° · phi {:.1}° · spin {} · speed {:.2}x",
        scene.name, camera.r, camera.theta_deg, camera.phi_deg, scene.hole.spin, pilot.throttle
    )
}

fn show(
    mut contexts: EguiContexts,
    mut keys: Local<String>,
    scene: Res<CurrentScene>,
    pilot: Res<Pilot>,
    notice: Res<Notice>,
) -> Result {
    if keys.is_empty() {
        *keys = line();
    }
    let context = contexts.ctx_mut()?;
    let widest = context.content_rect().width() - 2.0 * MARGIN;
    egui::Area::new("hint".into())
        .anchor(egui::Align2::CENTER_BOTTOM, [0.0, -MARGIN])
        .interactable(false)
        .order(egui::Order::Foreground)
        .show(context, |ui| {
            ui.set_max_width(widest);
            egui::Frame::new().fill(egui::Color32::from_black_alpha(200)).inner_margin(6).corner_radius(4).show(
                ui,
                |ui| {
                    let lines = [&whereabouts(&scene, &pilot), &notice.0, &*keys];
                    for line in lines.into_iter().filter(|line| !line.is_empty()) {
                        ui.label(egui::RichText::new(line).size(13.0).color(egui::Color32::from_gray(210)));
                    }
                },
            );
        });
    Ok(())
}
