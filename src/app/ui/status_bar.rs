//! The lines at the bottom of the window: where the camera is, what was just said, and where to
//! begin.

use crate::app::controls::bindings::Bindings;
use crate::app::motion::free_fall::FreeFall;
use crate::app::motion::journey_player::JourneyPlayer;
use crate::app::motion::pilot::Pilot;
use crate::app::session::window::Overlays;
use crate::app::state::toast::Toast;
use crate::render::CurrentScene;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// Controls that somebody new has to know of, by name, and what to call them; the help has all.
const FIRST: [(&[&str], &str); 8] = [
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

/// Room around the lines, in points.
const MARGIN: f32 = 8.0;
/// Between panels that leave less than this, in points, there is no room to say where to begin.
const NARROW: f32 = 560.0;
/// And below this only what was just said is shown.
const MIN_WIDTH: f32 = 240.0;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show);
}

/// Where to begin, with the keys as they are bound.
fn beginning(bindings: &Bindings) -> String {
    let mut entries = vec![
        "right mouse button look".to_owned(),
        "wheel speed".to_owned(),
    ];
    for (place, (ids, does)) in FIRST.iter().enumerate() {
        let name = |id: &&str| bindings.named(id);
        let names: Vec<_> = ids
            .iter()
            .map(name)
            .map(|keys| keys.replace(", ", " "))
            .collect();
        let keys = match ids.len() {
            2 => names.join("-"),
            _ => names.concat(),
        };
        // Flying first, before the mouse.
        entries.insert(
            if place == 0 { 0 } else { entries.len() },
            format!("{keys} {does}"),
        );
    }
    entries.join(" · ")
}

/// Where the camera is, how fast it flies, and what it looks at.
fn whereabouts(scene: &CurrentScene, pilot: &Pilot) -> String {
    let camera = scene.camera;
    let observer = scene.observer.kind.properties().motion;
    format!(
        "{} · r {:.3} r_s · theta {:.1}° · phi {:.1}° · {observer} · spin {} · speed {:.2}x",
        scene.name, camera.r, camera.theta_deg, camera.phi_deg, scene.hole.spin, pilot.throttle
    )
}

/// That a journey runs, how far it is, and how it ends; empty while there is none.
fn journey(guide: &JourneyPlayer, bindings: &Bindings) -> String {
    if !guide.flies() {
        return String::new();
    }
    let stop = bindings.named("journey.fly");
    format!(
        "journey, {} · {stop} stops it, flying or looking around takes over",
        guide.progress()
    )
}

fn show(
    mut contexts: EguiContexts,
    scene: Res<CurrentScene>,
    pilot: Res<Pilot>,
    notice: Res<Toast>,
    voyage: Res<FreeFall>,
    guide: Res<JourneyPlayer>,
    shown: Res<Overlays>,
    bindings: Res<Bindings>,
) -> Result {
    if shown.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    // In what the panels leave free; what was just said is said over them where that is too little.
    let [left, right] = [shown.left(), shown.right()];
    let width = context.content_rect().width() - 2.0 * MARGIN;
    let free = width - left - right;
    let (widest, shift, order) = if free > MIN_WIDTH {
        (free, 0.5 * (left - right), egui::Order::Background)
    } else {
        (width, 0.0, egui::Order::Foreground)
    };
    let roomy = |least: f32, line: String| if free > least { line } else { String::new() };
    let mut lines = vec![
        roomy(MIN_WIDTH, whereabouts(&scene, &pilot)),
        roomy(MIN_WIDTH, journey(&guide, &bindings)),
        roomy(MIN_WIDTH, voyage.clocks(scene.camera.r)),
        notice.text().to_owned(),
        if free > NARROW {
            beginning(&bindings)
        } else {
            roomy(
                MIN_WIDTH,
                format!("{} all keys", bindings.named("window.help")),
            )
        },
    ];
    lines.retain(|line| !line.is_empty());
    if lines.is_empty() {
        return Ok(());
    }
    egui::Area::new("hint".into())
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
