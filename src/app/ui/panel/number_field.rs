//! A text field for a number. At rest it shows the number rounded and with its unit, and while it is
//! edited with every digit.

use crate::app::ui::number::{eight_digits, four_decimals, trimmed};
use bevy_egui::egui;

/// Shows a number in a framed field. Returns what was typed when the user leaves the field or
/// presses Enter, or what is wrong with the text, and nothing if the text is as it was or Esc was
/// pressed.
pub(super) fn number_field(
    ui: &mut egui::Ui,
    id: egui::Id,
    value: f64,
    unit: &str,
    width: f32,
) -> Option<Result<f64, String>> {
    let draft: Option<String> = ui.data(|data| data.get_temp(id));
    let mut text = draft
        .clone()
        .unwrap_or_else(|| format!("{}{}", four_decimals(value), suffix(unit)));
    let edit = egui::TextEdit::singleline(&mut text)
        .id(id)
        .horizontal_align(egui::Align::RIGHT)
        .vertical_align(egui::Align::Center)
        .desired_width(width - 8.0)
        .clip_text(true);
    let response = ui.add_sized([width, 22.0], edit);
    if response.gained_focus() {
        text = all_digits(value);
        select_all(ui, id, text.chars().count());
    }
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, text));
        return None;
    }
    let draft = draft?;
    ui.data_mut(|data| data.remove::<String>(id));
    let given_up = ui.input(|input| input.key_pressed(egui::Key::Escape));
    // The frame in which the field is left has the last letter.
    let typed = if response.changed() { text } else { draft };
    (!given_up && typed != all_digits(value)).then(|| parsed(&typed, unit))
}

fn select_all(ui: &egui::Ui, id: egui::Id, length: usize) {
    use egui::text::{CCursor, CCursorRange};
    let mut state = egui::TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    state.cursor.set_char_range(Some(CCursorRange::two(
        CCursor::new(0),
        CCursor::new(length),
    )));
    state.store(ui.ctx(), id);
}

/// Largest number of digits of a typed number. A number with more digits was computed.
const TYPED_DIGITS: usize = 12;

/// A typed number with all its digits, or a computed number with eight digits. A difference in the
/// last of sixteen digits is rounding, and is left out.
fn all_digits(value: f64) -> String {
    let mantissa = format!("{value:e}");
    let digits = mantissa.split('e').next().unwrap_or_default();
    let count = digits.chars().filter(char::is_ascii_digit).count();
    let rounded = format!("{value:.11e}").parse().unwrap_or(value);
    if count > TYPED_DIGITS && (rounded - value).abs() > 4.0 * f64::EPSILON * value.abs() {
        return format!("{}", eight_digits(value));
    }
    let short = trimmed(format!("{value:.12}"));
    match short.parse::<f64>() {
        Ok(number) if (number - value).abs() <= 4.0 * f64::EPSILON * value.abs() => short,
        _ => format!("{value}"),
    }
}

/// The number in a text, with or without its unit, with a point or a comma.
fn parsed(text: &str, unit: &str) -> Result<f64, String> {
    let text = text.trim();
    let suffix = suffix(unit);
    let number = text.strip_suffix(suffix.trim()).unwrap_or(text);
    match number.trim().replace(',', ".").parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("\"{text}\" is not a number.")),
    }
}

/// A unit as it follows a number on the panel.
fn suffix(unit: &str) -> String {
    match unit {
        "" => String::new(),
        "degrees" => "°".into(),
        "pixels" => " px".into(),
        "powers of two" => " EV".into(),
        "levels" => " tones".into(),
        other => format!(" {other}"),
    }
}
