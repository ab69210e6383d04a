//! Presets, missions and journeys, by name and from files.

use super::files::exists;
use super::folders::{lessons_folder, missions_folder, preset_files, presets_folder};
use super::scene_source::{SourceError, contents, is_camera_path, journey_by_name, text_of_source};
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::ship::Attempt;
use lightfall_core::scene::journey::{self, Journey, LESSONS};
use lightfall_core::scene::mission::{self, MISSIONS, Mission};
use lightfall_core::scene::presets::PRESETS;
use lightfall_core::scene::{MAX_TEXT_CHARS, Override, Scene, load, nearest_name, presets};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

/// The field that names the picture of the sky.
const SKY_PICTURE: &str = "sky.picture";

/// What a name or a file opens.
#[derive(Clone, Debug)]
pub enum Opened {
    /// The scene of a preset, or of the preset in a picture.
    Scene(Box<Scene>),
    /// A mission that can be begun.
    Mission(Box<Mission>),
    /// A journey, which may be a lesson.
    Journey(Box<Journey>),
}

impl Opened {
    /// The scene, and the mission if this is one. A journey's scene is the preset that it names, or the
    /// default one, without overrides.
    #[must_use]
    pub fn into_parts(self) -> (Scene, Option<Box<Mission>>) {
        match self {
            Self::Scene(scene) => (*scene, None),
            Self::Mission(mission) => (mission.scene().clone(), Some(mission)),
            Self::Journey(journey) => (journey.stage().plain_scene().clone(), None),
        }
    }

    /// The scene of a preset, where nothing else is of use.
    fn into_preset(self, given: &OsStr) -> Result<Scene, SourceError> {
        match self {
            Self::Scene(scene) => Ok(*scene),
            Self::Mission(_) => Err(SourceError::MissionAsPreset {
                given: given.display().to_string(),
            }),
            Self::Journey(_) => Err(SourceError::JourneyAsPreset {
                given: given.display().to_string(),
            }),
        }
    }
}

/// A built-in preset, by number or name; a built-in mission, by name; a file, by path; one of the user's own
/// presets or missions, by name; a built-in lesson, by name; or one of the user's own lessons, by name: the
/// first of these that there is. `asked` names the option or the command in errors. A journey takes no
/// overrides: they are for the scene in which it is flown.
///
/// # Errors
/// There is none of them, or it cannot be read or is wrong; or an override is wrong.
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
    if looks_like_a_path || exists(path) {
        return open_file(path, overrides);
    }
    let has_name = |file: &PathBuf| file.file_stem() == Some(given);
    let own = own_presets()
        .into_iter()
        .chain(own_missions())
        .find(has_name);
    if let Some(own) = own {
        return open_file(&own, overrides);
    }
    if let Some(lesson) = name.and_then(journey::built_in) {
        return Ok(Opened::Journey(Box::new(lesson)));
    }
    let own = files_of(lessons_folder()).into_iter().find(has_name);
    open_file(&own.ok_or_else(|| unknown(asked, given))?, overrides)
}

/// The preset, the mission or the journey of a file, or the preset in a picture. A table in CSV is a camera
/// path, which is a journey.
///
/// # Errors
/// The file cannot be read or is wrong, or an override is wrong.
pub fn open_file(path: &Path, overrides: &[Override]) -> Result<Opened, SourceError> {
    if is_camera_path(path) {
        return Ok(Opened::Journey(Box::new(journey_by_name(path)?)));
    }
    open_contents(path, contents(path)?, overrides)
}

/// As [`open_file`], for a file with these contents. `path` names it in errors. A journey takes no overrides.
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
    if journey::is_journey(&text) {
        let journey = journey::load(&origin, &text)?;
        return Ok(Opened::Journey(Box::new(journey)));
    }
    let scene = load(&origin, &text, overrides)?;
    Ok(Opened::Scene(Box::new(with_sky_beside(
        path, scene, overrides,
    ))))
}

/// The scene with a path of its picture of the sky that holds where the program runs, if the preset names a
/// file in its own folder. A path that the command line gives, and one of a file that is not in that folder,
/// stay as they are.
fn with_sky_beside(preset: &Path, mut scene: Scene, overrides: &[Override]) -> Scene {
    let named = Path::new(&scene.sky.picture);
    let is_of_preset = !overrides.iter().any(|set| set.key == SKY_PICTURE);
    let beside = preset.parent().map(|folder| folder.join(named));
    let beside = beside.filter(|beside| {
        is_of_preset && !scene.sky.picture.is_empty() && named.is_relative() && exists(beside)
    });
    if let Some(path) = beside {
        set_sky_path(&mut scene, &path);
    }
    scene
}

/// The scene with the absolute path of its picture of the sky, for a preset file in another folder. The path
/// stays as it is where the field cannot hold the absolute one.
#[must_use]
pub fn with_whole_sky_path(mut scene: Scene) -> Scene {
    if !scene.sky.picture.is_empty()
        && let Ok(path) = std::path::absolute(&scene.sky.picture)
    {
        set_sky_path(&mut scene, &path);
    }
    scene
}

/// Names another file as the picture of the sky, if the field can hold its path.
fn set_sky_path(scene: &mut Scene, path: &Path) {
    if let Some(path) = path.to_str()
        && path.chars().count() <= MAX_TEXT_CHARS
    {
        scene.sky.picture = path.into();
    }
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
/// As those of [`open_by_name`], and a mission or a journey.
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
/// As those of [`open_file`], and a mission or a journey.
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

/// The user's own presets, missions and lessons.
fn own_files() -> impl Iterator<Item = PathBuf> {
    let lessons = files_of(lessons_folder());
    let files = own_presets().into_iter().chain(own_missions());
    files.chain(lessons)
}

fn files_of(folder: Option<PathBuf>) -> Vec<PathBuf> {
    folder
        .map(|folder| preset_files(&folder))
        .unwrap_or_default()
}

/// No preset and no mission has this name: says which was probably meant, or names all presets.
fn unknown(asked: &'static str, given: &OsStr) -> SourceError {
    let built_in = PRESETS.iter().map(|preset| preset.name);
    let built_in = built_in.chain(MISSIONS.iter().map(|(name, _)| *name));
    let built_in = built_in.chain(LESSONS.iter().map(|(name, _)| *name));
    let own: Vec<PathBuf> = own_files().collect();
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
