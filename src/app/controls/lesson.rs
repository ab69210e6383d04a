//! What keys and buttons do while a lesson is under way, where this is not what they do elsewhere: those
//! of presenters' remotes among them.

use super::control::{Action, AppCommand, Control};

/// What a control's key does in a lesson.
pub(crate) fn key_in_lesson(control: &Control) -> Action {
    match control.id {
        // Enter goes on in every slide show.
        "fly.up" | "journey.again" => Action::Do(AppCommand::GoOn),
        _ => page_in_lesson(control),
    }
}

/// What a control's gamepad button does in a lesson.
pub(crate) fn button_in_lesson(control: &Control) -> Action {
    match control.id {
        "journey.fly" => Action::Do(AppCommand::GoOn),
        _ => page_in_lesson(control),
    }
}

fn page_in_lesson(control: &Control) -> Action {
    match control.id {
        "preset.next" => Action::Do(AppCommand::GoOn),
        "preset.previous" => Action::Do(AppCommand::GoBack),
        _ => control.action,
    }
}
