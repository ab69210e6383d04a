//! The overlay of all controls, made from the key table itself.

use super::bindings::{Bindings, PadBindings};
use super::controls::{Control, Group};
use super::gamepad::Pads;
use super::window::Shown;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// What the mouse does; the key table is about keys.
const MOUSE: [[&str; 2]; 2] = [["right mouse button", "look around"], ["wheel", "speed"]];

/// What a gamepad's sticks do; its buttons are bound.
const STICKS: [[&str; 2]; 2] = [["left stick", "fly"], ["right stick", "look around"]];

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show);
}

/// The rows under one heading: keys, and what they do. Controls in a row that do the same are one row.
fn rows(bindings: &Bindings, group: Group) -> Vec<[String; 2]> {
    let controls: Vec<&Control> =
        bindings.iter().map(|(control, _)| control).filter(|control| control.group == group).collect();
    let entries = controls.chunk_by(|a, b| a.does == b.does).map(|entry| {
        let names: Vec<_> = entry.iter().map(|control| bindings.in_words(control)).filter(|n| !n.is_empty()).collect();
        let numbers = names.len() > 2 && names.iter().all(|name| name.len() == 1 && name.parse::<u8>().is_ok());
        let keys = match (numbers, names.as_slice()) {
            (true, [first, .., last]) => format!("{first} to {last}"),
            _ => names.join(" "),
        };
        [keys, entry[0].does.to_owned()]
    });
    let mouse = MOUSE.iter().filter(|_| group == Group::Flight).map(|row| row.map(str::to_owned));
    entries.chain(mouse).collect()
}

/// The rows of a gamepad: its sticks, and the controls that have buttons.
fn pad_rows(buttons: &PadBindings) -> Vec<[String; 2]> {
    let bound: Vec<&Control> = buttons.iter().filter(|(_, own)| !own.is_empty()).map(|(control, _)| control).collect();
    let entries = bound.chunk_by(|a, b| a.does == b.does).map(|entry| {
        let names: Vec<_> = entry.iter().map(|control| buttons.in_words(control)).collect();
        [names.join(" "), entry[0].does.to_owned()]
    });
    STICKS.iter().map(|row| row.map(str::to_owned)).chain(entries).collect()
}

fn show(
    mut contexts: EguiContexts,
    mut shown: ResMut<Shown>,
    bindings: Res<Bindings>,
    buttons: Res<PadBindings>,
    pads: Pads,
) -> Result {
    if !shown.help || shown.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let mut open = true;
    egui::Window::new("Help")
        .open(&mut open)
        .order(egui::Order::Foreground)
        .collapsible(false)
        .resizable(false)
        .anchor(egui::Align2::CENTER_CENTER, [0.0, -20.0])
        .default_width((context.content_rect().width() - 40.0).min(1000.0))
        .show(context, |ui| {
            let tallest = (context.content_rect().height() - 180.0).max(100.0);
            egui::ScrollArea::both().max_height(tallest).show(ui, |ui| {
                ui.horizontal_top(|ui| {
                    for (place, groups) in columns(pads.any()).into_iter().enumerate() {
                        ui.add_space(if place == 0 { 0.0 } else { 24.0 });
                        ui.vertical(|ui| {
                            for group in groups {
                                table(ui, group.title(), rows(&bindings, *group));
                            }
                            if place == 2 && pads.any() {
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

/// The headings of each column; a gamepad's own stands under the last.
fn columns(pad: bool) -> [&'static [Group]; 3] {
    if pad {
        [&[Group::Flight, Group::Picture], &[Group::Scene, Group::Light, Group::View], &[Group::Window]]
    } else {
        [&[Group::Flight, Group::Light], &[Group::Scene, Group::View], &[Group::Picture, Group::Window]]
    }
}

fn table(ui: &mut egui::Ui, title: &str, rows: Vec<[String; 2]>) {
    ui.strong(title);
    egui::Grid::new(title).num_columns(2).spacing([12.0, 3.0]).show(ui, |ui| {
        for [keys, does] in rows {
            ui.monospace(keys);
            ui.label(does);
            ui.end_row();
        }
    });
    ui.add_space(10.0);
}
