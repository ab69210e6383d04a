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

/// egui's own fonts, without their table of substitutions. The proportional one would draw two
/// hyphens as one dash, and so show options of the command line as nobody can type them.
fn fonts() -> egui::FontDefinitions {
    let mut fonts = egui::FontDefinitions::default();
    for data in fonts.font_data.values_mut() {
        let mut without = egui::FontData::clone(data);
        without.font = without_table(&data.font, *b"GSUB").into();
        *data = without.into();
    }
    fonts
}

/// An OpenType font in which the table with this tag cannot be found. The font's directory begins
/// with twelve bytes, of which the fifth and the sixth count its tables, and has sixteen bytes for
/// each table, of which the first four are its tag.
fn without_table(font: &[u8], tag: [u8; 4]) -> Vec<u8> {
    let mut font = font.to_vec();
    let count = font
        .get(4..6)
        .map_or(0, |count| u16::from_be_bytes([count[0], count[1]]));
    let entries = font.get_mut(12..).unwrap_or_default();
    for entry in entries.chunks_exact_mut(16).take(count.into()) {
        if entry[..4] == tag {
            // Readers skip tables that they do not know.
            entry[..4].copy_from_slice(b"none");
        }
    }
    font
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
        context.set_fonts(fonts());
    }
    let wanted = preferences.settings.ui_scale;
    if *scale != wanted {
        context.set_zoom_factor(wanted);
        *scale = wanted;
    }
    Ok(())
}
