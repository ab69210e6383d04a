//! The clipboard: text fields copy, cut and paste, and the ray inspector copies. A thread of its own
//! serves it, because the program has to hold a copied text until another one replaces it, and a
//! text to paste comes only when its owner hands it over.

use crate::app::input::key_modifiers::give_keys_their_modifiers;
use crate::app::input::typing::Typing;
use crate::app::state::toast::Toast;
use crate::worker::Worker;
use bevy::prelude::*;
use bevy_egui::{
    EguiInput, EguiOutput, EguiPostUpdateSet, EguiPreUpdateSet, PrimaryEguiContext, egui,
};

enum Order {
    Copy(String),
    Paste,
}

/// The thread that holds the clipboard. It answers with texts to paste, or with what could not be
/// done.
#[derive(Resource)]
pub(crate) struct Clipboard(Worker<Order, Result<String, String>>);

impl Clipboard {
    fn start() -> Self {
        let mut clipboard = None;
        Self(Worker::serving_all(move |order, answers| {
            match serve(order, &mut clipboard) {
                Ok(Some(text)) => answers.send(Ok(text)),
                Ok(None) => {}
                Err(arboard::Error::ContentNotAvailable) => {
                    answers.send(Err("There is no text on the clipboard".into()));
                }
                Err(error) => {
                    answers.send(Err(format!("The clipboard cannot be reached: {error}")));
                }
            }
        }))
    }

    /// Puts a text on the clipboard.
    pub(crate) fn copy(&self, text: String) {
        self.0.ask(Order::Copy(text));
    }
}

/// Serves one order. Returns the text to paste, if that was asked for.
fn serve(
    order: Order,
    clipboard: &mut Option<arboard::Clipboard>,
) -> Result<Option<String>, arboard::Error> {
    let clipboard = match clipboard {
        Some(clipboard) => clipboard,
        none => none.insert(arboard::Clipboard::new()?),
    };
    match order {
        Order::Copy(text) => clipboard.set_text(text).map(|()| None),
        Order::Paste => clipboard.get_text().map(Some),
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.insert_resource(Clipboard::start())
        .add_systems(
            PreUpdate,
            serve_text_fields
                .after(EguiPreUpdateSet::ProcessInput)
                .after(give_keys_their_modifiers)
                .before(EguiPreUpdateSet::BeginPass),
        )
        .add_systems(
            PostUpdate,
            copy_from_text_fields.after(EguiPostUpdateSet::ProcessOutput),
        );
}

/// What a key means to a text field.
enum Edit {
    Copy,
    Cut,
    Paste,
}

fn edit_of(event: &egui::Event) -> Option<Edit> {
    let egui::Event::Key {
        key,
        pressed: true,
        modifiers,
        ..
    } = event
    else {
        return None;
    };
    let command = modifiers.command && !modifiers.alt;
    match key {
        egui::Key::Copy => Some(Edit::Copy),
        egui::Key::Cut => Some(Edit::Cut),
        egui::Key::Paste => Some(Edit::Paste),
        egui::Key::C | egui::Key::Insert if command => Some(Edit::Copy),
        egui::Key::X if command => Some(Edit::Cut),
        egui::Key::V if command => Some(Edit::Paste),
        egui::Key::Insert if modifiers.shift => Some(Edit::Paste),
        _ => None,
    }
}

/// Tells egui of copying, cutting and pasting while a text field has the keyboard.
fn serve_text_fields(
    mut inputs: Query<&mut EguiInput, With<PrimaryEguiContext>>,
    typing: Res<Typing>,
    clipboard: Res<Clipboard>,
    mut toast: ResMut<Toast>,
) {
    let pasted = match clipboard.0.next_answer() {
        Some(Ok(text)) => Some(text),
        Some(Err(fault)) => {
            toast.say(fault);
            None
        }
        None => None,
    };
    // A text that comes after its field was left is dropped.
    if !typing.0 {
        return;
    }
    for mut input in &mut inputs {
        for edit in input.events.iter().filter_map(edit_of).collect::<Vec<_>>() {
            match edit {
                Edit::Copy => input.events.push(egui::Event::Copy),
                Edit::Cut => input.events.push(egui::Event::Cut),
                Edit::Paste => clipboard.0.ask(Order::Paste),
            }
        }
        input.events.extend(pasted.clone().map(egui::Event::Paste));
    }
}

/// Puts what text fields have copied or cut on the clipboard.
fn copy_from_text_fields(
    outputs: Query<&EguiOutput, With<PrimaryEguiContext>>,
    clipboard: Res<Clipboard>,
) {
    for command in outputs
        .iter()
        .flat_map(|output| &output.platform_output.commands)
    {
        if let egui::OutputCommand::CopyText(text) = command {
            clipboard.copy(text.clone());
        }
    }
}
