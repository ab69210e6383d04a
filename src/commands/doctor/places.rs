//! The files and folders that the program writes, and whether it can write them. Examining them
//! changes nothing.

use crate::app::{Settings, SettingsFault};
use lightfall_core::gpu::AdapterName;
use lightfall_platform::storage::{
    check_folder_writable, pictures_folder, presets_folder, settings_file,
};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The settings file.
#[derive(Clone, Debug, Serialize)]
pub struct SettingsFile {
    /// Its path, or `None` on a system that has no folder for settings.
    pub path: Option<PathBuf>,
    /// Whether it exists. Without it, the default settings are used.
    pub exists: bool,
    /// What is wrong with it, if anything is.
    pub wrong: Option<String>,
    /// Whether it is of a newer version of the program.
    pub newer: bool,
    /// The adapter that it chooses for the window.
    pub adapter: Option<AdapterName>,
}

/// A folder that the program writes to.
#[derive(Clone, Debug, Serialize)]
pub struct Folder {
    /// What the folder holds.
    pub holds: &'static str,
    /// Its path, or `None` on a system that has no folder for settings.
    pub path: Option<PathBuf>,
    /// Whether it exists. If not, it is created when it is needed.
    pub exists: bool,
    /// Why it cannot be written, if that is so.
    pub wrong: Option<String>,
}

impl SettingsFile {
    /// Examines the settings file of this user.
    #[must_use]
    pub fn here() -> Self {
        let path = settings_file();
        let looked = path.as_deref().map_or(Ok(None), Settings::read_file);
        let (settings, fault) =
            looked.map_or_else(|fault| (None, Some(fault)), |settings| (settings, None));
        Self {
            path,
            exists: settings.is_some() || fault.is_some(),
            newer: matches!(fault, Some(SettingsFault::Newer { .. })),
            wrong: fault.map(|fault| fault.to_string()),
            adapter: settings.and_then(|settings| settings.adapter),
        }
    }

    /// A sentence that says what is wrong and what to do.
    pub(super) fn fault(&self) -> Option<String> {
        let (path, wrong) = (self.path.as_ref()?, self.wrong.as_ref()?);
        let remedy = if self.newer {
            "update Lightfall, or rename the file; until then the window uses the default settings and leaves the file as \
             it is"
        } else {
            "mend or remove it, or the next flight renames it and uses the default settings"
        };
        Some(format!("{}: {wrong}; {remedy}", path.display()))
    }
}

impl Folder {
    /// A sentence that says what is wrong and what to do.
    pub(super) fn fault(&self) -> Option<String> {
        let holds = self.holds;
        let Some(path) = &self.path else {
            return Some(format!(
                "this system names no folder for {holds}, so none are saved; set the variable HOME to a \
                 folder that you may write to"
            ));
        };
        let wrong = self.wrong.as_ref()?;
        Some(format!(
            "{}: {wrong}, so no {holds} can be saved; make it a folder that you may write to",
            path.display()
        ))
    }
}

/// Examines the folders that the program writes to by default.
pub(super) fn folders() -> Vec<Folder> {
    let settings = settings_file().and_then(|file| Some(file.parent()?.to_owned()));
    let all = [
        ("settings", settings),
        ("presets", presets_folder()),
        ("pictures", Some(pictures_folder())),
    ];
    all.map(|(holds, path)| {
        let exists = path.as_ref().is_some_and(|path| path.is_dir());
        let wrong = path.as_ref().and_then(|path| check_writable(path).err());
        Folder {
            holds,
            path,
            exists,
            wrong,
        }
    })
    .into()
}

/// Checks that files can be created in a folder or, if it does not exist yet, in the folder in
/// which it would be created.
fn check_writable(folder: &Path) -> Result<(), String> {
    let existing = folder
        .ancestors()
        .find(|part| part.exists())
        .unwrap_or(Path::new("."));
    if !existing.is_dir() {
        return Err(format!("{} is a file and no folder", existing.display()));
    }
    check_folder_writable(existing).map_err(|error| format!("cannot be written ({})", error.kind()))
}
