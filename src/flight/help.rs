//! The overlay of all controls, made from the key table itself.

use super::bindings::{Bindings, PadBindings};
use super::controls::{Control, Group};
use super::gamepad::Pads;
use super::window::Shown;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// What the mouse and the right stick do; the tables are about keys and buttons.
const MOUSE: [[&str; 3]; 2] = [["right mouse button", "right stick", "look around"], ["wheel", "", "speed"]];
/// The control that stands for those of the left stick.
const LEFT_STICK: &str = "fly.forward";

pub(super) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show);
}

/// The rows under one heading: keys, buttons of a gamepad, and what they do. Controls in a row that do the same are one row.
fn rows(bindings: &Bindings, buttons: &PadBindings, group: Group) -> Vec<[String; 3]> {
    let controls: Vec<&Control> =
        bindings.iter().map(|(control, _)| control).filter(|control| control.group == group).collect();
    let entries = controls.chunk_by(|a, b| a.does == b.does).map(|entry| {
        let names: Vec<_> = entry.iter().map(|control| bindings.in_words(control)).filter(|n| !n.is_empty()).collect();
        let numbers = names.len() > 2 && names.iter().all(|name| name.len() == 1 && name.parse::<u8>().is_ok());
        let keys = match (numbers, names.as_slice()) {
            (true, [first, .., last]) => format!("{first} to {last}"),
            _ => names.join(" "),
        };
        let stick = entry.iter().any(|control| control.id == LEFT_STICK).then(|| "left stick".to_owned());
        let on_pad = entry.iter().map(|control| buttons.in_words(control)).filter(|n| !n.is_empty()).chain(stick);
        [keys, on_pad.collect::<Vec<_>>().join(" "), entry[0].does.to_owned()]
    });
    let mouse = MOUSE.iter().filter(|_| group == Group::Flight).map(|row| row.map(str::to_owned));
    entries.chain(mouse).collect()
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
    let column = |ui: &mut egui::Ui, groups: &[Group]| column(ui, &bindings, &buttons, pads.any(), groups);
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
                    column(ui, &[Group::Flight, Group::Light]);
                    ui.add_space(24.0);
                    column(ui, &[Group::Scene, Group::View]);
                    ui.add_space(24.0);
                    column(ui, &[Group::Picture, Group::Window]);
                });
            });
            ui.label("Keys are bound anew in the panel, on its page Settings.");
        });
    if !open {
        shown.help = false;
    }
    Ok(())
}

/// The rows of some groups; without a gamepad, its buttons are no news.
fn column(ui: &mut egui::Ui, bindings: &Bindings, buttons: &PadBindings, pad: bool, groups: &[Group]) {
    ui.vertical(|ui| {
        for group in groups {
            ui.strong(group.title());
            egui::Grid::new(group.title()).spacing([12.0, 3.0]).show(ui, |ui| {
                for [keys, on_pad, does] in rows(bindings, buttons, *group) {
                    ui.monospace(keys);
                    if pad {
                        ui.weak(on_pad);
                    }
                    ui.label(does);
                    ui.end_row();
                }
            });
            ui.add_space(10.0);
        }
    });
}
