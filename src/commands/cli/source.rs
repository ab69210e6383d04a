//! Where scenes and journeys come from: a name, a file, and what overrides single fields.

use super::args::{PresetsCommand, SceneArgs};
use crate::app::{preset_files, presets_folder};
use crate::picture::{embedded_preset, is_picture};
use lightfall_core::gpu::{Drawable, GpuError, GpuScene};
use lightfall_core::reports::rays::is_closed_pipe;
use lightfall_core::scene::journey;
use lightfall_core::scene::journey::{Journey, JourneyError, Unflyable};
use lightfall_core::scene::{Override, Scene, SceneError, load, presets};
use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Most bytes of a preset file.
const MAX_PRESET_BYTES: u64 = 1 << 20;

/// Why the command line does not give a scene, or what was asked could not be written.
#[derive(Debug, Error)]
pub enum CliError {
    /// The preset or what overrides it is wrong.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The journey is wrong.
    #[error(transparent)]
    Journey(#[from] JourneyError),
    /// The journey cannot be flown in this scene.
    #[error("{}: {unflyable}", path.display())]
    Unflyable {
        /// The file.
        path: PathBuf,
        /// Where, and why.
        unflyable: Unflyable,
    },
    /// No built-in preset and no file has this name.
    #[error(
        "{asked} {given}: there is no such file, and the presets are {}",
        all_presets()
    )]
    UnknownPreset {
        /// Who asked: an option or a command.
        asked: &'static str,
        /// What was given.
        given: String,
    },
    /// A preset file cannot be read.
    #[error("{}: cannot be read: {error}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A preset file is longer than any preset.
    #[error("{}: is longer than {MAX_PRESET_BYTES} bytes; presets and journeys are short TOML texts", path.display())]
    TooLong {
        /// The file.
        path: PathBuf,
    },
    /// A preset file is not text.
    #[error("{}: is not UTF-8 text; presets and journeys are short TOML texts", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
    },
    /// A picture without a preset in it.
    #[error(
        "{}: holds no preset; of pictures those do that lightfall has drawn, and that no other program has changed",
        path.display()
    )]
    NoPreset {
        /// The file.
        path: PathBuf,
    },
    /// A preset whose fields do not go together.
    #[error("{}: {reason}", path.display())]
    Undrawable {
        /// The file.
        path: PathBuf,
        /// What does not.
        reason: String,
    },
    /// The answer cannot be written.
    #[error("standard output: {0}")]
    Output(io::Error),
}

impl CliError {
    /// Exit status: 2 for a bad command line or preset, 1 for any other failure.
    pub fn exit_code(&self) -> u8 {
        if matches!(self, Self::Output(_)) {
            1
        } else {
            2
        }
    }
}

/// The scene that is meant; reads the preset's file where it is one.
///
/// # ErrorSummary
/// One sentence that names the file or option and what is wrong with it.
pub fn scene(args: &SceneArgs) -> Result<Scene, CliError> {
    let overrides = args.overrides()?;
    match &args.preset {
        None => Ok(presets::PRESETS[presets::DEFAULT - 1].scene(&overrides)?),
        Some(preset) => named("--preset", preset, &overrides),
    }
}

/// Does what `lightfall presets` is asked for, and answers into `out`.
///
/// # ErrorSummary
/// A preset that does not exist, cannot be read or is wrong; or `out` cannot be written. That
/// nobody reads any more is no error.
pub fn presets(command: &PresetsCommand, out: &mut impl Write) -> Result<(), CliError> {
    let answer = match command {
        PresetsCommand::List => {
            let mut list = String::new();
            for preset in presets::PRESETS {
                list += &format!(
                    "{}  {:14} {}\n",
                    preset.number,
                    preset.name,
                    preset.scene(&[])?.title
                );
            }
            for file in own_presets() {
                list += &format!(
                    "-  {:14} {}\n",
                    file.file_stem().unwrap_or_default().display(),
                    file.display()
                );
            }
            list
        }
        PresetsCommand::Show { preset, needs } => {
            let scene = named("presets show", preset, &[])?;
            if *needs {
                crate::render::cost_report(&scene)
            } else {
                scene.to_preset()
            }
        }
        PresetsCommand::Check { file } => {
            let scene = from_file(file, &[])?;
            match GpuScene::for_rays(&scene) {
                // The reference traces on the CPU, and that is a use of a preset.
                Ok(_) | Err(GpuError::MethodOfCpu) => {}
                Err(error) => {
                    return Err(CliError::Undrawable {
                        path: file.clone(),
                        reason: error.to_string(),
                    });
                }
            }
            format!("{}: ok\n", file.display())
        }
    };
    print(&answer, out)
}

/// Writes a result; that nobody reads any more is no error.
///
/// # ErrorSummary
/// `out` cannot be written.
pub fn print(text: &str, out: &mut impl Write) -> Result<(), CliError> {
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if !is_closed_pipe(&error) => Err(CliError::Output(error)),
        _ => Ok(()),
    }
}

/// The scene of a built-in preset's number or name, else of a file; errors say who `asked`.
fn named(asked: &'static str, preset: &OsStr, overrides: &[Override]) -> Result<Scene, CliError> {
    if let Some(preset) = preset.to_str().and_then(presets::find) {
        return Ok(preset.scene(overrides)?);
    }
    let path = Path::new(preset);
    let looks_like_a_path = path.components().count() > 1 || path.extension().is_some();
    if !looks_like_a_path && !path.exists() {
        if let Some(own) = own_preset(preset) {
            return from_file(&own, overrides);
        }
        return Err(CliError::UnknownPreset {
            asked,
            given: preset.display().to_string(),
        });
    }
    from_file(path, overrides)
}

/// The user's own presets, as the panel saves them.
fn own_presets() -> Vec<PathBuf> {
    presets_folder()
        .map(|folder| preset_files(&folder))
        .unwrap_or_default()
}

/// The user's own preset of this name, as the panel saves them.
fn own_preset(name: &OsStr) -> Option<PathBuf> {
    own_presets()
        .into_iter()
        .find(|file| file.file_stem() == Some(name) && file.is_file())
}

/// The journey of a file, which all of it can be flown in `scene`; or the built-in one, which may
/// never be flown.
///
/// # ErrorSummary
/// One sentence that names the file and what is wrong with it.
pub fn journey(file: Option<&Path>, scene: &Scene) -> Result<Journey, CliError> {
    let Some(path) = file else {
        return Ok(journey::load("the built-in journey", journey::DEFAULT)?);
    };
    let journey = journey::load(&path.display().to_string(), &read_text(path)?)?;
    let checked = journey.check(scene, 0.0, Drawable::new);
    checked
        .map(|()| journey)
        .map_err(|unflyable| CliError::Unflyable {
            path: path.into(),
            unflyable,
        })
}

/// The scene of a preset file, or of the preset in a picture.
fn from_file(path: &Path, overrides: &[Override]) -> Result<Scene, CliError> {
    Ok(load(
        &path.display().to_string(),
        &read_text(path)?,
        overrides,
    )?)
}

/// The text of a file that is meant to be a short one, or of the preset in a picture.
fn read_text(path: &Path) -> Result<String, CliError> {
    let mut bytes = Vec::new();
    // Bounded, for there are files without an end.
    let read =
        File::open(path).and_then(|file| file.take(MAX_PRESET_BYTES + 1).read_to_end(&mut bytes));
    read.map_err(|error| CliError::Unreadable {
        path: path.into(),
        error,
    })?;
    if is_picture(&bytes) {
        return embedded_preset(&bytes).ok_or(CliError::NoPreset { path: path.into() });
    }
    if bytes.len() as u64 > MAX_PRESET_BYTES {
        return Err(CliError::TooLong { path: path.into() });
    }
    String::from_utf8(bytes).map_err(|_| CliError::NotText { path: path.into() })
}

fn all_presets() -> String {
    presets::PRESETS
        .map(|preset| format!("{} {}", preset.number, preset.name))
        .join(", ")
}
