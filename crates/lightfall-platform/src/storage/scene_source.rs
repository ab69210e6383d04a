//! Texts of presets, missions and journeys, from files and from pictures; journeys, camera paths and
//! catalogues of stars.

use super::embedded_preset::{embedded_preset, is_picture};
use super::files::{TextError, exists, read, text_of};
use super::folders::lessons_folder;
use super::hash::hash_of_bytes;
use lightfall_core::gpu::{Drawable, Undrawable};
use lightfall_core::optics::ship::StartError;
use lightfall_core::optics::stars::{Catalogue, CatalogueError, StarFile};
use lightfall_core::scene::journey;
use lightfall_core::scene::journey::{CameraPathError, Journey, JourneyError, Unflyable};
use lightfall_core::scene::mission::MissionError;
use lightfall_core::scene::{Scene, SceneError};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Maximum size of a preset file, in bytes.
pub(super) const MAX_PRESET_BYTES: u64 = 1 << 20;

/// Maximum size of a camera path, in bytes: more than the largest number of rows takes.
const MAX_PATH_BYTES: u64 = 128 << 20;

/// The frames per second of a camera path that counts frames, where nothing says it.
const USUAL_FRAME_RATE: f64 = 30.0;

/// Maximum size of a catalogue of stars, in bytes: more than the largest number of stars takes.
const MAX_STAR_FILE_BYTES: u64 = 256 << 20;

/// Why a scene, a mission, a journey or a catalogue of stars cannot be read. Each message is one sentence that
/// names the file or the option.
#[derive(Debug, Error)]
pub enum SourceError {
    /// The preset or an override is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The journey is wrong.
    #[error(transparent)]
    Journey(#[from] JourneyError),
    /// The camera path is wrong.
    #[error(transparent)]
    CameraPath(#[from] CameraPathError),
    /// The mission is wrong.
    #[error(transparent)]
    Mission(#[from] MissionError),
    /// There is no ship at the mission's start.
    #[error("{origin}: {fault}")]
    NoStart {
        /// The mission's file or name.
        origin: String,
        /// Why there is none.
        fault: StartError,
    },
    /// The mission's scene cannot be drawn.
    #[error("{origin}: {fault}")]
    Undrawable {
        /// The mission's file or name.
        origin: String,
        /// Why it cannot.
        fault: Box<Undrawable>,
    },
    /// A mission where a preset is needed.
    #[error("{given}: is a mission and not a preset; `lightfall --preset {given}` flies it")]
    MissionAsPreset {
        /// The mission's file or name.
        given: String,
    },
    /// A journey where a preset is needed.
    #[error(
        "{given}: this is a journey or a lesson, not a preset; fly it with `lightfall --journey {given}`"
    )]
    JourneyAsPreset {
        /// The journey's file or name.
        given: String,
    },
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

/// The journey of a file, by its path or, for the built-in lessons and the user's own ones, by its name;
/// or the built-in journey. All of a file's journey must be possible in `scene`; the built-in journey
/// is not checked, because it may never be flown.
///
/// # Errors
/// The file cannot be read or is wrong, or a part of the journey cannot be flown in `scene`.
pub fn read_journey(file: Option<&Path>, scene: &Scene) -> Result<Journey, SourceError> {
    let Some(path) = file else {
        return Ok(journey::load("the built-in journey", journey::DEFAULT)?);
    };
    flyable_journey(path, journey_by_name(path)?, scene)
}

/// The journey, of which all must be possible in `scene`. `path` names it in errors.
///
/// # Errors
/// A part of the journey cannot be flown in `scene`.
pub fn flyable_journey(
    path: &Path,
    journey: Journey,
    scene: &Scene,
) -> Result<Journey, SourceError> {
    let checked = journey.check(scene, 0.0, Drawable::new);
    checked
        .map(|()| journey)
        .map_err(|unflyable| SourceError::Unflyable {
            path: path.into(),
            unflyable,
        })
}

/// The journey of a file of keyframes or of a camera path, by its path or, for the built-in lessons and the
/// user's own ones, by its name. It may not be possible in every scene.
///
/// # Errors
/// The file cannot be read or is wrong.
pub fn journey_by_name(path: &Path) -> Result<Journey, SourceError> {
    journey_at_rate(path, USUAL_FRAME_RATE)
}

/// As [`journey_by_name`], with so many frames a second in a camera path that counts frames.
///
/// # Errors
/// As those of [`journey_by_name`].
pub fn journey_at_rate(path: &Path, fps: f64) -> Result<Journey, SourceError> {
    let built_in = path.to_str().filter(|_| !exists(path));
    match built_in.and_then(journey::built_in) {
        Some(lesson) => Ok(lesson),
        None if is_camera_path(path) => camera_path(path, fps),
        None => journey_of_file(&own_lesson(path).unwrap_or_else(|| path.into())),
    }
}

/// Whether a file is a table of cameras, which its name says.
pub(super) fn is_camera_path(path: &Path) -> bool {
    let extension = path.extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case("csv"))
}

/// The journey of a camera path in CSV.
fn camera_path(path: &Path, fps: f64) -> Result<Journey, SourceError> {
    let fault = |fault| no_text(path, fault, "");
    let bytes = read(path, MAX_PATH_BYTES).map_err(|error| fault(error.into()))?;
    let text = text_of(bytes, MAX_PATH_BYTES).map_err(fault)?;
    let name = path.display().to_string();
    Ok(journey::load_camera_path(&name, &text, fps)?)
}

/// The journey of a file of keyframes, which may not be possible in every scene.
///
/// # Errors
/// The file cannot be read or is wrong.
pub fn journey_of_file(path: &Path) -> Result<Journey, SourceError> {
    let bytes = contents(path)?;
    if is_picture(&bytes) {
        return Err(SourceError::PictureAsJourney { path: path.into() });
    }
    let text = text_of_source(path, bytes)?;
    Ok(journey::load(&path.display().to_string(), &text)?)
}

/// The file of the user's own lesson with this name, where there is no other file of this path.
fn own_lesson(path: &Path) -> Option<PathBuf> {
    let is_name = path.components().count() == 1 && path.extension().is_none();
    let file = lessons_folder()?.join(path).with_extension("toml");
    (is_name && !exists(path) && exists(&file)).then_some(file)
}

/// The catalogue of a CSV file of stars.
///
/// # Errors
/// The file cannot be read, or is not a catalogue.
pub fn read_stars(path: &Path) -> Result<Catalogue, SourceError> {
    let fault = |fault| no_text(path, fault, "");
    let bytes = read(path, MAX_STAR_FILE_BYTES).map_err(|error| fault(error.into()))?;
    let sha256 = hash_of_bytes(&bytes);
    let text = text_of(bytes, MAX_STAR_FILE_BYTES).map_err(fault)?;
    let mut catalogue = Catalogue::from_csv(&path.display().to_string(), &text)?;
    catalogue.file = Some(StarFile {
        name: path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into(),
        sha256,
    });
    Ok(catalogue)
}

/// The first bytes of a file, enough for every preset.
pub(super) fn contents(path: &Path) -> Result<Vec<u8>, SourceError> {
    read(path, MAX_PRESET_BYTES).map_err(|error| no_text(path, error.into(), ""))
}

/// The text of a preset or journey file, or of the preset in a picture.
pub(super) fn text_of_source(path: &Path, bytes: Vec<u8>) -> Result<String, SourceError> {
    if is_picture(&bytes) {
        return embedded_preset(&bytes).ok_or(SourceError::NoPreset { path: path.into() });
    }
    let no_text = |fault| {
        no_text(
            path,
            fault,
            "; presets, missions and journeys are short TOML texts",
        )
    };
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
