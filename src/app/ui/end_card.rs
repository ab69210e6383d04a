//! A card over the picture that says where a flight has ended. The next key or click puts it away.

use crate::app::session::window::Overlays;
use bevy::prelude::*;
use bevy_egui::{EguiContexts, EguiPrimaryContextPass, egui};

/// What it says; nothing while there is no card.
#[derive(Resource, Default)]
pub(crate) struct EndCard {
    title: String,
    text: String,
}

/// Widest it gets, in points.
const MAX_WIDTH: f32 = 460.0;

impl EndCard {
    pub(crate) fn show(&mut self, title: &str, text: &str) {
        *self = Self {
            title: title.into(),
            text: text.into(),
        };
    }

    pub(crate) fn close(&mut self) {
        *self = Self::default();
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<EndCard>()
        .add_systems(PreUpdate, put_away.after(bevy::input::InputSystems));
    app.add_systems(EguiPrimaryContextPass, show);
}

fn put_away(
    keys: Res<ButtonInput<KeyCode>>,
    buttons: Res<ButtonInput<MouseButton>>,
    mut card: ResMut<EndCard>,
) {
    let used =
        keys.get_just_pressed().next().is_some() || buttons.get_just_pressed().next().is_some();
    if used && !card.title.is_empty() {
        card.close();
    }
}

fn show(mut contexts: EguiContexts, card: Res<EndCard>, shown: Res<Overlays>) -> Result {
    if card.title.is_empty() || shown.hidden {
        return Ok(());
    }
    let context = contexts.ctx_mut()?;
    egui::Area::new("card".into())
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
                    ui.label(egui::RichText::new(&card.title).size(20.0).strong());
                    ui.add_space(6.0);
                    ui.label(egui::RichText::new(&card.text).size(15.0));
                });
        });
    Ok(())
}
