//! The field in which a question with a number is answered.

use crate::app::state::typed_answer::TypedAnswer;
use bevy_egui::egui::text::{CCursor, CCursorRange};
use bevy_egui::egui::{self, RichText};
use lightfall_core::scene::Question;

/// Width of the field, in points.
const WIDTH: f32 = 110.0;

/// What the user does at the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// Nothing, or typing.
    Types,
    /// Gives what is typed as the answer.
    Answers,
    /// Presses Enter once more after the right answer.
    IsDone,
}

/// Shows the field, the answer's unit and a button. Typing a number needs no click on the field. Returns
/// what the user does.
pub(super) fn show_answer_field(
    ui: &mut egui::Ui,
    question: &Question,
    answer: &mut TypedAnswer,
    size: f32,
) -> Step {
    let begun = begun_number(ui);
    let TypedAnswer {
        typed, is_right, ..
    } = answer;
    typed.push_str(&begun);
    let field = ui.add(egui::TextEdit::singleline(typed).desired_width(WIDTH));
    if !question.unit.is_empty() {
        ui.label(RichText::new(&question.unit).size(size));
    }
    let button = ui.button("Answer").clicked();
    let enter = ui.input(|input| input.key_pressed(egui::Key::Enter));
    if !begun.is_empty() {
        field.request_focus();
        // Otherwise the next digit would stand before the first one.
        let end = CCursor::new(typed.chars().count());
        let mut state = egui::TextEdit::load_state(ui.ctx(), field.id).unwrap_or_default();
        state.cursor.set_char_range(Some(CCursorRange::one(end)));
        state.store(ui.ctx(), field.id);
    }
    match (enter, *is_right) {
        (true, true) => Step::IsDone,
        (true, false) if !typed.trim().is_empty() => Step::Answers,
        _ if button => Step::Answers,
        _ => Step::Types,
    }
}

/// The part of a number that is typed in this frame while no field has the keyboard.
fn begun_number(ui: &egui::Ui) -> String {
    if ui.ctx().text_edit_focused() {
        return String::new();
    }
    let events = ui.input(|input| input.events.clone());
    let texts = events.into_iter().filter_map(|event| match event {
        egui::Event::Text(text) => Some(text),
        _ => None,
    });
    let is_part = |c: &char| c.is_ascii_digit() || ".,-".contains(*c);
    texts
        .flat_map(|text| text.chars().filter(is_part).collect::<Vec<_>>())
        .collect()
}
