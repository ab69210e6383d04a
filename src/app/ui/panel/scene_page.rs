//! The page of the scene: one row for every field of the field table, in sections.

use super::field_value::show_value;
use super::idle::why_idle;
use super::sections::{RowText, SECTIONS, Shown};
use super::step_count::StepCounter;
use crate::app::controls::bindings::Bindings;
use crate::app::state::paused::Paused;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::ui::theme::{ACCENT, WEAK_TEXT};
use bevy::math::UVec2;
use bevy_egui::egui;
use lightfall_core::scene::{ArticleQuality, FIELDS, Field, Picture, Range, Scene, Value, field};
use lightfall_render::letterbox;
use std::ops::Bound::Included;

/// Width of a row's label and of the button that resets it, in points.
const LABEL_WIDTH: f32 = 126.0;
const RESET_WIDTH: f32 = 22.0;
/// Opacity of a row that changes nothing at present.
const IDLE_OPACITY: f32 = 0.45;

/// The field below which the number of steps is shown.
const FIELD_WITH_STEPS: &str = "method";

/// The field that the disk's clock changes, below which it is paused.
const FIELD_OF_CLOCK: &str = "disk.time";

/// The field below which the number of cells or pixels in the window is shown.
const FIELD_WITH_CELLS: &str = "picture.grid_height";

/// The field below which the article's qualities are offered.
const FIELD_WITH_QUALITIES: &str = "quality.max_steps";

/// A change that a row asks for: the field, and its new value or what is wrong with it.
type Change = (&'static str, Result<Value, String>);

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
    let (mut change, mut quality) = (None, None);
    for section in SECTIONS {
        let heading = egui::RichText::new(section.title).strong().size(15.0);
        egui::CollapsingHeader::new(heading)
            .id_salt(section.title)
            .default_open(section.open)
            .show_unindented(ui, |ui| {
                for text in section.rows {
                    let Some(field) = field(text.key) else {
                        continue;
                    };
                    let asked = show_row(ui, text.label, field, text.shown, &scene, &loaded);
                    change = asked.or(change.take());
                    if field.key == FIELD_WITH_STEPS {
                        ui.weak(steps.in_words()).on_hover_text(
                            "The work that method and quality mean for this picture",
                        );
                    }
                    if field.key == FIELD_WITH_QUALITIES {
                        quality = quality_buttons(ui, &scene).or(quality);
                    }
                    if field.key == FIELD_OF_CLOCK && scene.disk_moves() {
                        pause_button(ui, bindings, paused);
                    }
                    if field.key == FIELD_WITH_CELLS {
                        let drawn = editor.drawn_scene().picture;
                        ui.weak(drawn_in_words(&drawn, window, bindings));
                    }
                }
                ui.add_space(6.0);
            });
    }
    change = show_other_fields(ui, &scene, &loaded).or(change);
    if let Some(named) = quality {
        let quality = scene.quality.with_steps_of(named);
        if let Err(reason) = editor.try_change(Scene {
            quality,
            ..scene.clone()
        }) {
            editor.say(reason);
        }
    }
    if let Some((key, value)) = change {
        let changed = value.and_then(|value| {
            // An exposure that is set by hand stays as it is.
            let by_hand = (key == "picture.exposure_ev")
                .then_some(("picture.automatic_exposure", Value::Boolean(false)));
            scene
                .with([(key, value)].into_iter().chain(by_hand))
                .map_err(|refusal| refusal.to_string())
                .and_then(|changed| editor.try_change(changed))
        });
        if let Err(reason) = changed {
            editor.say(reason);
        }
    }
}

/// The buttons above the rows.
fn show_head(ui: &mut egui::Ui, editor: &mut SceneEditor, bindings: &Bindings) {
    ui.horizontal(|ui| {
        let preset = editor.loaded().name.clone();
        if ui
            .button("Back to the preset")
            .on_hover_text(format!("Every field as {preset} has it"))
            .clicked()
        {
            editor.reset();
        }
        let undo = bindings.label("scene.undo");
        if ui
            .button("Undo")
            .on_hover_text(format!("Takes the last change back, as {undo} does"))
            .clicked()
        {
            editor.undo();
        }
    });
    ui.label(
        egui::RichText::new("Point at a name to see what it means.")
            .size(12.5)
            .color(WEAK_TEXT),
    );
    ui.add_space(2.0);
}

/// Offers the steps of the article's qualities to the methods that take them. Returns the one that
/// was chosen.
fn quality_buttons(ui: &mut egui::Ui, scene: &Scene) -> Option<ArticleQuality> {
    if why_idle(scene, FIELD_WITH_QUALITIES).is_some() {
        return None;
    }
    let mut chosen = None;
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
                chosen = Some(named);
            }
        }
    });
    chosen
}

/// Pauses the disk's clock, and lets it go on.
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

/// The fields that no section has, if there are any.
fn show_other_fields(ui: &mut egui::Ui, scene: &Scene, loaded: &Scene) -> Option<Change> {
    let listed = |key| {
        let mut rows = SECTIONS.iter().flat_map(|section| section.rows);
        rows.any(|row: &RowText| row.key == key)
    };
    let others: Vec<_> = FIELDS
        .iter()
        .filter(|field| !listed(field.key) && !has_one_value(field.kind.range()))
        .collect();
    if others.is_empty() {
        return None;
    }
    let mut change = None;
    ui.collapsing("More", |ui| {
        for field in others {
            let asked = show_row(ui, field.key, field, Shown::Plain, scene, loaded);
            change = asked.or(change.take());
        }
    });
    change
}

/// Whether a range leaves no choice.
fn has_one_value(range: Range) -> bool {
    matches!(range, Range { low: Included(low), high: Included(high) } if low == high)
}

/// Shows one field. Returns its new value if it was changed.
fn show_row(
    ui: &mut egui::Ui,
    label: &str,
    field: &'static Field,
    shown: Shown,
    scene: &Scene,
    loaded: &Scene,
) -> Option<Change> {
    let (value, original) = (field.get(scene), field.get(loaded));
    let (range, _) = scene.range(field);
    let idle = why_idle(scene, field.key);
    let mut change = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        if idle.is_some() {
            ui.set_opacity(IDLE_OPACITY);
        }
        let is_changed = value != original;
        // What the clock does is no change of the preset.
        let colour = if is_changed && field.key != FIELD_OF_CLOCK {
            ACCENT
        } else {
            ui.visuals().text_color()
        };
        let left = egui::Layout::left_to_right(egui::Align::Center);
        ui.allocate_ui_with_layout(egui::vec2(LABEL_WIDTH, 22.0), left, |ui| {
            ui.set_min_width(LABEL_WIDTH);
            let text = egui::RichText::new(label).color(colour);
            ui.add(
                egui::Label::new(text)
                    .truncate()
                    .sense(egui::Sense::hover()),
            )
            .on_hover_text(help(field, idle));
        });
        let width = ui.available_width() - RESET_WIDTH;
        ui.allocate_ui_with_layout(egui::vec2(width, 22.0), left, |ui| {
            ui.set_min_width(width);
            change = show_value(ui, field, shown, &value, range).transpose();
        });
        if is_changed
            && ui
                .add(egui::Button::new("⟲").small().frame(false))
                .on_hover_text("As the preset has it")
                .clicked()
        {
            change = Some(Ok(original));
        }
    });
    change.map(|value| (field.key, value))
}

/// The help of a field: what it means, its name in a preset with what it takes, and why it changes
/// nothing at present.
fn help(field: &Field, idle: Option<&str>) -> String {
    let help = format!("{}\n\n{}: {}", field.about, field.key, field.allowed());
    match idle {
        Some(reason) => format!("{reason}\n\n{help}"),
        None => help,
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
        bindings.first_label("picture.bypass")
    )
}
