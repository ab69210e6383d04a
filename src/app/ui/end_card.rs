//! Draws the end card beside the hole.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::state::end_card::{EndCard, Lamp, LampKind};
use crate::app::ui::layout::{Importance, Slide};
use crate::app::ui::screen::{Screen, show_placed, text_box};
use bevy::prelude::*;
use bevy_egui::{EguiPrimaryContextPass, egui};

/// Largest width of the card, in points.
const MAX_WIDTH: f32 = 330.0;
/// Colour of the names of keys.
const KEY: egui::Color32 = egui::Color32::from_rgb(255, 205, 120);
/// Colours of the other words.
const WHITE: egui::Color32 = egui::Color32::from_gray(240);
const GREY: egui::Color32 = egui::Color32::from_gray(215);
/// Colours of the lamps that are lit.
const GOALS: egui::Color32 = egui::Color32::from_rgb(90, 225, 120);
const PAR: egui::Color32 = egui::Color32::from_rgb(255, 200, 60);
const TIME: egui::Color32 = egui::Color32::from_rgb(110, 190, 255);

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        EguiPrimaryContextPass,
        show_end_card.in_set(Importance::Cards),
    );
}

fn show_end_card(
    mut screen: Screen,
    end_card: Res<EndCard>,
    bindings: Res<Bindings>,
    pad_bindings: Res<PadBindings>,
    pads: Query<&Gamepad>,
) {
    let Some((context, layout)) = screen.texts().filter(|_| end_card.is_open()) else {
        return;
    };
    // The keys of a control and, with a gamepad, its buttons.
    let inputs = |id: &str| {
        let keys = match id {
            "preset.next" => ["preset.1", "preset.9"]
                .map(|id| bindings.label(id))
                .join(" to "),
            _ => bindings.label(id),
        };
        let buttons = match id {
            // At the ship's controls this button holds the orbit.
            "journey.fly" => String::new(),
            _ => pad_bindings.label(id),
        };
        match (pads.is_empty() || buttons.is_empty(), keys.is_empty()) {
            (true, _) => keys,
            (false, true) => buttons,
            (false, false) => format!("{keys} or {buttons}"),
        }
    };
    let ways: Vec<(String, &str)> = end_card
        .ways
        .iter()
        .map(|(id, does)| (inputs(id), *does))
        .filter(|(inputs, _)| !inputs.is_empty())
        .collect();
    let beside = layout.at(egui::Align2::RIGHT_CENTER, Slide::Anywhere);
    let below = layout.at(egui::Align2::CENTER_BOTTOM, Slide::Anywhere);
    let width = MAX_WIDTH.min(layout.bounds().width());
    let upright = |ui: &mut egui::Ui| show_upright(ui, &end_card, &ways, width);
    if show_placed(context, layout, "end card", beside, upright).is_some() {
        return;
    }
    let width = layout.bounds().width();
    let flat = |ui: &mut egui::Ui| show_flat(ui, &end_card, &ways, width);
    if show_placed(context, layout, "end card", below, flat).is_none() {
        show_placed(context, layout, "end card", below.even_over_hole(), flat);
    }
}

fn words(text: &str, size: f32, colour: egui::Color32) -> egui::RichText {
    egui::RichText::new(text).size(size).color(colour)
}

/// Shows the lamps, each with its name and what it needed.
fn show_lamps(ui: &mut egui::Ui, lamps: &[Lamp], size: f32) {
    for lamp in lamps {
        let lit = match lamp.kind {
            LampKind::Goals => GOALS,
            LampKind::Par => PAR,
            LampKind::Time => TIME,
        };
        let (sign, colour) = if lamp.is_lit {
            ("●", lit)
        } else {
            ("○", GREY)
        };
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.label(words(sign, 1.3 * size, colour));
            ui.label(words(lamp.kind.word(), size, WHITE).strong());
            ui.label(words(&lamp.needed, 0.9 * size, GREY));
        });
    }
}

/// Shows the card as a column beside the hole.
fn show_upright(ui: &mut egui::Ui, card: &EndCard, ways: &[(String, &str)], width: f32) {
    ui.set_max_width(width);
    text_box(18.0, 8.0).show(ui, |ui| {
        ui.label(words(&card.title, 22.0, WHITE));
        ui.add_space(6.0);
        if !card.text.is_empty() {
            ui.label(words(&card.text, 15.0, GREY));
            ui.add_space(6.0);
        }
        show_lamps(ui, &card.lamps, 15.0);
        if !card.details.is_empty() {
            ui.add_space(6.0);
            ui.label(words(&card.details, 14.0, GREY));
        }
        ui.add_space(6.0);
        egui::Grid::new("ways")
            .num_columns(2)
            .spacing([16.0, 5.0])
            .show(ui, |ui| {
                for (inputs, does) in ways {
                    ui.label(words(inputs, 15.0, KEY));
                    ui.label(words(does, 15.0, WHITE));
                    ui.end_row();
                }
            });
    });
}

/// Shows the card as a strip below the hole.
fn show_flat(ui: &mut egui::Ui, card: &EndCard, ways: &[(String, &str)], width: f32) {
    ui.set_max_width(width);
    text_box(6.0, 6.0).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 2.0;
        ui.label(words(&card.title, 14.0, WHITE));
        if !card.text.is_empty() {
            ui.label(words(&card.text, 12.0, GREY));
        }
        show_lamps(ui, &card.lamps, 12.0);
        if !card.details.is_empty() {
            ui.label(words(&card.details, 12.0, GREY));
        }
        ui.horizontal_wrapped(|ui| {
            for (inputs, does) in ways {
                ui.label(words(inputs, 12.0, KEY));
                ui.label(words(does, 12.0, WHITE));
                ui.add_space(6.0);
            }
        });
    });
}
