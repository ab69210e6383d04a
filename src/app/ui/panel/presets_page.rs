//! The page of presets: the built-in ones, the user's own, saving, and opening a file. A file dropped on
//! the window is opened, too.

use super::file_dialog::{FileDialog, Picked};
use crate::app::session::clipboard::Clipboard;
use crate::app::session::link::copy_link;
use crate::app::state::file_opener::FileOpener;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::ui::theme::{ACCENT, WEAK_TEXT};
use bevy::prelude::*;
use bevy::window::FileDragAndDrop;
use bevy_egui::egui;
use lightfall_core::scene::presets;
use lightfall_platform::IN_BROWSER;
use lightfall_platform::storage::{
    Opened, create_parent_folder, exists, file_safe_name, preset_files, presets_folder, read_scene,
    with_whole_sky_path, write_atomically,
};
use std::borrow::Cow;
use std::path::{Path, PathBuf};

/// Largest number of letters of a preset's name.
const MAX_NAME_LETTERS: usize = 60;

/// What the page remembers.
#[derive(Default)]
pub(super) struct PresetsPage {
    /// The name to save under.
    name: String,
    /// The file to load.
    path: String,
    /// The existing file that the user is asked whether to replace.
    replace: Option<PathBuf>,
    /// What was saved or read last, or what went wrong.
    report: String,
    /// The files of the user's folder, with the titles of their scenes. None until they are read again.
    files: Option<Vec<(PathBuf, String)>>,
    dialog: FileDialog,
}

impl PresetsPage {
    pub(super) fn show(
        &mut self,
        ui: &mut egui::Ui,
        opener: &mut FileOpener,
        clipboard: &Clipboard,
    ) {
        heading(ui, "Built in");
        show_built_in(ui, &mut opener.editor);
        ui.add_space(10.0);
        heading(ui, "Open a file");
        self.show_opening(ui, opener);
        ui.add_space(10.0);
        heading(ui, "Share");
        show_sharing(ui, &mut opener.editor, clipboard);
        ui.add_space(10.0);
        heading(ui, "Your own");
        let Some(folder) = presets_folder() else {
            ui.label("This system has no folder for settings, so presets cannot be kept.");
            return;
        };
        self.show_saving(ui, &mut opener.editor, &folder);
        ui.add_space(6.0);
        self.show_own(ui, opener, &folder);
        ui.add_space(6.0);
        if IN_BROWSER {
            note(ui, "They are kept in this browser, for this page.");
        } else {
            note(ui, &format!("They are files in {}", folder.display()));
        }
    }

    /// The fields that open a preset, a mission, a lesson or a picture.
    fn show_opening(&mut self, ui: &mut egui::Ui, opener: &mut FileOpener) {
        ui.horizontal(|ui| {
            // A page in a browser has no paths.
            if !IN_BROWSER {
                let path = egui::TextEdit::singleline(&mut self.path)
                    .hint_text("Path of a preset, mission, lesson or picture")
                    .desired_width(ui.available_width() - 150.0);
                let field = ui.add(path);
                let entered =
                    field.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
                let given = !self.path.trim().is_empty();
                let open = ui.add_enabled(given, egui::Button::new("Open"));
                if open.clicked() || entered && given {
                    self.open(opener, &PathBuf::from(self.path.trim()));
                }
            }
            let browse = egui::Button::new("Browse");
            if ui.add_enabled(!self.dialog.is_open(), browse).clicked() {
                self.dialog.open();
            }
        });
        match self.dialog.answer() {
            Some(Picked::File(file, opened)) => {
                self.path = file.display().to_string();
                self.show_opened(opener, &file, *opened);
            }
            Some(Picked::NoDialog) => {
                opener.editor.say("This desktop offers no file dialog. Type the path, or drop the file on the window");
            }
            Some(Picked::Nothing) | None => {}
        }
        let hint = if IN_BROWSER {
            "A preset, a mission, a lesson, or a picture that Lightfall saved."
        } else {
            "Or drop a preset, a mission, a lesson, or a picture that Lightfall saved, on the window."
        };
        note(ui, hint);
    }

    /// The list of the user's presets.
    fn show_own(&mut self, ui: &mut egui::Ui, opener: &mut FileOpener, folder: &Path) {
        let files = self
            .files
            .get_or_insert_with(|| {
                let files = preset_files(folder).into_iter();
                files
                    .map(|file| {
                        let title = title_in(&file);
                        (file, title)
                    })
                    .collect()
            })
            .clone();
        if files.is_empty() {
            note(ui, "None yet.");
        }
        for (file, title) in files {
            let is_open = opener.editor.loaded_file() == Some(&*file);
            let name = stem(&file);
            let text = match title.as_str() {
                "" => name.as_ref(),
                title => title,
            };
            if entry(ui, is_open, text, "")
                .on_hover_text(name.as_ref())
                .clicked()
            {
                self.open(opener, &file);
            }
        }
    }

    /// The field that saves. The line below it, for reports and the question, is always there, so that
    /// nothing moves under the mouse. The answers to the question are far from `Save`, so that a double
    /// click does not give one.
    fn show_saving(&mut self, ui: &mut egui::Ui, editor: &mut SceneEditor, folder: &Path) {
        let safe_name = file_safe_name(self.name.trim());
        let file = folder.join(format!("{safe_name}.toml"));
        ui.horizontal(|ui| {
            let edit = egui::TextEdit::singleline(&mut self.name)
                .hint_text("Name of a new preset")
                .desired_width(ui.available_width() - 150.0);
            let field = ui.add(edit);
            if field.changed() {
                (self.replace, self.report) = (None, String::new());
            }
            let entered =
                field.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter));
            let save = ui.add_enabled(!safe_name.is_empty(), egui::Button::new("Save"));
            if save.clicked() || entered && !safe_name.is_empty() {
                if exists(&file) {
                    self.replace = Some(file.clone());
                } else {
                    self.save(editor, &file);
                }
            }
        });
        ui.horizontal(|ui| {
            ui.set_min_height(24.0);
            if self.replace.as_ref() == Some(&file) {
                if ui.button("Replace").clicked() {
                    self.save(editor, &file);
                }
                if ui.button("Keep").clicked() {
                    self.replace = None;
                }
                ui.colored_label(ACCENT, format!("{safe_name} exists. Replace it?"));
            } else if safe_name != self.name.trim() {
                note(ui, &format!("Will be saved as {safe_name}"));
            } else {
                note(ui, &self.report);
            }
        });
    }

    fn open(&mut self, opener: &mut FileOpener, file: &Path) {
        let is_preset = opener.open(file);
        self.note_opened(file, is_preset);
    }

    fn show_opened(
        &mut self,
        opener: &mut FileOpener,
        file: &Path,
        opened: Result<Opened, String>,
    ) {
        let is_preset = opener.show(file, opened);
        self.note_opened(file, is_preset);
    }

    /// Notes that a file was opened. The name of a preset of the user's is the one to save under.
    fn note_opened(&mut self, file: &Path, is_preset: bool) {
        (self.replace, self.report) = (None, String::new());
        if is_preset && file.parent() == presets_folder().as_deref() {
            self.name = stem(file).into_owned();
        }
    }

    fn save(&mut self, editor: &mut SceneEditor, file: &Path) {
        self.replace = None;
        let mut scene = with_whole_sky_path(editor.scene());
        scene.name = stem(file).chars().take(MAX_NAME_LETTERS).collect();
        // The clock of a flight would do nothing where nothing moves.
        if !scene.disk_moves() {
            scene.disk.time = editor.loaded().disk.time;
        }
        // The title says what another preset shows.
        let loaded = editor.loaded();
        if scene.name != loaded.name && scene.title == loaded.title {
            scene.title.clear();
        }
        let written = create_parent_folder(file)
            .and_then(|()| write_atomically(file, scene.to_preset().as_bytes()));
        match written {
            Ok(()) => {
                self.report = format!("Saved as {}", scene.name);
                editor.change("", scene);
                editor.say(format!("Saved: {}", file.display()));
                editor.note_saved(file);
                self.files = None;
            }
            Err(error) => editor.say(error.to_string()),
        }
    }
}

/// The name of a file without its extension.
fn stem(file: &Path) -> Cow<'_, str> {
    file.file_stem().unwrap_or_default().to_string_lossy()
}

/// The title of the scene in a preset file. Empty if it has none or cannot be read.
fn title_in(file: &Path) -> String {
    read_scene(file, &[]).map_or_else(|_| String::new(), |scene| scene.title)
}

fn show_built_in(ui: &mut egui::Ui, editor: &mut SceneEditor) {
    let name = editor.scene().name;
    for preset in presets::PRESETS {
        let scene = preset.plain_scene();
        let number = preset.number.to_string();
        let command = format!("{}: lightfall --preset {number}", preset.name);
        let entry = entry(ui, name == preset.name, &scene.title, &number);
        if entry.on_hover_text(command).clicked() {
            editor.load("", Ok(scene.clone()));
        }
    }
}

/// A line of a list, as wide as the page, after its key.
fn entry(ui: &mut egui::Ui, selected: bool, text: &str, key: &str) -> egui::Response {
    let line = format!("{key}   {text}");
    let button = egui::Button::selectable(selected, line.trim_start()).truncate();
    let left = egui::Layout::top_down_justified(egui::Align::Min);
    ui.with_layout(left, |ui| ui.add(button)).inner
}

/// The button that copies the address or the command line of the present scene.
fn show_sharing(ui: &mut egui::Ui, editor: &mut SceneEditor, clipboard: &Clipboard) {
    let (what, hint) = if IN_BROWSER {
        ("Copy link", "The address of this page with this scene")
    } else {
        ("Copy command", "The command line that opens this scene")
    };
    if ui.button(what).on_hover_text(hint).clicked() {
        let said = copy_link(&editor.scene(), clipboard);
        editor.say(said);
    }
}

fn heading(ui: &mut egui::Ui, text: &str) {
    ui.label(egui::RichText::new(text).strong().size(15.0));
}

fn note(ui: &mut egui::Ui, text: &str) {
    ui.label(egui::RichText::new(text).size(12.5).color(WEAK_TEXT));
}

pub(super) fn open_dropped_files(
    mut drops: MessageReader<FileDragAndDrop>,
    mut opener: FileOpener,
) {
    for drop in drops.read() {
        if let FileDragAndDrop::DroppedFile { path_buf, .. } = drop {
            opener.open(path_buf);
        }
    }
}
