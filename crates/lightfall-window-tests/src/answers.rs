//! What the window says within two frames after a key.

use crate::shown;
use bevy::diagnostic::FrameCount;
use bevy::prelude::*;
use bevy_egui::{EguiFullOutput, EguiPostUpdateSet};
use std::collections::BTreeSet;
use watched::Answer;

/// Frames after a key within which its message is shown.
const PROMPT: u32 = 2;
/// Frames before a key whose texts are not new.
const BEFORE: usize = 3;

/// The keys pressed so far, the frame of the last one, and what was shown after it.
#[derive(Resource, Default)]
pub struct Answers {
    /// The number of keys.
    pub keys: u32,
    /// What was shown after the last key that has an answer.
    pub last: Answer,
    pressed: Option<u32>,
    shown: BTreeSet<String>,
    /// Texts of the last frames, the latest last.
    recent: Vec<BTreeSet<String>>,
}

pub fn plugin(app: &mut App) {
    app.init_resource::<Answers>().add_systems(
        PostUpdate,
        read_answer
            .after(EguiPostUpdateSet::EndPass)
            .before(EguiPostUpdateSet::ProcessOutput),
    );
}

/// Collects the texts of the frames after a key, and those that are new among them.
pub fn read_answer(
    outputs: Query<&EguiFullOutput>,
    keys: Res<ButtonInput<KeyCode>>,
    frame: Res<FrameCount>,
    mut answers: ResMut<Answers>,
) {
    let answers = &mut *answers;
    let pressed = keys.get_just_pressed().count() as u32;
    if pressed > 0 {
        answers.keys += pressed;
        answers.pressed = Some(frame.0);
        answers.shown.clear();
    }
    let texts: BTreeSet<String> = shown::texts(outputs)
        .into_iter()
        .map(|text| text.words)
        .collect();
    if let Some(pressed) = answers.pressed {
        answers.shown.extend(texts.iter().cloned());
        let later = frame.0 - pressed;
        if later == PROMPT {
            let before = answers.recent.len().saturating_sub(later as usize);
            let known: BTreeSet<&String> = answers.recent[..before].iter().flatten().collect();
            let new = answers.shown.iter().filter(|text| !known.contains(text));
            answers.last = Answer {
                key: answers.keys,
                new: new.cloned().collect(),
                shown: answers.shown.clone(),
            };
            answers.pressed = None;
        }
    }
    answers.recent.push(texts);
    let spare = answers
        .recent
        .len()
        .saturating_sub(BEFORE + PROMPT as usize);
    answers.recent.drain(..spare);
}
