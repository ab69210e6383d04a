//! What visitors of an exhibition may do: fly, and control the journeys. None of it writes a file, opens a
//! dialog or leaves the window.

use super::control::{Action, AppCommand, Edit};

/// The tables of fields whose switches visitors may use: the effects on light.
const OPEN_TABLES: [&str; 1] = ["effects."];

/// Whether a control may do this in a window for visitors.
#[must_use]
pub fn is_for_visitors(action: Action) -> bool {
    match action {
        Action::Hold(_) => true,
        Action::Do(command) => is_command_for_visitors(command),
        Action::Edit(Edit::Flip(key)) => OPEN_TABLES.iter().any(|table| key.starts_with(table)),
        // Without disk and sky the picture would be black, and another exposure or view would stay for the
        // next visitor.
        Action::Edit(Edit::SwitchOff(..) | Edit::Show(_) | Edit::Expose(_) | Edit::By(_)) => false,
        // The journeys speak of their own scenes.
        Action::Load(_) | Action::StepPreset(_) => false,
    }
}

/// Whether visitors may send this command.
pub(crate) fn is_command_for_visitors(command: AppCommand) -> bool {
    match command {
        AppCommand::Guides
        | AppCommand::StarNames
        | AppCommand::Undo
        | AppCommand::MouseLook
        | AppCommand::Face
        | AppCommand::OrbitCamera
        | AppCommand::Journey
        | AppCommand::RestartJourney
        | AppCommand::JourneyBack
        | AppCommand::JourneyAhead
        | AppCommand::GoOn
        | AppCommand::GoBack
        | AppCommand::Pause
        | AppCommand::LetGo
        | AppCommand::FasterTime
        | AppCommand::SlowerTime
        | AppCommand::TakeControls
        | AppCommand::Hover
        | AppCommand::FaceBack
        | AppCommand::Look
        | AppCommand::Map => true,
        // It frees the mouse and closes what is open, and opens no menu.
        AppCommand::Escape => true,
        // They write files.
        AppCommand::Screenshot
        | AppCommand::ScreenshotOfWindow
        | AppCommand::AddStop
        | AppCommand::SaveLesson
        | AppCommand::NewLesson
        | AppCommand::Missions => false,
        // They change settings, or open what changes them.
        AppCommand::Settings | AppCommand::Panel | AppCommand::Inspector | AppCommand::Help => {
            false
        }
        // They leave the window, or hide what the next visitor needs.
        AppCommand::Quit
        | AppCommand::Fullscreen
        | AppCommand::Hide
        | AppCommand::Compare
        | AppCommand::Difference => false,
    }
}
