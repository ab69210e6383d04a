//! Draws the end card over the middle of the picture.

use crate::app::state::end_card::EndCard;
use crate::app::state::overlays::Overlays;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// Largest width of the card, in points.
const MAX_WIDTH: f32 = 460.0;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(EguiPrimaryContextPass, show_end_card);
}

fn show_end_card(
    mut contexts: EguiContexts,
    end_card: Res<EndCard>,
    overlays: Res<Overlays>,
) -> Result {
    if !end_card.is_open() || overlays.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    egui::Area::new("end card".into())
        .anchor(egui::Align2::CENTER_CENTER, [0.0, 0.0])
        .interactable(false)
        .order(egui::Order::Foreground)
        .show(context, |ui| {
            ui.set_max_width(MAX_WIDTH.min(context.content_rect().width() - 40.0));
            egui::Frame::new()
                .fill(egui::Color32::from_black_alpha(225))
                .inner_margin(18)
                .corner_radius(6)
                .show(ui, |ui| {
                    ui.label(egui::RichText::new(&end_card.title).size(20.0).strong());
                    ui.add_space(6.0);
                    ui.label(egui::RichText::new(&end_card.text).size(15.0));
                });
        });
    Ok(())
}
