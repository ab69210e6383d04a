//! Where the program writes, and whether it can; nothing is changed by looking.

use crate::app::Settings;
use crate::storage::{check_folder_writable, pictures_folder, presets_folder, settings_file};
use lightfall_core::gpu::AdapterName;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The file of settings.
#[derive(Clone, Debug, Serialize)]
pub struct SettingsFile {
    /// Where it is; none on a system without such a place.
    pub path: Option<PathBuf>,
    /// Whether there is one. Without it the defaults serve.
    pub exists: bool,
    /// What is wrong with it.
    pub wrong: Option<String>,
    /// The adapter that it names for the window.
    pub adapter: Option<AdapterName>,
}

/// A folder that is written to.
#[derive(Clone, Debug, Serialize)]
pub struct Folder {
    /// What is kept there.
    pub holds: &'static str,
    /// Where it is; none on a system without such a place.
    pub path: Option<PathBuf>,
    /// Whether it is there already; if not, it is made when it is needed.
    pub exists: bool,
    /// Why it cannot be written.
    pub wrong: Option<String>,
}

impl SettingsFile {
    /// That of this user.
    #[must_use]
    pub fn here() -> Self {
        let path = settings_file();
        let looked = path.as_deref().map_or(Ok(None), Settings::read_file);
        let (settings, wrong) =
            looked.map_or_else(|wrong| (None, Some(wrong)), |settings| (settings, None));
        let exists = settings.is_some() || wrong.is_some();
        Self {
            path,
            exists,
            wrong,
            adapter: settings.and_then(|settings| settings.adapter),
        }
    }

    /// What is wrong, with what to do.
    pub(super) fn fault(&self) -> Option<String> {
        let (path, wrong) = (self.path.as_ref()?, self.wrong.as_ref()?);
        Some(format!(
            "{}: {wrong}; mend or remove it, or the next flight sets it aside and takes the defaults",
            path.display()
        ))
    }
}

impl Folder {
    /// What is wrong, with what to do.
    pub(super) fn fault(&self) -> Option<String> {
        let (path, wrong, holds) = (self.path.as_ref()?, self.wrong.as_ref()?, self.holds);
        Some(format!(
            "{}: {wrong}, so no {holds} can be kept; make it a folder that you may write to",
            path.display()
        ))
    }
}

/// The folders that the program writes to by itself.
pub(super) fn folders() -> Vec<Folder> {
    let settings = settings_file().and_then(|file| Some(file.parent()?.to_owned()));
    let all = [
        ("settings", settings),
        ("presets", presets_folder()),
        ("pictures", Some(pictures_folder())),
    ];
    all.map(|(holds, path)| {
        let exists = path.as_ref().is_some_and(|path| path.is_dir());
        let wrong = path.as_ref().and_then(|path| try_to_write(path).err());
        Folder {
            holds,
            path,
            exists,
            wrong,
        }
    })
    .into()
}

/// Whether files can be made in a folder or, where there is none yet, in the one in which it would
/// be made.
fn try_to_write(folder: &Path) -> Result<(), String> {
    let there = folder
        .ancestors()
        .find(|part| part.exists())
        .unwrap_or(Path::new("."));
    if !there.is_dir() {
        return Err(format!("{} is a file and no folder", there.display()));
    }
    check_folder_writable(there).map_err(|error| format!("cannot be written ({})", error.kind()))
}
