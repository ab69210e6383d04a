//! Scenes by name, from preset files and from pictures; journeys and catalogues of stars from files.

use super::embedded_preset::{embedded_preset, is_picture};
use super::files::{TextError, exists, read, text_of};
use super::folders::{preset_files, presets_folder};
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::stars::{Catalogue, CatalogueError, StarFile};
use lightfall_core::scene::journey;
use lightfall_core::scene::journey::{Journey, JourneyError, Unflyable};
use lightfall_core::scene::mission::{self, Mission, MissionError};
use lightfall_core::scene::{Override, Scene, SceneError, load, nearest_name, presets};
use sha2::{Digest, Sha256};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Maximum size of a preset file, in bytes.
pub(super) const MAX_PRESET_BYTES: u64 = 1 << 20;

/// Maximum size of a catalogue of stars, in bytes: more than the largest number of stars takes.
const MAX_STAR_FILE_BYTES: u64 = 256 << 20;

/// Why a scene, a journey or a catalogue of stars cannot be read. Each message is one sentence that
/// names the file or the option.
#[derive(Debug, Error)]
pub enum SourceError {
    /// The preset or an override is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The journey is wrong.
    #[error(transparent)]
    Journey(#[from] JourneyError),
    /// The mission is wrong.
    #[error(transparent)]
    Mission(#[from] MissionError),
    /// The catalogue of stars is wrong.
    #[error(transparent)]
    Catalogue(#[from] CatalogueError),
    /// The journey cannot be flown in this scene.
    #[error("{}: {unflyable}", path.display())]
    Unflyable {
        /// The journey's file.
        path: PathBuf,
        /// Where in the journey, and why.
        unflyable: Unflyable,
    },
    /// No built-in preset and no file has this name.
    #[error("{asked} {given}: there is no such preset or file; {hint}")]
    UnknownPreset {
        /// The option or the command that the name was given to.
        asked: &'static str,
        /// The name.
        given: String,
        /// What was probably meant, or all presets.
        hint: String,
    },
    /// The file gives no text.
    #[error("{}: {fault}{remark}", path.display())]
    Text {
        /// The file.
        path: PathBuf,
        /// Why it gives none.
        fault: TextError,
        /// What such files are, if that helps; it goes on with the sentence.
        remark: &'static str,
    },
    /// The file is a picture without a preset in it.
    #[error(
        "{}: holds no preset; only pictures that Lightfall wrote, and no other program changed, hold one",
        path.display()
    )]
    NoPreset {
        /// The file.
        path: PathBuf,
    },
    /// The file of a journey is a picture.
    #[error("{}: is a picture, and a journey is a TOML text of keyframes", path.display())]
    PictureAsJourney {
        /// The file.
        path: PathBuf,
    },
}

/// The scene of a built-in preset, by number or name; of one of the user's own presets, by name; or
/// of a file, by path. `asked` names the option or the command in errors.
///
/// # Errors
/// The preset does not exist, cannot be read or is wrong; or an override is wrong.
pub fn scene_by_name(
    asked: &'static str,
    preset: &OsStr,
    overrides: &[Override],
) -> Result<Scene, SourceError> {
    if let Some(preset) = preset.to_str().and_then(presets::find) {
        return Ok(preset.scene(overrides)?);
    }
    let path = Path::new(preset);
    let looks_like_a_path = path.components().count() > 1 || path.extension().is_some();
    if !looks_like_a_path && !exists(path) {
        if let Some(own) = own_preset(preset) {
            return read_scene(&own, overrides);
        }
        let given = preset.display().to_string();
        let hint = preset_hint(&given);
        return Err(SourceError::UnknownPreset { asked, given, hint });
    }
    read_scene(path, overrides)
}

/// The scene of a preset file, or of the preset in a picture.
///
/// # Errors
/// The file cannot be read or is wrong, or an override is wrong.
pub fn read_scene(path: &Path, overrides: &[Override]) -> Result<Scene, SourceError> {
    scene_of_file(path, contents(path)?, overrides)
}

/// The scene of a preset file, or of the preset in a picture, with these contents. `path` names the
/// file in errors.
///
/// # Errors
/// The contents or an override are wrong.
pub fn scene_of_file(
    path: &Path,
    contents: Vec<u8>,
    overrides: &[Override],
) -> Result<Scene, SourceError> {
    let text = text_of_source(path, contents)?;
    Ok(load(&path.display().to_string(), &text, overrides)?)
}

/// The journey of a file, or the built-in journey. All of a file's journey must be possible in
/// `scene`; the built-in journey is not checked, because it may never be flown.
///
/// # Errors
/// The file cannot be read or is wrong, or a part of the journey cannot be flown in `scene`.
pub fn read_journey(file: Option<&Path>, scene: &Scene) -> Result<Journey, SourceError> {
    let Some(path) = file else {
        return Ok(journey::load("the built-in journey", journey::DEFAULT)?);
    };
    let bytes = contents(path)?;
    if is_picture(&bytes) {
        return Err(SourceError::PictureAsJourney { path: path.into() });
    }
    let text = text_of_source(path, bytes)?;
    let journey = journey::load(&path.display().to_string(), &text)?;
    let checked = journey.check(scene, 0.0, Drawable::new);
    checked
        .map(|()| journey)
        .map_err(|unflyable| SourceError::Unflyable {
            path: path.into(),
            unflyable,
        })
}

/// The mission of a file. `None` if the file is a preset or a picture.
///
/// # Errors
/// The file cannot be read, or is a mission that is wrong.
pub fn read_mission(path: &Path) -> Result<Option<Mission>, SourceError> {
    let bytes = contents(path)?;
    if is_picture(&bytes) {
        return Ok(None);
    }
    let text = text_of_source(path, bytes)?;
    mission::is_mission(&text)
        .then(|| mission::load(&path.display().to_string(), &text))
        .transpose()
        .map_err(SourceError::Mission)
}

/// The catalogue of a CSV file of stars.
///
/// # Errors
/// The file cannot be read, or is not a catalogue.
pub fn read_stars(path: &Path) -> Result<Catalogue, SourceError> {
    let fault = |fault| no_text(path, fault, "");
    let bytes = read(path, MAX_STAR_FILE_BYTES).map_err(|error| fault(error.into()))?;
    let hash = Sha256::digest(&bytes);
    let text = text_of(bytes, MAX_STAR_FILE_BYTES).map_err(fault)?;
    let mut catalogue = Catalogue::from_csv(&path.display().to_string(), &text)?;
    catalogue.file = Some(StarFile {
        name: path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into(),
        sha256: hash.iter().map(|byte| format!("{byte:02x}")).collect(),
    });
    Ok(catalogue)
}

/// The files of the user's own presets, which the window's panel saves.
#[must_use]
pub fn own_presets() -> Vec<PathBuf> {
    presets_folder()
        .map(|folder| preset_files(&folder))
        .unwrap_or_default()
}

fn own_preset(name: &OsStr) -> Option<PathBuf> {
    own_presets()
        .into_iter()
        .find(|file| file.file_stem() == Some(name))
}

/// The first bytes of a file, enough for every preset.
fn contents(path: &Path) -> Result<Vec<u8>, SourceError> {
    read(path, MAX_PRESET_BYTES).map_err(|error| no_text(path, error.into(), ""))
}

/// The text of a preset or journey file, or of the preset in a picture.
fn text_of_source(path: &Path, bytes: Vec<u8>) -> Result<String, SourceError> {
    if is_picture(&bytes) {
        return embedded_preset(&bytes).ok_or(SourceError::NoPreset { path: path.into() });
    }
    let no_text = |fault| no_text(path, fault, "; presets and journeys are short TOML texts");
    let text = text_of(bytes, MAX_PRESET_BYTES).map_err(no_text)?;
    let says_nothing = |line: &str| line.trim().is_empty() || line.trim().starts_with('#');
    if text.lines().all(says_nothing) {
        return Err(no_text(TextError::Empty));
    }
    Ok(text)
}

fn no_text(path: &Path, fault: TextError, remark: &'static str) -> SourceError {
    SourceError::Text {
        path: path.into(),
        fault,
        remark,
    }
}

/// The preset that was probably meant, or all presets.
fn preset_hint(given: &str) -> String {
    let built_in = presets::PRESETS.iter().map(|preset| preset.name.to_owned());
    let own = own_presets();
    let own = own.iter().filter_map(|file| file.file_stem());
    let names: Vec<String> = built_in
        .chain(own.map(|name| name.to_string_lossy().into_owned()))
        .collect();
    match nearest_name(given, &names) {
        Some(name) => format!("did you mean {name}?"),
        None => format!("the presets are {}", presets::numbered_names()),
    }
}
