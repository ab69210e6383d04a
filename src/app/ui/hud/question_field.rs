//! The field in which a question with a number is answered.

use bevy_egui::egui::{self, Response, RichText};
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
/// what the user does, and the field, which the caller gives the keyboard again after a wrong answer.
pub(super) fn show_answer_field(
    ui: &mut egui::Ui,
    question: &Question,
    typed: &mut String,
    is_right: bool,
    size: f32,
) -> (Step, Response) {
    let begun = begun_number(ui);
    typed.push_str(&begun);
    let field = ui.add(egui::TextEdit::singleline(typed).desired_width(WIDTH));
    if !question.unit.is_empty() {
        ui.label(RichText::new(&question.unit).size(size));
    }
    let button = ui.button("Answer").clicked();
    let enter = ui.input(|input| input.key_pressed(egui::Key::Enter));
    if !begun.is_empty() {
        field.request_focus();
    }
    let step = match (enter, is_right) {
        (true, true) => Step::IsDone,
        (true, false) if !typed.trim().is_empty() => Step::Answers,
        _ if button => Step::Answers,
        _ => Step::Types,
    };
    (step, field)
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
