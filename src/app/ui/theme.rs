//! The user interface's colours, fonts and size, and the camera that draws it.

use crate::app::state::preferences::Preferences;
use bevy::prelude::*;
use bevy_egui::{
    EguiContexts, EguiGlobalSettings, EguiPrimaryContextPass, PrimaryEguiContext, egui,
};
use lightfall_render::ScreenCamera;

/// The colour of everything chosen: that of the disk's light.
pub(crate) const ACCENT: egui::Color32 = egui::Color32::from_rgb(255, 178, 92);
/// Colour of texts.
pub(crate) const TEXT: egui::Color32 = egui::Color32::from_gray(222);
/// Colour of less important texts. Its contrast on the panel is 7:1.
pub(crate) const WEAK_TEXT: egui::Color32 = egui::Color32::from_gray(160);
/// Colour of panels.
pub(crate) const PANEL_FILL: egui::Color32 = egui::Color32::from_rgb(13, 13, 17);
/// Colour of text fields.
const FIELD_FILL: egui::Color32 = egui::Color32::from_rgb(24, 24, 30);
/// Sizes of the texts that appear over the picture, in points.
const LETTER_SIZES: [f32; 6] = [12.5, 13.0, 13.5, 15.0, 16.0, 20.0];
/// Colour of frames, buttons and the rails of sliders.
const FRAME: egui::Color32 = egui::Color32::from_gray(58);

pub(crate) fn plugin(app: &mut App) {
    app.insert_resource(EguiGlobalSettings {
        auto_create_primary_context: false,
        ..default()
    })
    .add_systems(Update, attach_to_screen)
    .add_systems(
        EguiPrimaryContextPass,
        (prepare_letters, apply_theme).chain(),
    );
}

/// The user interface is drawn on the screen, at its native resolution, and not on the picture.
fn attach_to_screen(mut commands: Commands, screens: Query<Entity, Added<ScreenCamera>>) {
    for screen in &screens {
        commands.entity(screen).insert(PrimaryEguiContext);
    }
}

/// egui's own fonts without their tables of substitutions. The proportional font would draw the two
/// hyphens of an option of the command line as one dash.
fn fonts() -> egui::FontDefinitions {
    let mut fonts = egui::FontDefinitions::default();
    for data in fonts.font_data.values_mut() {
        let mut without = egui::FontData::clone(data);
        without.font = without_table(&data.font, *b"GSUB").into();
        *data = without.into();
    }
    fonts
}

/// An OpenType font without the table with this tag. The font begins with a header of twelve bytes, of
/// which the fifth and the sixth are the number of tables. Then come sixteen bytes for each table, of
/// which the first four are its tag.
fn without_table(font: &[u8], tag: [u8; 4]) -> Vec<u8> {
    let mut font = font.to_vec();
    let count = font
        .get(4..6)
        .map_or(0, |count| u16::from_be_bytes([count[0], count[1]]));
    let entries = font.get_mut(12..).unwrap_or_default();
    for entry in entries.chunks_exact_mut(16).take(count.into()) {
        if entry[..4] == tag {
            // Readers skip tables with unknown tags.
            entry[..4].copy_from_slice(b"none");
        }
    }
    font
}

/// Sets the colours, the fonts, and the size of the settings.
fn apply_theme(
    mut contexts: EguiContexts,
    preferences: Res<Preferences>,
    mut scale: Local<f32>,
) -> Result {
    let context = contexts.ctx_mut()?;
    if *scale == 0.0 {
        context.set_visuals(visuals());
        context.set_fonts(fonts());
        context.all_styles_mut(|style| {
            style.spacing.item_spacing = egui::vec2(8.0, 5.0);
            style.spacing.button_padding = egui::vec2(8.0, 3.0);
            style.spacing.interact_size.y = 22.0;
            style.interaction.tooltip_delay = 0.35;
        });
        // In slow frames even a short click takes long.
        context.options_mut(|options| options.input_options.max_click_duration = f64::INFINITY);
    }
    let wanted = preferences.settings.ui_scale;
    if *scale != wanted {
        context.set_zoom_factor(wanted);
        *scale = wanted;
    }
    Ok(())
}

/// Lays out every usual letter in the sizes of the texts over the picture. Otherwise a letter would be
/// missing in its first frame, because its image reaches the adapter one frame late.
fn prepare_letters(mut contexts: EguiContexts, mut prepared: Local<[(f32, usize); 2]>) -> Result {
    let context = contexts.ctx_mut()?;
    // New fonts and a new scale clear the cache of letters in the next frame.
    let scale = context.pixels_per_point();
    let fonts = context.fonts(|fonts| fonts.definitions().font_data.len());
    if *prepared == [(scale, fonts); 2] {
        return Ok(());
    }
    *prepared = [prepared[1], (scale, fonts)];
    let letters: String = (' '..='~').chain("·–−×°…".chars()).collect();
    context.fonts_mut(|fonts| {
        for size in LETTER_SIZES {
            // A letter has one image for each quarter of a pixel of its position.
            for quarter in 0..4 {
                let offset = 0.25 * quarter as f32 / scale;
                let format = egui::TextFormat::simple(egui::FontId::proportional(size), TEXT);
                let mut job = egui::text::LayoutJob::default();
                job.append(&letters, offset, format);
                fonts.layout_job(job);
            }
        }
    });
    Ok(())
}

/// Calm grey surfaces, framed fields, and one colour for what is chosen.
fn visuals() -> egui::Visuals {
    let mut visuals = egui::Visuals::dark();
    visuals.weak_text_color = Some(WEAK_TEXT);
    visuals.hyperlink_color = ACCENT;
    visuals.window_fill = PANEL_FILL;
    visuals.panel_fill = PANEL_FILL;
    visuals.window_stroke = egui::Stroke::new(1.0, FRAME);
    visuals.extreme_bg_color = FIELD_FILL;
    visuals.text_edit_bg_color = Some(FIELD_FILL);
    visuals.selection.bg_fill = ACCENT.gamma_multiply(0.30);
    visuals.selection.stroke = egui::Stroke::new(1.0, egui::Color32::WHITE);
    visuals.slider_trailing_fill = true;
    visuals.handle_shape = egui::style::HandleShape::Circle;
    let widgets = &mut visuals.widgets;
    for widget in [
        &mut widgets.noninteractive,
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.active,
        &mut widgets.open,
    ] {
        widget.corner_radius = 4.into();
        widget.fg_stroke.color = TEXT;
        widget.expansion = 0.0;
    }
    widgets.noninteractive.bg_stroke.color = egui::Color32::from_gray(40);
    widgets.inactive.bg_fill = egui::Color32::from_gray(52);
    widgets.inactive.weak_bg_fill = egui::Color32::from_gray(36);
    widgets.inactive.bg_stroke = egui::Stroke::new(1.0, FRAME);
    widgets.hovered.bg_fill = egui::Color32::from_gray(72);
    widgets.hovered.weak_bg_fill = egui::Color32::from_gray(50);
    widgets.hovered.bg_stroke = egui::Stroke::new(1.0, egui::Color32::from_gray(110));
    widgets.hovered.fg_stroke.color = egui::Color32::WHITE;
    widgets.active.bg_fill = ACCENT.gamma_multiply(0.5);
    widgets.active.weak_bg_fill = ACCENT.gamma_multiply(0.35);
    widgets.active.bg_stroke = egui::Stroke::new(1.0, ACCENT);
    widgets.active.fg_stroke.color = egui::Color32::WHITE;
    visuals
}
