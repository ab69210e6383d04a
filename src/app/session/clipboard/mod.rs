//! The clipboard: text fields copy, cut and paste, and the ray inspector copies.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;

#[cfg(target_arch = "wasm32")]
pub(crate) use browser::Clipboard;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use desktop::Clipboard;

use crate::app::input::clicks::hold_keys_after_click;
use crate::app::input::typing::Typing;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy_egui::{
    EguiInput, EguiOutput, EguiPostUpdateSet, EguiPreUpdateSet, PrimaryEguiContext, egui,
};

pub(crate) fn plugin(app: &mut App) {
    app.insert_resource(Clipboard::start())
        .add_systems(
            PreUpdate,
            serve_text_fields
                .after(hold_keys_after_click)
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
    let answer = clipboard.next_text();
    let pasted = answer.and_then(|text| text.map_err(|fault| toast.say(fault)).ok());
    // A text that comes after its field was left is dropped.
    if !typing.is_on() {
        return;
    }
    for mut input in &mut inputs {
        for edit in input.events.iter().filter_map(edit_of).collect::<Vec<_>>() {
            match edit {
                Edit::Copy => input.events.push(egui::Event::Copy),
                Edit::Cut => input.events.push(egui::Event::Cut),
                Edit::Paste => clipboard.paste(),
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
