//! The help: a list of every control, made from the table of controls.

use super::ship_help::{AT_HELM, is_ship_control, ship_pad_rows, ship_rows};
use crate::app::controls::bindings::{Bindable, BindingTable, Bindings, PadBindings};
use crate::app::controls::control::Group::{self, Flight, Light, Picture, Scene, View, Window};
use crate::app::controls::control::{Control, Modifier};
use crate::app::input::gamepad::Pads;
use crate::app::input::touch::Fingers;
use crate::app::state::helm::Helm;
use crate::app::state::overlays::Overlays;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};
use std::iter;

/// What the mouse does. The control table holds keys only.
const MOUSE: [[&str; 2]; 2] = [["right mouse", "look around"], ["wheel", "speed"]];

/// What the mouse does at the ship's controls, apart from the wheel, which is among the ship's rows.
const MOUSE_AT_HELM: [[&str; 2]; 1] = [["right mouse", "turn the ship"]];

/// What a gamepad's sticks do. Its buttons are bound to controls.
const STICKS: [[&str; 2]; 2] = [["left stick", "fly"], ["right stick", "look around"]];

/// What fingers do on a screen that was touched.
const FINGERS: [[&str; 2]; 4] = [
    ["finger", "look around"],
    ["two, pinch", "field of view, or distance"],
    ["two, turn", "roll"],
    ["tap", "menu, places, ship, fall, photo"],
];

/// Arrangements of the headings in columns. The first one that fits the window is used.
const COLUMNS: [&[&[Group]]; 4] = [
    &[&[Flight], &[Light, Scene], &[View, Picture], &[Window]],
    &[&[Flight, Light], &[Scene, View], &[Picture, Window]],
    &[&[Light, Flight, View], &[Scene, Picture, Window]],
    &[&Group::ALL],
];
/// The same, with room for the gamepad's table below the last column.
const COLUMNS_WITH_GAMEPAD: [&[&[Group]]; 4] = [
    &[&[Flight], &[Light, Scene], &[View, Picture], &[Window]],
    &[&[Flight, Picture], &[Light, Scene, View], &[Window]],
    &[&[Light, Flight, View, Window], &[Scene, Picture]],
    &[&Group::ALL],
];
/// Name of the help's window.
pub(crate) const HELP: &str = "Help";
/// Mean width of a column with the room after it, in points: a few more than the words take.
const COLUMN_WIDTH: f32 = 350.0;
/// Room between two columns, in points.
const COLUMN_GAP: f32 = 20.0;
/// Least width of the keys in a column, in points.
const KEYS_WIDTH: f32 = 90.0;
/// Colour of the groups' headings: that of the disk's light.
const HEADING: egui::Color32 = egui::Color32::from_rgb(255, 200, 130);
/// The meaning of the unit of length, for beginners.
pub(crate) const RADIUS_UNIT: &str =
    "r_s: the Schwarzschild radius, the radius of the horizon without spin.";
/// Free room around the help, in points.
const MARGIN: f32 = 24.0;
/// Height of the title above the list and of the line below it, in points.
const TITLE_HEIGHT: f32 = 92.0;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_help);
}

/// The rows below one heading: keys, and what they do.
#[must_use]
pub fn help_rows(bindings: &Bindings, group: Group) -> Vec<[String; 2]> {
    let mut rows = rows(bindings, |control, _| control.group == group);
    if group == Flight {
        rows.extend(rows_of(MOUSE));
    }
    rows
}

/// The same at the ship's controls, without what its own rows say.
#[must_use]
pub fn help_rows_at_helm(bindings: &Bindings, group: Group, on_mission: bool) -> Vec<[String; 2]> {
    let mut rows = rows(bindings, |control, _| {
        control.group == group && !is_ship_control(control.id, on_mission)
    });
    if group == Flight {
        rows.extend(rows_of(MOUSE_AT_HELM));
    }
    rows
}

fn rows_of<const N: usize>(rows: [[&str; 2]; N]) -> Vec<[String; 2]> {
    rows.map(|row| row.map(str::to_owned)).to_vec()
}

/// The rows of a gamepad: its sticks, and the controls that are bound to buttons.
fn pad_rows(buttons: &PadBindings) -> Vec<[String; 2]> {
    let mut all = rows_of(STICKS);
    all.extend(rows(buttons, |_, own| !own.is_empty()));
    all
}

/// The names of the listed controls' inputs, and what they do. Neighbouring controls with the same
/// description share a row.
fn rows<B: Bindable>(
    bindings: &BindingTable<B>,
    is_listed: impl Fn(&Control, &[B]) -> bool,
) -> Vec<[String; 2]> {
    let listed = bindings
        .iter()
        .filter(|(control, own)| is_listed(control, own));
    let controls: Vec<&Control> = listed.map(|(control, _)| control).collect();
    let rows = controls.chunk_by(|a, b| a.description == b.description);
    rows.map(|row| {
        let names = row.iter().map(|control| bindings.label_of(control));
        let names: Vec<_> = names.filter(|name| !name.is_empty()).collect();
        let is_digit = |name: &String| name.len() == 1 && name.parse::<u8>().is_ok();
        let words: Vec<&str> = names.iter().map(String::as_str).collect();
        let inputs = match words.as_slice() {
            [first, _, .., last] if names.iter().all(is_digit) => format!("{first} to {last}"),
            ["Left", "Right", "Up", "Down"] => "arrow keys".to_owned(),
            // The modifier is named once.
            [first, others @ ..] => {
                let prefix = B::modifier(row[0]).map_or("", Modifier::prefix);
                let short = others
                    .iter()
                    .map(|name| name.strip_prefix(prefix).unwrap_or(name));
                iter::once(*first)
                    .chain(short)
                    .collect::<Vec<_>>()
                    .join(" ")
            }
            [] => String::new(),
        };
        [inputs, row[0].description.to_owned()]
    })
    .collect()
}

fn show_help(
    mut contexts: EguiContexts,
    mut overlays: ResMut<Overlays>,
    bindings: Res<Bindings>,
    buttons: Res<PadBindings>,
    (pads, fingers, helm): (Pads, Res<Fingers>, Res<Helm>),
) -> Result {
    if !overlays.help || overlays.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    let room = context.content_rect().size() - egui::Vec2::splat(MARGIN);
    let sets = if pads.any() {
        COLUMNS_WITH_GAMEPAD
    } else {
        COLUMNS
    };
    let columns = sets
        .into_iter()
        .find(|columns| columns.len() as f32 * COLUMN_WIDTH < room.x)
        .unwrap_or(sets[3]);
    let on_mission = matches!(*helm, Helm::Mission | Helm::MissionOver);
    egui::Window::new(HELP)
        .open(&mut overlays.help)
        .order(egui::Order::Foreground)
        .collapsible(false)
        .resizable(false)
        .anchor(egui::Align2::CENTER_CENTER, [0.0, 0.0])
        .show(context, |ui| {
            ui.set_max_width(room.x);
            // Solid scroll bars show that there is more.
            ui.spacing_mut().scroll = egui::style::ScrollStyle::solid();
            egui::ScrollArea::both()
                .max_height((room.y - TITLE_HEIGHT).max(40.0))
                .show(ui, |ui| {
                    ui.horizontal_top(|ui| {
                        ui.spacing_mut().item_spacing.x = COLUMN_GAP;
                        for (place, groups) in columns.iter().enumerate() {
                            ui.vertical(|ui| {
                                if helm.has_ship() && place == 0 {
                                    table(ui, AT_HELM, ship_rows(&bindings, on_mission));
                                }
                                groups.iter().for_each(|group| {
                                    let rows = if helm.has_ship() {
                                        help_rows_at_helm(&bindings, *group, on_mission)
                                    } else {
                                        help_rows(&bindings, *group)
                                    };
                                    table(ui, group.title(), rows);
                                });
                                if pads.any() && place + 1 == columns.len() {
                                    let rows = match helm.has_ship() {
                                        true => ship_pad_rows(&buttons),
                                        false => pad_rows(&buttons),
                                    };
                                    table(ui, "Gamepad", rows);
                                }
                                if fingers.seen && place + 1 == columns.len() {
                                    table(ui, "Touch", rows_of(FINGERS));
                                }
                            });
                        }
                    });
                });
            ui.add_space(4.0);
            let [help, panel] = ["window.help", "window.panel"].map(|id| bindings.first_label(id));
            ui.label(format!(
                "{help} closes this help.   Rebind keys in the panel ({panel}) > Settings.   {RADIUS_UNIT}"
            ));
        });
    Ok(())
}

fn table(ui: &mut egui::Ui, title: &str, rows: Vec<[String; 2]>) {
    ui.label(egui::RichText::new(title).size(15.0).color(HEADING));
    ui.add_space(2.0);
    egui::Grid::new(title)
        .num_columns(2)
        .min_col_width(KEYS_WIDTH)
        // As high as the words: a list to read needs no room for a finger.
        .min_row_height(0.0)
        .spacing([10.0, 2.0])
        .show(ui, |ui| {
            for [keys, does] in rows {
                ui.label(egui::RichText::new(keys).monospace().strong());
                ui.label(does);
                ui.end_row();
            }
        });
    ui.add_space(9.0);
}
