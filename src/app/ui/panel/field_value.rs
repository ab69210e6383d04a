//! The value of a field on the panel: a switch, a list of choices, a text, or a number with a slider
//! and a text field.

use super::number_field::number_field;
use super::switch::switch;
use crate::app::controls::empty_view::why_empty;
use crate::app::controls::sections::Shown;
use bevy_egui::egui;
use lightfall_core::scene::{Field, Kind, Method, Range, Scene, Value, View};
use lightfall_core::words::Choice;
use std::ops::Bound::{Excluded, Included, Unbounded};

/// Width of a number's text field, in points.
const NUMBER_WIDTH: f32 = 92.0;
/// Share of an open range that a slider stays away from its ends.
const OPEN_END_MARGIN: f64 = 1e-4;
/// The directions of the three components of a velocity.
const COMPONENTS: [&str; 3] = [
    "Outward, away from the hole",
    "Down, toward the plane of the disk and beyond",
    "Forward, with the disk's rotation",
];

/// Shows the value that a field of the scene has in the rest of a row. Returns its new value if it was changed.
///
/// # Errors
/// The typed text is not a number.
pub(super) fn show_value(
    ui: &mut egui::Ui,
    field: &Field,
    shown: Shown,
    scene: &Scene,
    range: Range,
) -> Result<Option<Value>, String> {
    Ok(match (field.kind, &field.get(scene)) {
        (Kind::Boolean, Value::Boolean(value)) => {
            let inverted = shown == Shown::Inverted;
            let mut on = *value != inverted;
            switch(ui, &mut on).then_some(Value::Boolean(on != inverted))
        }
        (Kind::Choice(choices), Value::Word(word)) => {
            show_choices(ui, field.key, choices, (word, scene))
        }
        (Kind::Text, Value::Text(text)) => show_text(ui, field.key, text).map(Value::Text),
        (Kind::Float(_), Value::Float(number)) => {
            show_number(ui, field, shown, *number, range)?.map(Value::Float)
        }
        (Kind::Integer(_), Value::Integer(number)) => {
            show_number(ui, field, shown, *number as f64, range)?
                .map(|number| Value::Integer(number.round() as i64))
        }
        (Kind::Velocity, Value::Velocity(components)) => {
            show_components(ui, field, *components, COMPONENTS)?.map(Value::Velocity)
        }
        (Kind::Pair, Value::Pair(numbers)) => {
            show_components(ui, field, *numbers, ["To the right", "Upward"])?.map(Value::Pair)
        }
        _ => None,
    })
}

/// The field that names a file.
const FILE: &str = "sky.picture";

/// Shows a text, and returns it whenever a letter changes. The name of a file is returned only when
/// its field is left, because half of a name is no file.
fn show_text(ui: &mut egui::Ui, key: &str, text: &str) -> Option<String> {
    let id = egui::Id::new(("text", key));
    let draft: Option<String> = ui.data(|data| data.get_temp(id));
    let mut typed = draft.clone().unwrap_or_else(|| text.to_owned());
    let edit = egui::TextEdit::singleline(&mut typed)
        .hint_text("none")
        .desired_width(ui.available_width() - 8.0);
    let response = ui.add(edit);
    if key != FILE {
        return response.changed().then_some(typed);
    }
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, typed));
        return None;
    }
    draft?;
    ui.data_mut(|data| data.remove::<String>(id));
    let given_up = ui.input(|input| input.key_pressed(egui::Key::Escape));
    (!given_up && typed != text).then_some(typed)
}

fn show_choices(
    ui: &mut egui::Ui,
    key: &str,
    choices: &[Choice],
    (word, scene): (&'static str, &Scene),
) -> Option<Value> {
    let mut chosen = word;
    let shown = choices.iter().find(|choice| choice.word == word);
    egui::ComboBox::from_id_salt(key)
        .selected_text(shown.map_or(word, |choice| choice.name))
        .width(ui.available_width())
        .show_ui(ui, |ui| {
            for choice in choices {
                // The reference cannot draw a picture.
                if (key, choice.word) == ("method", Method::Reference.word()) {
                    continue;
                }
                let is_view = |view: &View| key == "view" && view.word() == choice.word;
                let view = View::ALL.into_iter().find(is_view);
                let empty = view.and_then(|view| why_empty(view, scene));
                ui.add_enabled_ui(empty.is_none(), |ui| {
                    ui.selectable_value(&mut chosen, choice.word, choice.name)
                        .on_hover_text(format!("{} ({})", choice.meaning, choice.word))
                        .on_disabled_hover_text(empty.unwrap_or_default());
                });
            }
        });
    (chosen != word).then_some(Value::Word(chosen))
}

/// Shows the components of a value beside each other, each with what it means.
fn show_components<const N: usize>(
    ui: &mut egui::Ui,
    field: &Field,
    mut components: [f64; N],
    meanings: [&str; N],
) -> Result<Option<[f64; N]>, String> {
    let mut changed = false;
    let count = N as f32;
    let width = (ui.available_width() - (count - 1.0) * ui.spacing().item_spacing.x) / count;
    for (place, component) in components.iter_mut().enumerate() {
        let id = egui::Id::new((field.key, place));
        let shown = ui.scope(|ui| number_field(ui, id, *component, field.unit, width));
        shown.response.on_hover_text(meanings[place]);
        if let Some(typed) = shown.inner {
            *component = typed?;
            changed = true;
        }
    }
    Ok(changed.then_some(components))
}

/// Shows a number with a slider, as wide as the row allows, and a text field. Returns its new value
/// if it was changed. The text field also takes numbers that the field does not allow, so that the
/// refusal can give the reason.
fn show_number(
    ui: &mut egui::Ui,
    field: &Field,
    shown: Shown,
    value: f64,
    range: Range,
) -> Result<Option<f64>, String> {
    let turned = |angle: f64| match shown {
        Shown::AboveEquator => 90.0 - angle,
        _ => angle,
    };
    let mut number = turned(value);
    let mut slid = false;
    if let Some((low, high)) = slider_ends(shown, range) {
        let width = ui.available_width() - NUMBER_WIDTH - ui.spacing().item_spacing.x;
        ui.spacing_mut().slider_width = width.max(20.0);
        let mut slider = egui::Slider::new(&mut number, low..=high)
            .clamping(egui::SliderClamping::Never)
            .show_value(false)
            .smart_aim(true);
        if matches!(shown, Shown::Logarithmic(..)) {
            slider = slider
                .logarithmic(true)
                .smallest_positive(low.max(f64::MIN_POSITIVE));
        }
        if matches!(field.kind, Kind::Integer(_)) {
            slider = slider.integer();
        }
        slid = ui.add(slider).changed();
    }
    let id = egui::Id::new(field.key);
    let typed = number_field(ui, id, number, field.unit, NUMBER_WIDTH).transpose()?;
    Ok(typed.or(slid.then_some(number)).map(turned))
}

/// The ends of a field's slider: the useful values among those that the field allows.
fn slider_ends(shown: Shown, range: Range) -> Option<(f64, f64)> {
    let (low, high) = match shown {
        Shown::AboveEquator => return Some((-90.0, 90.0)),
        Shown::Linear(low, high) | Shown::Logarithmic(low, high) => (low, high),
        Shown::Plain | Shown::Inverted => (f64::NEG_INFINITY, f64::INFINITY),
    };
    let inside = |end, sign: f64| match end {
        Unbounded => -sign * f64::INFINITY,
        Included(end) => end,
        Excluded(end) => end + sign * OPEN_END_MARGIN * f64::abs(end).max(1.0),
    };
    let (low, high) = (
        low.max(inside(range.low, 1.0)),
        high.min(inside(range.high, -1.0)),
    );
    (low.is_finite() && high.is_finite() && low < high).then_some((low, high))
}
