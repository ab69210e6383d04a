//! The page of presets: the built-in ones, the user's own, saving, and loading from a file. A preset
//! file or picture that is dropped on the window is loaded too.

use crate::app::state::scene_editor::SceneEditor;
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
pub(super) struct PresetsPage {
    /// The user's preset that is open, and the loaded scene that it gave. Once another scene is
    /// loaded, the preset is no longer open.
    own: Option<(PathBuf, Scene)>,
    /// The name to save under.
    name: String,
    /// The file to load.
    path: String,
    /// The file that the next press of `Replace it` replaces.
    replace: Option<PathBuf>,
    /// The files of the user's folder. None until they are read again.
    files: Option<Vec<PathBuf>>,
}

impl PresetsPage {
    pub(super) fn show(&mut self, ui: &mut egui::Ui, editor: &mut SceneEditor) {
        if self
            .own
            .as_ref()
            .is_some_and(|(_, loaded)| loaded != editor.loaded())
        {
            self.own = None;
        }
        show_built_in(ui, editor);
        ui.separator();
        ui.strong("Your own");
        let Some(folder) = presets_folder() else {
            ui.label("This system has no folder for settings, and so none for presets.");
            return;
        };
        self.show_own(ui, editor, &folder);
        ui.add_space(6.0);
        self.show_saving(ui, editor, &folder);
        ui.separator();
        ui.strong("From a file");
        ui.horizontal(|ui| {
            ui.add(
                egui::TextEdit::singleline(&mut self.path)
                    .hint_text("path of a preset or picture")
                    .desired_width(220.0),
            );
            let given = !self.path.trim().is_empty();
            if ui.add_enabled(given, egui::Button::new("Load")).clicked() {
                self.open(editor, &PathBuf::from(self.path.trim()));
            }
        });
        ui.weak("Or drop a preset file, or a picture that Lightfall drew, on the window.");
        ui.weak("`lightfall --preset` and `lightfall render` accept the same files.");
        ui.weak(format!("Your own presets are in {}", folder.display()));
    }

    fn show_own(&mut self, ui: &mut egui::Ui, editor: &mut SceneEditor, folder: &Path) {
        let files = self
            .files
            .get_or_insert_with(|| preset_files(folder))
            .clone();
        if files.is_empty() {
            ui.weak("None yet.");
        }
        for file in files {
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            let is_open = self.own.as_ref().is_some_and(|(own, _)| *own == file);
            if ui.selectable_label(is_open, name).clicked() {
                self.open(editor, &file);
            }
        }
    }

    fn show_saving(&mut self, ui: &mut egui::Ui, editor: &mut SceneEditor, folder: &Path) {
        if let Some((own, _)) = self.own.clone() {
            let name = own.file_name().unwrap_or_default().to_string_lossy();
            if ui.button(format!("Save {name}")).clicked() {
                self.save(editor, &own);
            }
        }
        let safe_name = file_safe_name(self.name.trim());
        ui.horizontal(|ui| {
            ui.add(
                egui::TextEdit::singleline(&mut self.name)
                    .hint_text("name")
                    .desired_width(170.0),
            );
            let file = folder.join(format!("{safe_name}.toml"));
            let confirmed = self.replace.as_ref() == Some(&file);
            let text = if confirmed { "Replace it" } else { "Save as" };
            let button = egui::Button::new(text);
            if !ui.add_enabled(!safe_name.is_empty(), button).clicked() {
                return;
            }
            if file.exists() && !confirmed {
                editor.say(format!(
                    "{} exists already; press again to replace it",
                    file.display()
                ));
                self.replace = Some(file);
            } else {
                self.save(editor, &file);
            }
        });
        if safe_name != self.name.trim() {
            ui.weak(format!(
                "The file will be {safe_name}.toml: names have letters, digits, - and _ only."
            ));
        }
    }

    fn open(&mut self, editor: &mut SceneEditor, file: &Path) {
        if editor.load("", read_preset(file)) {
            self.own = Some((file.to_owned(), editor.loaded().clone()));
        }
    }

    fn save(&mut self, editor: &mut SceneEditor, file: &Path) {
        let mut scene = editor.scene();
        // As long as a file-safe name may be.
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
                editor.change("", scene);
                editor.say(format!("Saved: {}", file.display()));
                self.own = Some((file.to_owned(), editor.loaded().clone()));
                (self.replace, self.files) = (None, None);
            }
            Err(error) => editor.say(error.to_string()),
        }
    }
}

fn show_built_in(ui: &mut egui::Ui, editor: &mut SceneEditor) {
    ui.strong("Built in");
    let name = editor.drawn_scene().name.clone();
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
}

/// The scene of a preset file or of a picture.
///
/// # Errors
/// The file cannot be read or is wrong; one sentence.
fn read_preset(file: &Path) -> Result<Scene, String> {
    read_scene(file, &[]).map_err(|error| error.to_string())
}

pub(super) fn load_dropped_files(
    mut drops: MessageReader<FileDragAndDrop>,
    mut editor: SceneEditor,
) {
    for drop in drops.read() {
        if let FileDragAndDrop::DroppedFile { path_buf, .. } = drop {
            editor.load("", read_preset(path_buf));
        }
    }
}
