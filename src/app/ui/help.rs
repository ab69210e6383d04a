//! The overlay of all controls, made from the key table itself.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::table::{Control, Group};
use crate::app::input::gamepad::Pads;
use crate::app::session::window::Overlays;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// What the mouse does; the key table is about keys.
const MOUSE: [[&str; 2]; 2] = [["right mouse button", "look around"], ["wheel", "speed"]];

/// What a gamepad's sticks do; its buttons are bound.
const STICKS: [[&str; 2]; 2] = [["left stick", "fly"], ["right stick", "look around"]];

/// The headings side by side: in the first of these that the window has room for.
const COLUMNS: [&[&[Group]]; 3] = [
    &[
        &[Group::Flight, Group::Light],
        &[Group::Scene, Group::View],
        &[Group::Picture, Group::Window],
    ],
    &[
        &[Group::Flight, Group::Light, Group::View],
        &[Group::Scene, Group::Picture, Group::Window],
    ],
    &[&Group::ALL],
];
/// The same where the gamepad's own stands under the last.
const WITH_PAD: [&[&[Group]]; 3] = [
    &[
        &[Group::Flight, Group::Picture],
        &[Group::Scene, Group::Light, Group::View],
        &[Group::Window],
    ],
    &[
        &[Group::Flight, Group::Light, Group::View, Group::Window],
        &[Group::Scene, Group::Picture],
    ],
    &[&Group::ALL],
];
/// Width of a column, in points; of what lies about the window, and of its title and last line.
const COLUMN: f32 = 310.0;
const EDGE: f32 = 24.0;
const TITLE: f32 = 76.0;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show);
}

/// The rows under one heading: keys, and what they do. Controls in a row that do the same are one
/// row.
fn rows(bindings: &Bindings, group: Group) -> Vec<[String; 2]> {
    let controls: Vec<&Control> = bindings
        .iter()
        .map(|(control, _)| control)
        .filter(|control| control.group == group)
        .collect();
    let entries = controls.chunk_by(|a, b| a.does == b.does).map(|entry| {
        let names: Vec<_> = entry
            .iter()
            .map(|control| bindings.in_words(control))
            .filter(|n| !n.is_empty())
            .collect();
        let numbers = names.len() > 2
            && names
                .iter()
                .all(|name| name.len() == 1 && name.parse::<u8>().is_ok());
        let keys = match (numbers, names.as_slice()) {
            (true, [first, .., last]) => format!("{first} to {last}"),
            _ => names.join(" "),
        };
        [keys, entry[0].does.to_owned()]
    });
    let mouse = MOUSE
        .iter()
        .filter(|_| group == Group::Flight)
        .map(|row| row.map(str::to_owned));
    entries.chain(mouse).collect()
}

/// The rows of a gamepad: its sticks, and the controls that have buttons.
fn pad_rows(buttons: &PadBindings) -> Vec<[String; 2]> {
    let bound: Vec<&Control> = buttons
        .iter()
        .filter(|(_, own)| !own.is_empty())
        .map(|(control, _)| control)
        .collect();
    let entries = bound.chunk_by(|a, b| a.does == b.does).map(|entry| {
        let names: Vec<_> = entry
            .iter()
            .map(|control| buttons.in_words(control))
            .collect();
        [names.join(" "), entry[0].does.to_owned()]
    });
    STICKS
        .iter()
        .map(|row| row.map(str::to_owned))
        .chain(entries)
        .collect()
}

fn show(
    mut contexts: EguiContexts,
    mut shown: ResMut<Overlays>,
    bindings: Res<Bindings>,
    buttons: Res<PadBindings>,
    pads: Pads,
) -> Result {
    if !shown.help || shown.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let room = context.content_rect().size() - egui::vec2(EDGE, EDGE);
    let sets = if pads.any() { WITH_PAD } else { COLUMNS };
    let columns = sets
        .into_iter()
        .find(|columns| columns.len() as f32 * COLUMN < room.x)
        .unwrap_or(sets[2]);
    let mut open = true;
    egui::Window::new("Help")
        .open(&mut open)
        .order(egui::Order::Foreground)
        .collapsible(false)
        .resizable(false)
        .anchor(egui::Align2::CENTER_CENTER, [0.0, 0.0])
        .show(context, |ui| {
            ui.set_max_width(room.x);
            // Bars that show, or nobody would know that there is more.
            ui.spacing_mut().scroll = egui::style::ScrollStyle::solid();
            // Under it there is a line more, above it the title.
            egui::ScrollArea::both()
                .max_height((room.y - TITLE).max(40.0))
                .show(ui, |ui| {
                    ui.horizontal_top(|ui| {
                        ui.spacing_mut().item_spacing.x = 24.0;
                        for (place, groups) in columns.iter().enumerate() {
                            ui.vertical(|ui| {
                                groups.iter().for_each(|group| {
                                    table(ui, group.title(), rows(&bindings, *group))
                                });
                                if pads.any() && place + 1 == columns.len() {
                                    table(ui, "Gamepad", pad_rows(&buttons));
                                }
                            });
                        }
                    });
                });
            ui.label("Keys are bound anew in the panel, on its page Settings.");
        });
    if !open {
        shown.help = false;
    }
    Ok(())
}

fn table(ui: &mut egui::Ui, title: &str, rows: Vec<[String; 2]>) {
    ui.strong(title);
    egui::Grid::new(title)
        .num_columns(2)
        .spacing([12.0, 3.0])
        .show(ui, |ui| {
            for [keys, does] in rows {
                ui.monospace(keys);
                ui.label(does);
                ui.end_row();
            }
        });
    ui.add_space(10.0);
}
