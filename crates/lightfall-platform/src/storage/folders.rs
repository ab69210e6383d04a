//! The folders that the program uses by default.

use super::files::files_in;
use std::path::{Path, PathBuf};

/// The settings file, or `None` on a system that has no folder for settings.
#[must_use]
pub fn settings_file() -> Option<PathBuf> {
    Some(settings_folder()?.join("settings.toml"))
}

/// The folder of the user's own presets, or `None` on a system that has no folder for settings.
#[must_use]
pub fn presets_folder() -> Option<PathBuf> {
    Some(settings_folder()?.join("presets"))
}

/// The folder of the user's own missions, or `None` on a system that has no folder for settings.
#[must_use]
pub fn missions_folder() -> Option<PathBuf> {
    Some(settings_folder()?.join("missions"))
}

/// The folder of the user's own lessons, or `None` on a system that has no folder for settings.
#[must_use]
pub fn lessons_folder() -> Option<PathBuf> {
    Some(settings_folder()?.join("lessons"))
}

/// The file of the answers to questions of lessons, or `None` on a system that has no folder for settings.
#[must_use]
pub fn lesson_results_file() -> Option<PathBuf> {
    Some(settings_folder()?.join("lesson-results.csv"))
}

/// The file of the results of missions, or `None` on a system that has no folder for settings.
#[must_use]
pub fn mission_results_file() -> Option<PathBuf> {
    Some(settings_folder()?.join("mission-results.csv"))
}

#[cfg(not(target_arch = "wasm32"))]
fn settings_folder() -> Option<PathBuf> {
    let folders = directories::ProjectDirs::from("", "", "lightfall")?;
    Some(folders.config_dir().to_owned())
}

#[cfg(target_arch = "wasm32")]
fn settings_folder() -> Option<PathBuf> {
    Some("lightfall".into())
}

/// The preset files in a folder, sorted by name. A folder that does not exist holds none.
#[must_use]
pub fn preset_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = files_in(folder);
    files.retain(|path| path.extension().is_some_and(|end| end == "toml"));
    files.sort();
    files
}

/// The folder of screenshots: the user's folder for pictures, else the home folder, else the
/// current folder. XDG_PICTURES_DIR in the environment comes before the desktop's own list of
/// folders.
#[cfg(not(target_arch = "wasm32"))]
#[must_use]
pub fn pictures_folder() -> PathBuf {
    let by_environment = std::env::var_os("XDG_PICTURES_DIR")
        .map(PathBuf::from)
        .filter(|folder| folder.is_absolute());
    let folders = directories::UserDirs::new();
    let home = folders
        .as_ref()
        .map(|folders| folders.home_dir().to_owned());
    let named = folders
        .as_ref()
        .and_then(|folders| folders.picture_dir().map(Path::to_owned));
    // Desktops that configure no folder for pictures usually still have one of this name.
    let usual = home.as_ref().map(|home| home.join("Pictures"));
    let known = [by_environment, named, usual, home]
        .into_iter()
        .flatten()
        .find(|folder| folder.is_dir());
    known.unwrap_or_else(|| PathBuf::from("."))
}

/// The folders of the reports of crashes, the best one first: the system's for such data, and that
/// for temporary files.
#[cfg(not(target_arch = "wasm32"))]
#[must_use]
pub fn reports_folders() -> Vec<PathBuf> {
    let own = directories::ProjectDirs::from("", "", "lightfall");
    let own = own.map(|folders| folders.data_local_dir().to_owned());
    own.into_iter().chain([std::env::temp_dir()]).collect()
}

/// The folder of the reports of crashes, in the browser's storage.
#[cfg(target_arch = "wasm32")]
#[must_use]
pub fn reports_folders() -> [PathBuf; 1] {
    ["lightfall/reports".into()]
}
