//! The status bar: the lines at the bottom of the window, which say where the camera is, show the
//! toast, and name the most important keys.

use crate::app::controls::bindings::Bindings;
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::motion::pilot::Pilot;
use crate::app::state::overlays::Overlays;
use crate::app::state::toast::Toast;
use crate::render::CurrentScene;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// The controls that a newcomer has to know, by name, and what to call them. The help lists all.
const MAIN_CONTROLS: [(&[&str], &str); 8] = [
    (
        &["fly.forward", "fly.left", "fly.backward", "fly.right"],
        "fly",
    ),
    (&["preset.1", "preset.9"], "presets"),
    (&["scene.spin"], "spin"),
    (&["picture.bypass"], "cells"),
    (&["window.panel"], "panel"),
    (&["window.inspector"], "inspect a ray"),
    (&["window.screenshot"], "screenshot"),
    (&["window.help"], "all keys"),
];

/// Room around the status bar, in points.
const MARGIN: f32 = 8.0;
/// Free width, in points, below which the keys are not named.
const MIN_WIDTH_FOR_KEYS: f32 = 560.0;
/// Free width, in points, below which only the toast is shown, over the panels.
const MIN_WIDTH: f32 = 240.0;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_status_bar);
}

/// The main controls, with their keys as they are bound.
fn main_controls(bindings: &Bindings) -> String {
    let mut entries = vec![
        "right mouse button look".to_owned(),
        "wheel speed".to_owned(),
    ];
    for (place, (ids, does)) in MAIN_CONTROLS.iter().enumerate() {
        let name = |id: &&str| bindings.label(id);
        let names: Vec<_> = ids
            .iter()
            .map(name)
            .map(|keys| keys.replace(", ", " "))
            .collect();
        let keys = match ids.len() {
            2 => names.join("-"),
            _ => names.concat(),
        };
        // Flying comes first, before the mouse.
        entries.insert(
            if place == 0 { 0 } else { entries.len() },
            format!("{keys} {does}"),
        );
    }
    entries.join(" · ")
}

/// Where the camera is, how it moves, and how fast it flies.
fn position(scene: &CurrentScene, pilot: &Pilot) -> String {
    let camera = scene.camera;
    let observer = scene.observer.kind.properties().motion;
    format!(
        "{} · r {:.3} r_s · theta {:.1}° · phi {:.1}° · {observer} · spin {} · speed {:.2}x",
        scene.name, camera.r, camera.theta_deg, camera.phi_deg, scene.hole.spin, pilot.throttle
    )
}

/// How far a journey has been flown, and how to end it. Empty while there is none.
fn journey(player: &JourneyPlayer, bindings: &Bindings) -> String {
    if !player.is_playing() {
        return String::new();
    }
    let stop = bindings.label("journey.fly");
    format!(
        "journey, {} · {stop} stops it, flying or looking around takes over",
        player.progress()
    )
}

fn show_status_bar(
    mut contexts: EguiContexts,
    scene: Res<CurrentScene>,
    pilot: Res<Pilot>,
    toast: Res<Toast>,
    free_fall: Res<FreeFall>,
    player: Res<JourneyPlayer>,
    overlays: Res<Overlays>,
    bindings: Res<Bindings>,
) -> Result {
    if overlays.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    // Between the panels, or over them where they leave too little room.
    let [left, right] = [overlays.left_width(), overlays.right_width()];
    let width = context.content_rect().width() - 2.0 * MARGIN;
    let free = width - left - right;
    let (widest, shift, order) = if free > MIN_WIDTH {
        (free, 0.5 * (left - right), egui::Order::Background)
    } else {
        (width, 0.0, egui::Order::Foreground)
    };
    let where_room = |line: String| {
        if free > MIN_WIDTH {
            line
        } else {
            String::new()
        }
    };
    let mut lines = vec![
        where_room(position(&scene, &pilot)),
        where_room(journey(&player, &bindings)),
        where_room(free_fall.clocks(scene.camera.r)),
        toast.text().to_owned(),
        if free > MIN_WIDTH_FOR_KEYS {
            main_controls(&bindings)
        } else {
            where_room(format!("{} all keys", bindings.label("window.help")))
        },
    ];
    lines.retain(|line| !line.is_empty());
    if lines.is_empty() {
        return Ok(());
    }
    egui::Area::new("status bar".into())
        .anchor(egui::Align2::CENTER_BOTTOM, [shift, -MARGIN])
        .interactable(false)
        .order(order)
        .show(context, |ui| {
            ui.set_max_width(widest);
            let frame = egui::Frame::new()
                .fill(egui::Color32::from_black_alpha(200))
                .inner_margin(6)
                .corner_radius(4);
            frame.show(ui, |ui| {
                for line in lines {
                    ui.label(
                        egui::RichText::new(line)
                            .size(13.0)
                            .color(egui::Color32::from_gray(210)),
                    );
                }
            });
        });
    Ok(())
}
