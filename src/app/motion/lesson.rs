//! Making a lesson: a key adds what is shown as its next stop, and another one saves it.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::AppCommand;
use crate::app::state::lesson_draft::LessonDraft;
use crate::app::state::lessons::ShownRay;
use crate::app::state::overlays::Overlays;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;
use lightfall_core::scene::journey::{InspectorView, Shown, SideBySide};
use lightfall_platform::IN_BROWSER;
use lightfall_render::{Comparison, ComparisonMode};

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, make_lesson);
}

fn make_lesson(
    mut commands: MessageReader<AppCommand>,
    mut draft: ResMut<LessonDraft>,
    (overlays, comparison, ray): (Res<Overlays>, Res<Comparison>, Res<ShownRay>),
    bindings: Res<Bindings>,
    mut editor: SceneEditor,
) {
    for command in commands.read() {
        let said = match command {
            AppCommand::AddStop => {
                let inspector = match ray.0 {
                    _ if !overlays.inspector => InspectorView::Closed,
                    Some(direction) => InspectorView::Toward(direction),
                    None => InspectorView::Open,
                };
                let shown = Shown {
                    scene: editor.scene(),
                    caption: String::new(),
                    guides: overlays.guides,
                    side_by_side: match comparison.0.as_ref().map(|(_, mode)| *mode) {
                        None => SideBySide::Off,
                        Some(ComparisonMode::TwoPictures) => SideBySide::TwoPictures,
                        Some(_) => SideBySide::Divided,
                    },
                    inspector,
                };
                add_stop(&mut draft, shown, &bindings)
            }
            AppCommand::SaveLesson => save(&mut draft),
            AppCommand::NewLesson => {
                draft.begin_anew();
                format!(
                    "A new lesson: {} adds its first stop",
                    bindings.label("lesson.add_stop")
                )
            }
            _ => continue,
        };
        editor.say(said);
    }
}

fn add_stop(draft: &mut LessonDraft, shown: Shown, bindings: &Bindings) -> String {
    if let Err(fault) = draft.add(shown) {
        return format!("No stop is added: {fault}");
    }
    let number = draft.stops();
    let save = bindings.label("lesson.save");
    match draft.file() {
        Ok(file) if !IN_BROWSER => {
            format!(
                "Stop {number} of your lesson is noted: {save} saves {}",
                file.display()
            )
        }
        Ok(_) => format!("Stop {number} of your lesson is noted: {save} saves it"),
        Err(fault) => fault,
    }
}

fn save(draft: &mut LessonDraft) -> String {
    match draft.save() {
        Ok(file) if IN_BROWSER => format!("Saved: {} in this browser", file.display()),
        Ok(file) => format!("Saved: {}. Write its captions in this file", file.display()),
        Err(fault) => fault,
    }
}
