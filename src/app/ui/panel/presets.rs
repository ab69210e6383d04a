//! The page of presets: those of the program, the user's own, saving, and files dropped on the
//! window.

use crate::app::input::keyboard::SceneEditor;
use crate::storage::{
    create_parent_folder, file_safe_name, preset_files, presets_folder, read_scene,
    write_atomically,
};
use bevy::prelude::*;
use bevy::window::FileDragAndDrop;
use bevy_egui::egui;
use lightfall_core::scene::{Scene, presets};
use std::path::{Path, PathBuf};

/// What the page remembers.
#[derive(Default)]
pub(super) struct State {
    /// The user's preset that is open, and the scene that was loaded when it was: another one
    /// closes it.
    own: Option<(PathBuf, Scene)>,
    /// Name for the next one.
    name: String,
    /// A file to load.
    path: String,
    /// The file that `save as` would replace, if it is asked for a second time.
    replace: Option<PathBuf>,
    /// Files of the user's folder, read when the page is opened and when something was saved.
    files: Option<Vec<PathBuf>>,
}

pub(super) fn show(ui: &mut egui::Ui, state: &mut State, editor: &mut SceneEditor) {
    if state
        .own
        .as_ref()
        .is_some_and(|(_, loaded)| loaded != editor.loaded())
    {
        state.own = None;
    }
    ui.strong("Built in");
    let name = editor.meant().name;
    for preset in presets::PRESETS {
        let scene = preset.plain_scene();
        let text = format!("{}  {}", preset.number, preset.name);
        if ui
            .selectable_label(name == preset.name, text)
            .on_hover_text(&scene.title)
            .clicked()
        {
            editor.load("", Ok(scene.clone()));
        }
    }
    ui.separator();
    ui.strong("Your own");
    let Some(folder) = presets_folder() else {
        ui.label("This system names no folder for settings, so there is none for presets.");
        return;
    };
    let files = state
        .files
        .get_or_insert_with(|| preset_files(&folder))
        .clone();
    if files.is_empty() {
        ui.weak("None yet.");
    }
    for file in files {
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        if ui
            .selectable_label(
                state.own.as_ref().is_some_and(|(own, _)| *own == file),
                name,
            )
            .clicked()
        {
            open(state, editor, &file);
        }
    }
    ui.add_space(6.0);
    if let Some((own, _)) = state.own.clone()
        && ui
            .button(format!(
                "Save {}",
                own.file_name().unwrap_or_default().to_string_lossy()
            ))
            .clicked()
    {
        save(state, editor, &own);
    }
    ui.horizontal(|ui| {
        ui.add(
            egui::TextEdit::singleline(&mut state.name)
                .hint_text("name")
                .desired_width(170.0),
        );
        let file = folder.join(format!("{}.toml", file_safe_name(state.name.trim())));
        let certain = state.replace.as_ref() == Some(&file);
        let text = if certain { "Replace it" } else { "Save as" };
        if ui
            .add_enabled(!state.name.trim().is_empty(), egui::Button::new(text))
            .clicked()
        {
            if file.exists() && !certain {
                editor.say(format!(
                    "{} is there already; press again to replace it",
                    file.display()
                ));
                state.replace = Some(file);
            } else {
                save(state, editor, &file);
            }
        }
    });
    if file_safe_name(state.name.trim()) != state.name.trim() {
        ui.weak(format!(
            "The file will be {}.toml: letters, digits, - and _ only.",
            file_safe_name(state.name.trim())
        ));
    }
    ui.separator();
    ui.strong("From a file");
    ui.horizontal(|ui| {
        ui.add(
            egui::TextEdit::singleline(&mut state.path)
                .hint_text("path of a preset or picture")
                .desired_width(220.0),
        );
        if ui.button("Load").clicked() {
            open(state, editor, &PathBuf::from(state.path.trim()));
        }
    });
    ui.weak("Or drop a preset file on the window, or a picture that Lightfall drew.");
    ui.weak("The same files serve `lightfall --preset` and `lightfall render`.");
    ui.weak(format!("Your own are in {}", folder.display()));
}

/// The scene of a preset file, if it can be read and drawn.
fn loaded(file: &Path) -> Result<Scene, String> {
    // As a path, whatever it is called: a file may have a built-in preset's name.
    let path = std::path::absolute(file).map_err(|error| format!("{}: {error}", file.display()))?;
    read_scene(&path, &[]).map_err(|error| error.to_string())
}

fn open(state: &mut State, editor: &mut SceneEditor, file: &Path) {
    if editor.load("", loaded(file)) {
        state.own = Some((file.to_owned(), editor.loaded().clone()));
    }
}

fn save(state: &mut State, editor: &mut SceneEditor, file: &Path) {
    let mut scene = editor.meant();
    scene.name = file
        .file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .chars()
        .take(60)
        .collect();
    let written = create_parent_folder(file)
        .and_then(|()| write_atomically(file, scene.to_preset().as_bytes()));
    match written {
        Ok(()) => {
            editor.change("", Ok(scene));
            editor.say(format!("Saved: {}", file.display()));
            let own = (file.to_owned(), editor.loaded().clone());
            (state.own, state.replace, state.files) = (Some(own), None, None);
        }
        Err(error) => editor.say(error.to_string()),
    }
}

/// A preset file dropped on the window is loaded, or the preset in a picture.
pub(super) fn drop_file(mut drops: MessageReader<FileDragAndDrop>, mut editor: SceneEditor) {
    for drop in drops.read() {
        if let FileDragAndDrop::DroppedFile { path_buf, .. } = drop {
            editor.load("", loaded(path_buf));
        }
    }
}
