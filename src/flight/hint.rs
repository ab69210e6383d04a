//! The lines at the bottom of the window: where the camera is, what was just said, and where to begin.

use super::bindings::Bindings;
use super::inspector;
use super::motion::Voyage;
use super::notice::Notice;
use super::panel;
use super::pilot::Pilot;
use super::window::Shown;
use crate::render::CurrentScene;
use crate::scene::ObserverKind;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// Controls that somebody new has to know of, by name, and what to call them; the help has all.
const FIRST: [(&[&str], &str); 8] = [
    (&["fly.forward", "fly.left", "fly.backward", "fly.right"], "fly"),
    (&["preset.1", "preset.9"], "presets"),
    (&["scene.spin"], "spin"),
    (&["picture.bypass"], "cells"),
    (&["window.panel"], "panel"),
    (&["window.inspector"], "inspect a ray"),
    (&["window.screenshot"], "screenshot"),
    (&["window.help"], "all keys"),
];

/// Room around the lines, in points.
const MARGIN: f32 = 8.0;
/// Between panels that leave less than this, in points, there is no room to say where to begin.
const NARROW: f32 = 560.0;

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show);
}

/// Where to begin, with the keys as they are bound.
fn beginning(bindings: &Bindings) -> String {
    let mut entries = vec!["right mouse button look".to_owned(), "wheel speed".to_owned()];
    for (place, (ids, does)) in FIRST.iter().enumerate() {
        let name = |id: &&str| super::controls::control_named(id).map(|control| bindings.in_words(control));
        let names: Vec<_> = ids.iter().filter_map(name).map(|keys| keys.replace(", ", " ")).collect();
        let keys = match ids.len() {
            2 => names.join("-"),
            _ => names.concat(),
        };
        // Flying first, before the mouse.
        entries.insert(if place == 0 { 0 } else { entries.len() }, format!("{keys} {does}"));
    }
    entries.join(" · ")
}

/// Where the camera is, how fast it flies, and what it looks at.
fn whereabouts(scene: &CurrentScene, pilot: &Pilot) -> String {
    let camera = scene.camera;
    let observer = match scene.observer.kind {
        ObserverKind::Static => "at rest",
        ObserverKind::Zamo => "zamo",
        ObserverKind::Orbit => "in orbit",
        ObserverKind::Rain => "in free fall",
    };
    format!(
        "{} · r {:.3} r_s · theta {:.1}° · phi {:.1}° · {observer} · spin {} · speed {:.2}x",
        scene.name, camera.r, camera.theta_deg, camera.phi_deg, scene.hole.spin, pilot.throttle
    )
}

fn show(
    mut contexts: EguiContexts,
    scene: Res<CurrentScene>,
    pilot: Res<Pilot>,
    notice: Res<Notice>,
    voyage: Res<Voyage>,
    shown: Res<Shown>,
    bindings: Res<Bindings>,
) -> Result {
    if shown.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    // In what the panels leave free.
    let right = if shown.panel { panel::WIDTH } else { 0.0 };
    let left = if shown.inspector { inspector::WIDTH } else { 0.0 };
    let widest = (context.content_rect().width() - left - right - 2.0 * MARGIN).max(100.0);
    egui::Area::new("hint".into())
        .anchor(egui::Align2::CENTER_BOTTOM, [0.5 * (left - right), -MARGIN])
        .interactable(false)
        .order(egui::Order::Background)
        .show(context, |ui| {
            ui.set_max_width(widest);
            egui::Frame::new().fill(egui::Color32::from_black_alpha(200)).inner_margin(6).corner_radius(4).show(
                ui,
                |ui| {
                    let first = if widest > NARROW { beginning(&bindings) } else { String::new() };
                    let lines =
                        [&*whereabouts(&scene, &pilot), &*voyage.clocks(scene.camera.r), notice.text(), &*first];
                    for line in lines.into_iter().filter(|line| !line.is_empty()) {
                        ui.label(egui::RichText::new(line).size(13.0).color(egui::Color32::from_gray(210)));
                    }
                },
            );
        });
    Ok(())
}
