//! The value of a field on the panel: a check box, a list of words, a text, a slider or a number to
//! drag.

use crate::app::ui::number::four_decimals;
use bevy_egui::egui;
use lightfall_core::scene::{Field, Kind, Range, Value};
use std::ops::Bound::{Excluded, Included, Unbounded};

/// Fields with a wider range than this are typed or dragged. Others have a slider.
const MAX_SLIDER_RANGE: f64 = 1000.0;
/// Share of an open range that a slider stays away from its ends.
const OPEN_END_MARGIN: f64 = 1e-4;
/// Width of a row's value, in points.
pub(super) const VALUE_WIDTH: f32 = 190.0;

/// Shows a field's value. Returns its new value if it was changed.
pub(super) fn show_value(
    ui: &mut egui::Ui,
    field: &Field,
    value: &Value,
    range: Range,
) -> Option<Value> {
    match (field.kind, value) {
        (Kind::Boolean, Value::Boolean(on)) => {
            let mut on = *on;
            let text = if on { "on" } else { "off" };
            ui.checkbox(&mut on, text)
                .changed()
                .then_some(Value::Boolean(on))
        }
        (Kind::Choice(choices), Value::Word(word)) => {
            let mut chosen = *word;
            egui::ComboBox::from_id_salt(field.key)
                .selected_text(*word)
                .width(150.0)
                .show_ui(ui, |ui| {
                    for choice in choices {
                        ui.selectable_value(&mut chosen, choice, *choice);
                    }
                });
            (chosen != *word).then_some(Value::Word(chosen))
        }
        (Kind::Text, Value::Text(text)) => {
            let mut text = text.clone();
            let edit = egui::TextEdit::singleline(&mut text).desired_width(VALUE_WIDTH - 10.0);
            ui.add(edit).changed().then_some(Value::Text(text))
        }
        (Kind::Float(_), Value::Float(number)) => {
            let mut number = *number;
            drag(ui, &mut number, range, field.unit, false).then_some(Value::Float(number))
        }
        (Kind::Integer(_), Value::Integer(number)) => {
            let mut float = *number as f64;
            drag(ui, &mut float, range, field.unit, true)
                .then_some(Value::Integer(float.round() as i64))
        }
        (Kind::Velocity, Value::Velocity(components)) => {
            let mut components = *components;
            let mut changed = false;
            for component in &mut components {
                changed |= ui.add(number(component, 0.005, "")).changed();
            }
            changed.then_some(Value::Velocity(components))
        }
        _ => None,
    }
}

/// Shows a number, with a slider where its range is narrow enough. Returns whether it was changed.
/// A number outside the range can be typed, and is then refused with a reason.
fn drag(ui: &mut egui::Ui, value: &mut f64, range: Range, unit: &str, whole: bool) -> bool {
    let suffix = unit_suffix(unit);
    if let Some((low, high)) = slider_ends(range)
        && high - low <= MAX_SLIDER_RANGE
    {
        let mut slider = egui::Slider::new(value, low..=high)
            .clamping(egui::SliderClamping::Never)
            .suffix(suffix)
            .smart_aim(true)
            .custom_formatter(|number, _| four_decimals(number));
        if whole {
            slider = slider.integer();
        }
        return ui.add(slider).changed();
    }
    let speed = if whole {
        1.0_f64.max(value.abs() * 0.002)
    } else {
        1e-3_f64.max(value.abs() * 0.005)
    };
    ui.add(number(value, speed, suffix)).changed()
}

fn number<'a>(value: &'a mut f64, speed: f64, suffix: &'a str) -> egui::DragValue<'a> {
    egui::DragValue::new(value)
        .speed(speed)
        .suffix(suffix)
        .custom_formatter(|number, _| four_decimals(number))
}

/// A unit as it follows a number on the panel.
fn unit_suffix(unit: &str) -> &str {
    match unit {
        "" => "",
        "degrees" => "°",
        "r_s" => " r_s",
        "K" => " K",
        "pixels" => " px",
        "cells" => " cells",
        "powers of two" => " EV",
        "steps" => " steps",
        "levels" => " levels",
        other => other,
    }
}

/// The ends of a slider for a range, if the range has two ends.
fn slider_ends(range: Range) -> Option<(f64, f64)> {
    let (low, high) = match (range.low, range.high) {
        (Unbounded, _) | (_, Unbounded) => return None,
        (Included(low) | Excluded(low), Included(high) | Excluded(high)) => (low, high),
    };
    let margin = OPEN_END_MARGIN * (high - low);
    let low = if matches!(range.low, Excluded(_)) {
        low + margin
    } else {
        low
    };
    let high = if matches!(range.high, Excluded(_)) {
        high - margin
    } else {
        high
    };
    Some((low, high))
}
