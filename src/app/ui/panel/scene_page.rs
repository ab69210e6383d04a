//! The page of the scene: one row for every field of the field table, in sections.

use super::field_value::show_value;
use super::step_count::StepCounter;
use crate::app::controls::bindings::Bindings;
use crate::app::controls::sections::{RowText, SECTIONS};
use crate::app::state::paused::Paused;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::ui::theme::{ACCENT, WEAK_TEXT};
use bevy::math::UVec2;
use bevy_egui::egui;
use lightfall_core::scene::{ArticleQuality, Field, Idle, Output, Picture, Scene, Value, field};
use lightfall_render::letterbox;

/// Width of a row's label and of the button that resets it, in points.
const LABEL_WIDTH: f32 = 126.0;
const RESET_WIDTH: f32 = 22.0;
/// Opacity of a row that changes nothing at present.
const IDLE_OPACITY: f32 = 0.45;

/// The field that the disk's clock changes.
const FIELD_OF_CLOCK: &str = "disk.time";
/// The last of the fields that the article's qualities set.
const FIELD_OF_QUALITIES: &str = "quality.max_steps";

/// The scene that a row asks for, or what is wrong with its new value.
type Change = Result<Scene, String>;

pub(super) fn show(
    ui: &mut egui::Ui,
    editor: &mut SceneEditor,
    steps: &StepCounter,
    bindings: &Bindings,
    paused: &mut Paused,
    window: UVec2,
) {
    show_head(ui, editor, bindings);
    let scene = editor.scene();
    let loaded = editor.loaded().clone();
    let mut change = None;
    for section in SECTIONS {
        let heading = egui::RichText::new(section.title).strong().size(15.0);
        egui::CollapsingHeader::new(heading)
            .id_salt(section.title)
            .default_open(section.open)
            .show_unindented(ui, |ui| {
                for row in section.rows {
                    let Some(field) = field(row.key) else {
                        continue;
                    };
                    let mut asked = show_row(ui, row, field, &scene, &loaded);
                    match field.key {
                        "method" => {
                            ui.weak(steps.in_words()).on_hover_text(
                                "The work that method and quality mean for this picture",
                            );
                        }
                        FIELD_OF_QUALITIES => asked = asked.or(quality_buttons(ui, &scene)),
                        FIELD_OF_CLOCK if scene.disk_moves() => pause_button(ui, bindings, paused),
                        "picture.grid_height" => {
                            let drawn = &editor.drawn_scene().picture;
                            ui.weak(drawn_in_words(drawn, window, bindings));
                        }
                        _ => {}
                    }
                    change = asked.or(change.take());
                }
                ui.add_space(6.0);
            });
    }
    if let Some(Err(reason)) = change.map(|scene| editor.try_change(scene?)) {
        editor.say(reason);
    }
}

/// The buttons above the rows.
fn show_head(ui: &mut egui::Ui, editor: &mut SceneEditor, bindings: &Bindings) {
    ui.horizontal(|ui| {
        let reset = format!("Every field as {} has it", editor.loaded().name);
        if ui
            .button("Back to the preset")
            .on_hover_text(reset)
            .clicked()
        {
            editor.reset();
        }
        let key = bindings.label("scene.undo");
        let undo = format!("Takes the last change back, as {key} does");
        if ui.button("Undo").on_hover_text(undo).clicked() {
            editor.undo();
        }
    });
    let hint = egui::RichText::new("Point at a name to see what it means.");
    ui.label(hint.size(12.5).color(WEAK_TEXT));
    ui.add_space(2.0);
}

/// Offers the article's qualities for the methods that take steps. Returns the scene with the one
/// that was chosen.
fn quality_buttons(ui: &mut egui::Ui, scene: &Scene) -> Option<Change> {
    if scene.idle(FIELD_OF_QUALITIES, Output::Window).is_some() {
        return None;
    }
    let mut change = None;
    ui.horizontal(|ui| {
        ui.add_space(LABEL_WIDTH + 6.0);
        for named in ArticleQuality::ALL {
            let (scale, steps) = (named.step_scale(), named.max_steps());
            let button = ui
                .selectable_label(scene.quality.article() == Some(named), named.word())
                .on_hover_text(format!(
                    "The article's quality: a step size of {scale}, {steps} steps at most"
                ));
            if button.clicked() {
                change = Some(Ok(Scene {
                    quality: scene.quality.with_steps_of(named),
                    ..scene.clone()
                }));
            }
        }
    });
    change
}

/// The button that pauses the disk's clock, and lets it go on.
fn pause_button(ui: &mut egui::Ui, bindings: &Bindings, paused: &mut Paused) {
    ui.horizontal(|ui| {
        ui.add_space(LABEL_WIDTH + 6.0);
        let text = if paused.0 {
            "Run the clock"
        } else {
            "Pause the clock"
        };
        let key = bindings.label("motion.pause");
        let button = ui.button(text).on_hover_text(format!(
            "As {key} does: journeys and falls stand still, too"
        ));
        if button.clicked() {
            paused.0 = !paused.0;
        }
    });
}

/// Shows one field. Returns the scene with its new value if it was changed.
fn show_row(
    ui: &mut egui::Ui,
    row: &RowText,
    field: &Field,
    scene: &Scene,
    loaded: &Scene,
) -> Option<Change> {
    let (value, original) = (field.get(scene), field.get(loaded));
    let (range, _) = scene.range(field);
    let idle = scene.idle(field.key, Output::Window);
    let mut change = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        if idle.is_some() {
            ui.set_opacity(IDLE_OPACITY);
        }
        let is_changed = value != original;
        // A time to which the clock has gone on is not a change of the preset.
        let colour = if is_changed && field.key != FIELD_OF_CLOCK {
            ACCENT
        } else {
            ui.visuals().text_color()
        };
        ui.allocate_ui(egui::vec2(LABEL_WIDTH, 22.0), |ui| {
            ui.set_min_width(LABEL_WIDTH);
            let label = egui::Label::new(egui::RichText::new(row.label).color(colour));
            ui.add(label.truncate().sense(egui::Sense::hover()))
                .on_hover_text(help(field, idle));
        });
        let width = ui.available_width() - RESET_WIDTH;
        ui.allocate_ui(egui::vec2(width, 22.0), |ui| {
            ui.set_min_width(width);
            change = show_value(ui, field, row.shown, scene, range).transpose();
        });
        if is_changed {
            let reset = ui.add(egui::Button::new("⟲").small().frame(false));
            if reset.on_hover_text("As the preset has it").clicked() {
                change = Some(Ok(original));
            }
        }
    });
    change.map(|value| with_value(scene, field, value?))
}

/// The scene with a field's new value. An exposure that is set by hand is no longer automatic.
///
/// # Errors
/// Why the field cannot have this value.
fn with_value(scene: &Scene, field: &Field, value: Value) -> Change {
    let by_hand = (field.key == "picture.exposure_ev")
        .then_some(("picture.automatic_exposure", Value::Boolean(false)));
    scene
        .with([(field.key, value)].into_iter().chain(by_hand))
        .map_err(|refusal| refusal.to_string())
}

/// The help of a field: why it changes nothing at present, what it means, and its name and allowed
/// values in a preset.
fn help(field: &Field, idle: Option<Idle>) -> String {
    let help = format!("{}\n\n{}: {}", field.about, field.key, field.allowed());
    match idle {
        Some(idle) => format!("{}\n\n{help}", idle.sentence()),
        None => help,
    }
}

/// The number of cells, or of pixels, with which the picture is drawn in a window of this size.
fn drawn_in_words(picture: &Picture, window: UVec2, bindings: &Bindings) -> String {
    if picture.bypass {
        let UVec2 { x, y } = picture.size();
        return format!("Drawn here with {x} x {y} pixels");
    }
    let UVec2 { x, y } = picture.grid();
    let width = letterbox(picture, window).extent.x / x as f32;
    let key = bindings.first_label("picture.bypass");
    format!("Drawn here with {x} x {y} cells, {width:.0} pixels wide; {key} shows every pixel")
}
