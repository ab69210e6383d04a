//! The page of the scene: one row for every field of the field table, so that a new field shows by
//! itself.

use super::steps::Steps;
use crate::app::input::keyboard::SceneEditor;
use crate::render::{Letterbox, letterbox};
use bevy::math::UVec2;
use bevy_egui::egui;
use lightfall_core::scene::{FIELDS, Field, Kind, Picture, Range, Value};
use std::ops::Bound::{Excluded, Included, Unbounded};

/// Ranges that span more than this are typed or dragged; narrower ones have a slider.
const MAX_SLIDER_RANGE: f64 = 1000.0;
/// Share of an open range that a slider keeps from its ends.
const OPEN_END: f64 = 1e-4;
/// Width of a row's value, in points.
const VALUE_WIDTH: f32 = 190.0;
/// Width of its name, at least.
const NAME_WIDTH: f32 = 90.0;
/// Width kept for the button that resets it.
const RESET_WIDTH: f32 = 36.0;

/// The fields under which it says how many steps that comes to.
const STEPPED: [&str; 2] = ["method", "quality.max_error_px"];

/// What the page remembers.
#[derive(Default)]
pub(super) struct State {
    /// The field whose last change was refused, and why.
    refused: Option<(&'static str, String)>,
}

/// The field under which it says how the cells lie in the window.
const SHOWN: &str = "picture.grid_height";

pub(super) fn show(
    ui: &mut egui::Ui,
    state: &mut State,
    editor: &mut SceneEditor,
    steps: &Steps,
    window: UVec2,
) {
    ui.horizontal(|ui| {
        if ui
            .button("Reset all")
            .on_hover_text("Everything as it was loaded")
            .clicked()
        {
            let loaded = editor.loaded().clone();
            editor.change("Reset", Ok(loaded));
            state.refused = None;
        }
        if ui.button("Undo").clicked() {
            editor.undo();
            state.refused = None;
        }
        ui.weak("Point at a name to see what it means.");
    });
    ui.spacing_mut().slider_width = 100.0;
    let scene = editor.meant();
    let values: Vec<(&Field, Value)> = scene.values().collect();
    let loaded: Vec<Value> = editor.loaded().values().map(|(_, value)| value).collect();
    let mut change = None;
    for (heading, first, last) in tables() {
        egui::CollapsingHeader::new(heading).default_open(first < OPEN).show(ui, |ui| {
            for (i, (field, value)) in values.iter().enumerate().take(last).skip(first) {
                let (range, _) = scene.range(field);
                if matches!(range, Range { low: Included(low), high: Included(high) } if low == high) {
                    continue;
                }
                let fresh = row(ui, field, value, range, &loaded[i]);
                change = fresh.map(|fresh| (field.key, fresh)).or(change.take());
                if let Some((_, reason)) = state.refused.as_ref().filter(|(key, _)| *key == field.key) {
                    ui.colored_label(ui.visuals().error_fg_color, reason);
                }
                if STEPPED.contains(&field.key) {
                    ui.weak(steps.in_words()).on_hover_text("What method and error setting come to in this picture");
                }
                if field.key == SHOWN
                    && let Some(cells) = cells_in_words(&scene.picture, window)
                {
                    ui.weak(cells);
                }
            }
        });
    }
    if let Some((key, value)) = change {
        let changed = scene
            .with([(key, value)])
            .map_err(|refusal| refusal.to_string());
        state.refused = editor.try_change(changed).err().map(|reason| (key, reason));
    }
}

/// How large the cells are in a window of this many pixels, and what bars that leaves; none where
/// they are bypassed.
fn cells_in_words(picture: &Picture, window: UVec2) -> Option<String> {
    let Letterbox { extent, .. } = letterbox(picture, window);
    let (shown, bars) = (
        extent.as_uvec2(),
        window.saturating_sub(extent.as_uvec2()) / 2,
    );
    let whole = shown.x / picture.grid_width.max(1);
    (!picture.bypass && whole > 0).then(|| {
        let bars = match (bars.x, bars.y) {
            (0, 0) => "which fills the window".to_owned(),
            (x, y) => format!("bars of {x} and {y} px, for cells are whole; F7 fills the window"),
        };
        format!("{} x {} px: {whole} px a cell, {bars}", shown.x, shown.y)
    })
}

/// Fields before this one are open at first.
const OPEN: usize = 12;

/// The field table in parts with a heading each: the first and one past the last of its fields.
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

/// One field; its new value if it is changed.
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
    let width = width.max(NAME_WIDTH);
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
            change = widget(ui, field, value, range);
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

fn widget(ui: &mut egui::Ui, field: &Field, value: &Value, range: Range) -> Option<Value> {
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

/// A number in a range: a slider where the range is short enough for one. What is typed may lie
/// outside, and is refused in words.
fn drag(ui: &mut egui::Ui, value: &mut f64, range: Range, unit: &str, whole: bool) -> bool {
    let suffix = short(unit);
    if let Some((low, high)) = ends(range)
        && high - low <= MAX_SLIDER_RANGE
    {
        let mut slider = egui::Slider::new(value, low..=high)
            .clamping(egui::SliderClamping::Never)
            .suffix(suffix)
            .smart_aim(true)
            .custom_formatter(|number, _| shown_number(number));
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
        .custom_formatter(|number, _| shown_number(number))
}

/// A unit as it follows a number on the panel.
fn short(unit: &str) -> &str {
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

/// The ends of a range as a slider goes, if it has two.
fn ends(range: Range) -> Option<(f64, f64)> {
    let (low, high) = match (range.low, range.high) {
        (Unbounded, _) | (_, Unbounded) => return None,
        (Included(low) | Excluded(low), Included(high) | Excluded(high)) => (low, high),
    };
    let margin = OPEN_END * (high - low);
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

/// A number in four decimals at most, or, where that would hide it, in all of its digits.
#[must_use]
pub fn shown_number(number: f64) -> String {
    let size = number.abs();
    if (0.01..1e9).contains(&size) {
        let rounded = format!("{number:.4}");
        return rounded
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned();
    }
    if number == 0.0 {
        "0".into()
    } else if !(1e-3..1e9).contains(&size) {
        format!("{number:e}")
    } else {
        format!("{number}")
    }
}
