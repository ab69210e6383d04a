//! The page of the scene: one row for every field of the field table, so that a new field appears
//! here by itself.

use super::field_value::{VALUE_WIDTH, show_value};
use super::step_count::StepCounter;
use crate::app::controls::bindings::Bindings;
use crate::app::state::scene_editor::SceneEditor;
use crate::render::letterbox;
use bevy::math::UVec2;
use bevy_egui::egui;
use lightfall_core::scene::{FIELDS, Field, Picture, Range, Value};
use std::ops::Bound::Included;

/// Smallest width of a row's name, in points.
const MIN_NAME_WIDTH: f32 = 90.0;
/// Width kept for the button that resets a row, in points.
const RESET_WIDTH: f32 = 36.0;

/// The tables that are open at first.
const OPEN_TABLES: [&str; 3] = ["scene", "hole", "camera"];

/// The fields below which the number of steps is shown.
const FIELDS_WITH_STEPS: [&str; 2] = ["method", "quality.max_error_px"];

/// What the page remembers.
#[derive(Default)]
pub(super) struct ScenePage {
    /// The field whose last change was refused, and why.
    refused: Option<(&'static str, String)>,
}

/// The field below which the number of cells or pixels in the window is shown.
const FIELD_WITH_CELLS: &str = "picture.grid_height";

impl ScenePage {
    pub(super) fn show(
        &mut self,
        ui: &mut egui::Ui,
        editor: &mut SceneEditor,
        steps: &StepCounter,
        bindings: &Bindings,
        window: UVec2,
    ) {
        ui.horizontal(|ui| {
            if ui
                .button("Reset all")
                .on_hover_text("Everything as it was loaded")
                .clicked()
            {
                editor.reset();
                self.refused = None;
            }
            if ui.button("Undo").clicked() {
                editor.undo();
                self.refused = None;
            }
            ui.weak("Point at a name to see what it means.");
        });
        ui.spacing_mut().slider_width = 100.0;
        let scene = editor.scene();
        let values: Vec<(&Field, Value)> = scene.values().collect();
        let loaded: Vec<Value> = editor.loaded().values().map(|(_, value)| value).collect();
        let mut change = None;
        for (heading, first, last) in tables() {
            egui::CollapsingHeader::new(heading).default_open(OPEN_TABLES.contains(&heading)).show(ui, |ui| {
            for (i, (field, value)) in values.iter().enumerate().take(last).skip(first) {
                let (range, _) = scene.range(field);
                if matches!(range, Range { low: Included(low), high: Included(high) } if low == high) {
                    continue;
                }
                let fresh = row(ui, field, value, range, &loaded[i]);
                change = fresh.map(|fresh| (field.key, fresh)).or(change.take());
                if let Some((_, reason)) = self.refused.as_ref().filter(|(key, _)| *key == field.key) {
                    ui.colored_label(ui.visuals().error_fg_color, reason);
                }
                if FIELDS_WITH_STEPS.contains(&field.key) {
                    ui.weak(steps.in_words()).on_hover_text("The work that method and error setting mean for this picture");
                }
                if field.key == FIELD_WITH_CELLS {
                    ui.weak(drawn_in_words(&editor.drawn_scene().picture, window, bindings));
                }
            }
        });
        }
        if let Some((key, value)) = change {
            // An exposure that is set by hand stays as it is.
            let by_hand = (key == "picture.exposure_ev")
                .then_some(("picture.automatic_exposure", Value::Boolean(false)));
            let changed = scene
                .with([(key, value)].into_iter().chain(by_hand))
                .map_err(|refusal| refusal.to_string())
                .and_then(|changed| editor.try_change(changed));
            self.refused = changed.err().map(|reason| (key, reason));
        }
    }
}

/// How the picture is drawn in a window of this many pixels: its cells, or its pixels.
fn drawn_in_words(picture: &Picture, window: UVec2, bindings: &Bindings) -> String {
    let extent = letterbox(picture, window).extent;
    if picture.bypass {
        let UVec2 { x, y } = picture.size();
        return format!("Drawn here with {x} x {y} pixels");
    }
    let grid = picture.grid();
    format!(
        "Drawn here with {} x {} cells, {:.0} pixels wide; {} shows every pixel",
        grid.x,
        grid.y,
        extent.x / grid.x as f32,
        bindings.label("picture.bypass")
    )
}

/// The tables of the field table: a heading, the first field, and one past the last field.
fn tables() -> Vec<(&'static str, usize, usize)> {
    let table = |field: &Field| {
        field
            .key
            .split_once('.')
            .map_or("scene", |(table, _)| table)
    };
    let mut first = 0;
    FIELDS
        .chunk_by(|a, b| table(a) == table(b))
        .map(|fields| {
            let part = (table(&fields[0]), first, first + fields.len());
            first = part.2;
            part
        })
        .collect()
}

/// Shows one field. Returns its new value if it was changed.
fn row(
    ui: &mut egui::Ui,
    field: &Field,
    value: &Value,
    range: Range,
    loaded: &Value,
) -> Option<Value> {
    let name = field
        .key
        .split_once('.')
        .map_or(field.key, |(_, name)| name);
    let mut change = None;
    let width = ui
        .available_width()
        .min(ui.clip_rect().right() - ui.cursor().left())
        - VALUE_WIDTH
        - RESET_WIDTH;
    let width = width.max(MIN_NAME_WIDTH);
    ui.horizontal(|ui| {
        ui.set_min_height(22.0);
        ui.spacing_mut().item_spacing.x = 4.0;
        let text = egui::RichText::new(name);
        let text = if value == loaded { text } else { text.strong() };
        let about = format!("{}\n{} = {}", field.about, field.key, field.allowed());
        let left = egui::Layout::left_to_right(egui::Align::Center);
        ui.allocate_ui_with_layout(egui::vec2(width, 20.0), left, |ui| {
            ui.set_min_width(width);
            ui.add(egui::Label::new(text).truncate())
                .on_hover_text(about);
        });
        ui.allocate_ui_with_layout(egui::vec2(VALUE_WIDTH, 20.0), left, |ui| {
            ui.set_min_width(VALUE_WIDTH);
            change = show_value(ui, field, value, range);
        });
        if value != loaded
            && ui
                .small_button("⟲")
                .on_hover_text("As it was loaded")
                .clicked()
        {
            change = Some(loaded.clone());
        }
    });
    change
}
