//! Presets and missions, by name and from files.

use super::files::exists;
use super::folders::{missions_folder, preset_files, presets_folder};
use super::scene_source::{SourceError, contents, text_of_source};
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::ship::Attempt;
use lightfall_core::scene::mission::{self, MISSIONS, Mission};
use lightfall_core::scene::{Override, Scene, load, nearest_name, presets};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// What a name or a file opens.
#[derive(Clone, Debug)]
pub enum Opened {
    /// The scene of a preset, or of the preset in a picture.
    Scene(Box<Scene>),
    /// A mission that can be begun.
    Mission(Box<Mission>),
}

impl Opened {
    /// The scene, and the mission that starts in it, if it is that of one.
    #[must_use]
    pub fn into_parts(self) -> (Scene, Option<Box<Mission>>) {
        match self {
            Self::Scene(scene) => (*scene, None),
            Self::Mission(mission) => (mission.scene().clone(), Some(mission)),
        }
    }

    /// The scene of a preset, where nothing else is of use.
    fn into_preset(self, given: &OsStr) -> Result<Scene, SourceError> {
        match self {
            Self::Scene(scene) => Ok(*scene),
            Self::Mission(_) => Err(SourceError::MissionAsPreset {
                given: given.display().to_string(),
            }),
        }
    }
}

/// A built-in preset, by number or name; a built-in mission, by name; one of the user's own presets or
/// missions, by name; or a file, by path. `asked` names the option or the command in errors.
///
/// # Errors
/// There is no such preset or mission, or it cannot be read or is wrong; or an override is wrong.
pub fn open_by_name(
    asked: &'static str,
    given: &OsStr,
    overrides: &[Override],
) -> Result<Opened, SourceError> {
    let name = given.to_str();
    if let Some(preset) = name.and_then(presets::find) {
        return Ok(Opened::Scene(Box::new(preset.scene(overrides)?)));
    }
    if let Some(mission) = name.and_then(mission::built_in) {
        return begun(mission, &given.display().to_string(), overrides);
    }
    let path = Path::new(given);
    let looks_like_a_path = path.components().count() > 1 || path.extension().is_some();
    if !looks_like_a_path && !exists(path) {
        let mut own = own_presets().into_iter().chain(own_missions());
        let own = own.find(|file| file.file_stem() == Some(given));
        let own = own.ok_or_else(|| unknown(asked, given))?;
        return open_file(&own, overrides);
    }
    open_file(path, overrides)
}

/// The preset or the mission of a file, or the preset in a picture.
///
/// # Errors
/// The file cannot be read or is wrong, or an override is wrong.
pub fn open_file(path: &Path, overrides: &[Override]) -> Result<Opened, SourceError> {
    open_contents(path, contents(path)?, overrides)
}

/// As [`open_file`], for a file with these contents. `path` names it in errors.
///
/// # Errors
/// As those of [`open_file`].
pub fn open_contents(
    path: &Path,
    contents: Vec<u8>,
    overrides: &[Override],
) -> Result<Opened, SourceError> {
    let text = text_of_source(path, contents)?;
    let origin = path.display().to_string();
    if mission::is_mission(&text) {
        return begun(mission::load(&origin, &text)?, &origin, overrides);
    }
    Ok(Opened::Scene(Box::new(load(&origin, &text, overrides)?)))
}

/// A mission that can be begun: there is a ship at its start, and its scene can be drawn.
fn begun(mission: Mission, origin: &str, overrides: &[Override]) -> Result<Opened, SourceError> {
    let mission = mission.with(overrides)?;
    let origin = origin.to_owned();
    if let Err(fault) = Attempt::new(&mission) {
        return Err(SourceError::NoStart { origin, fault });
    }
    if let Err(fault) = Drawable::new(mission.scene().clone()) {
        let fault = Box::new(fault);
        return Err(SourceError::Undrawable { origin, fault });
    }
    Ok(Opened::Mission(Box::new(mission)))
}

/// As [`open_by_name`], where only a preset is of use.
///
/// # Errors
/// As those of [`open_by_name`], and a mission.
pub fn scene_by_name(
    asked: &'static str,
    given: &OsStr,
    overrides: &[Override],
) -> Result<Scene, SourceError> {
    open_by_name(asked, given, overrides)?.into_preset(given)
}

/// As [`open_file`], where only a preset is of use.
///
/// # Errors
/// As those of [`open_file`], and a mission.
pub fn read_scene(path: &Path, overrides: &[Override]) -> Result<Scene, SourceError> {
    open_file(path, overrides)?.into_preset(path.as_os_str())
}

/// The files of the user's own presets, which the window's panel saves.
#[must_use]
pub fn own_presets() -> Vec<PathBuf> {
    files_of(presets_folder())
}

/// The files of the user's own missions.
#[must_use]
pub fn own_missions() -> Vec<PathBuf> {
    files_of(missions_folder())
}

fn files_of(folder: Option<PathBuf>) -> Vec<PathBuf> {
    folder
        .map(|folder| preset_files(&folder))
        .unwrap_or_default()
}

/// No preset and no mission has this name: says which was probably meant, or names all presets.
fn unknown(asked: &'static str, given: &OsStr) -> SourceError {
    let built_in = presets::PRESETS.iter().map(|preset| preset.name);
    let built_in = built_in.chain(MISSIONS.iter().map(|(name, _)| *name));
    let own: Vec<PathBuf> = own_presets().into_iter().chain(own_missions()).collect();
    let own = own.iter().filter_map(|file| file.file_stem());
    let names: Vec<String> = built_in
        .map(str::to_owned)
        .chain(own.map(|name| name.to_string_lossy().into_owned()))
        .collect();
    let given = given.display().to_string();
    let hint = match nearest_name(&given, &names) {
        Some(name) => format!("did you mean {name}?"),
        None => format!("the presets are {}", presets::numbered_names()),
    };
    SourceError::UnknownPreset { asked, given, hint }
}
