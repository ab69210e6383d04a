//! Draws the end card beside the hole.

use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::state::end_card::EndCard;
use crate::app::ui::layout::{Importance, Slide};
use crate::app::ui::screen::{Screen, show_placed, text_box};
use bevy::prelude::*;
use bevy_egui::{EguiPrimaryContextPass, egui};

/// Largest width of the card, in points.
const MAX_WIDTH: f32 = 330.0;
/// Colour of the names of keys.
const KEY: egui::Color32 = egui::Color32::from_rgb(255, 205, 120);

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
        let buttons = pad_bindings.label(id);
        match (pads.is_empty() || buttons.is_empty(), keys.is_empty()) {
            (true, _) => keys,
            (false, true) => buttons,
            (false, false) => format!("{keys} or {buttons}"),
        }
    };
    let width = MAX_WIDTH.min(layout.bounds().width());
    let wish = layout
        .at(egui::Align2::RIGHT_CENTER, Slide::Anywhere)
        .even_over_hole();
    show_placed(context, layout, "end card", wish, |ui| {
        ui.set_max_width(width);
        text_box(18.0, 8.0).show(ui, |ui| {
            let white = egui::Color32::from_gray(240);
            let text =
                |text: &str, size: f32, colour| egui::RichText::new(text).size(size).color(colour);
            ui.label(text(&end_card.title, 22.0, white));
            if !end_card.text.is_empty() {
                ui.add_space(6.0);
                ui.label(text(&end_card.text, 15.0, egui::Color32::from_gray(215)));
            }
            ui.add_space(12.0);
            egui::Grid::new("ways")
                .num_columns(2)
                .spacing([16.0, 5.0])
                .show(ui, |ui| {
                    for (id, does) in &end_card.ways {
                        let inputs = inputs(id);
                        if !inputs.is_empty() {
                            ui.label(text(&inputs, 15.0, KEY));
                            ui.label(text(does, 15.0, white));
                            ui.end_row();
                        }
                    }
                });
        });
    });
}
