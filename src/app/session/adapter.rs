//! The graphics adapter that the settings name. A choice takes effect at the next start. If the
//! program did not draw a picture with the adapter, the choice is dropped, so that no choice locks
//! the user out.

use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use bevy::render::renderer::RenderAdapterInfo;
use lightfall_core::gpu;
use lightfall_core::gpu::AdapterName;
use lightfall_platform::storage::{exists, remove, settings_file, write_atomically};
use lightfall_render::Progress;
use std::path::PathBuf;

/// The use of the settings' adapter in this run.
#[derive(Resource, Default)]
pub(crate) struct AdapterChoice {
    /// The adapter that the renderer was asked to use.
    pub(crate) used: Option<AdapterName>,
    /// The file that exists while it is not known whether that adapter works.
    trial: Option<PathBuf>,
}

impl AdapterChoice {
    /// Prefers the adapter of the settings. Must be called before anything opens a device. The
    /// second value says why the adapter is not used. Without a trial, no file is touched.
    pub(crate) fn apply(preferences: &mut Preferences, has_trial: bool) -> (Self, Option<String>) {
        let Some(wanted) = preferences.settings.adapter.clone() else {
            return (Self::default(), None);
        };
        if gpu::named_by_environment().is_some() {
            return (Self::default(), None);
        }
        let unused = |news: String| (Self::default(), Some(news));
        let file = settings_file().filter(|_| has_trial);
        let trial = file.map(|file| file.with_file_name("adapter-on-trial"));
        if let Some(trial) = trial.as_ref().filter(|trial| exists(trial)) {
            preferences.settings.adapter = None;
            return match remove(trial) {
                Ok(()) => unused(format!(
                    "Lightfall did not draw a picture with {wanted} at its last start, so it uses the best adapter"
                )),
                Err(error) => unused(format!(
                    "{wanted} is not used: {}: {error}",
                    trial.display()
                )),
            };
        }
        if gpu::adapters().iter().all(|listed| listed.name != wanted) {
            return unused(format!(
                "The settings name {wanted}, which was not found; the best adapter is used"
            ));
        }
        // A system that has no folder for this file has no folder for settings either.
        let trial =
            trial.filter(|trial| write_atomically(trial, wanted.to_string().as_bytes()).is_ok());
        gpu::prefer(Some(wanted.clone()));
        let used = Some(wanted);
        (Self { used, trial }, None)
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Startup, compare_adapters)
        .add_systems(Last, end_adapter_trial);
}

/// Reports that the renderer uses another adapter because the wanted one cannot show this window.
fn compare_adapters(
    choice: Res<AdapterChoice>,
    present: Option<Res<RenderAdapterInfo>>,
    mut toast: ResMut<Toast>,
) {
    let Some((wanted, present)) = choice
        .used
        .clone()
        .zip(present.map(|info| AdapterName::of(&info)))
    else {
        return;
    };
    if present != wanted {
        let news =
            format!("The settings name {wanted}, which cannot show this window; {present} is used");
        warn!("{news}");
        toast.add(&news);
    }
}

/// Ends the trial when a picture is drawn: the adapter works. A window that is closed earlier does
/// not count as a failure.
fn end_adapter_trial(
    mut choice: ResMut<AdapterChoice>,
    progress: Res<Progress>,
    mut exits: MessageReader<AppExit>,
) {
    let closed = exits.read().any(AppExit::is_success);
    if choice.trial.is_some()
        && (closed || progress.is_shown())
        && let Some(trial) = choice.trial.take()
        && let Err(error) = remove(&trial)
    {
        warn!("{}: {error}", trial.display());
    }
}
