//! Where the user interface is drawn, and its colours and size.

use crate::app::state::preferences::Preferences;
use crate::render::ScreenCamera;
use bevy::prelude::*;
use bevy_egui::{
    EguiContexts, EguiGlobalSettings, EguiPrimaryContextPass, PrimaryEguiContext, egui,
};

pub(crate) fn plugin(app: &mut App) {
    app.insert_resource(EguiGlobalSettings {
        auto_create_primary_context: false,
        ..default()
    })
    .add_systems(Update, attach_to_screen)
    .add_systems(
        EguiPrimaryContextPass,
        apply_theme.run_if(any_with_component::<PrimaryEguiContext>),
    );
}

/// The user interface is drawn on the screen, at its native resolution, and not on the picture.
fn attach_to_screen(mut commands: Commands, screens: Query<Entity, Added<ScreenCamera>>) {
    for screen in &screens {
        commands.entity(screen).insert(PrimaryEguiContext);
    }
}

/// Sets colours in which text is legible on any picture, and the size that the settings want.
fn apply_theme(
    mut contexts: EguiContexts,
    preferences: Res<Preferences>,
    mut scale: Local<f32>,
) -> Result {
    let context = contexts.ctx_mut()?;
    if *scale == 0.0 {
        let mut visuals = egui::Visuals::dark();
        visuals.override_text_color = Some(egui::Color32::from_gray(215));
        visuals.weak_text_color = Some(egui::Color32::from_gray(165));
        visuals.window_fill = egui::Color32::from_rgb(10, 10, 13);
        context.set_visuals(visuals);
    }
    let wanted = preferences.settings.ui_scale;
    if *scale != wanted {
        context.set_zoom_factor(wanted);
        *scale = wanted;
    }
    Ok(())
}
