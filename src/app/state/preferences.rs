//! The settings as a resource, kept in their file.

use super::settings::Settings;
use super::toast::Toast;
use crate::app::controls::bindings::{Bindings, PadBindings};
use crate::app::controls::key_labels::KeyLabels;
use bevy::prelude::*;
use lightfall_platform::storage::settings_file;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The settings, and the file that they are kept in.
#[derive(Resource)]
pub struct Preferences {
    /// The settings.
    pub settings: Settings,
    /// The settings as they are in the file.
    saved: Settings,
    /// Where they are saved. None if this system has no folder for settings, or if the file is of a
    /// newer version.
    file: Option<PathBuf>,
    /// When they were last seen to differ from the file, as a time since the start.
    changed: Option<Duration>,
}

/// Settings are written this long after their first change.
const SAVE_DELAY: Duration = Duration::from_secs(1);

impl Preferences {
    /// Reads the settings. The second value says what was wrong with the file.
    pub(crate) fn load() -> (Self, Option<String>) {
        let file = settings_file();
        let (settings, unused) = file
            .as_deref()
            .map_or_else(Default::default, Settings::load);
        let stays = unused.as_ref().is_some_and(|unused| unused.stays);
        (
            Self::new(settings, file.filter(|_| !stays)),
            unused.map(|unused| unused.sentence),
        )
    }

    fn new(settings: Settings, file: Option<PathBuf>) -> Self {
        Self {
            saved: settings.clone(),
            settings,
            file,
            changed: None,
        }
    }

    /// Reads the settings for a window for visitors, and leaves their file as it is, whatever they do. The
    /// second value says what was wrong with the file. `volume` takes the place of the settings' own, and no
    /// keys are named for good.
    pub(crate) fn for_visitors(volume: f64) -> (Self, Option<String>) {
        let file = settings_file();
        let read = file.as_deref().map_or(Ok(None), Settings::read_file);
        let fault = read.as_ref().err().map(|fault| {
            let file = file.as_deref().unwrap_or(Path::new("the settings"));
            format!("{}: {fault}; default settings are used", file.display())
        });
        let settings = Settings {
            volume,
            key_hints: false,
            keep_key_hints: true,
            ..read.ok().flatten().unwrap_or_default()
        };
        (Self::new(settings, None), fault)
    }

    fn save(&mut self) -> Result<(), String> {
        self.changed = None;
        if self.settings == self.saved {
            return Ok(());
        }
        self.saved = self.settings.clone();
        self.file
            .as_deref()
            .map_or(Ok(()), |file| self.settings.save(file))
    }
}

/// Adds the settings and the bindings in them, on a keyboard of this layout, and keeps them in their
/// file. Both were checked when the file was read, but a layout may bring two keys together: the
/// sentence says which.
pub(crate) fn insert(
    app: &mut App,
    preferences: Preferences,
    labels: &KeyLabels,
) -> Option<String> {
    let bound = Bindings::new(&preferences.settings.keys, labels);
    let clash = bound.as_ref().err().map(|clash| {
        format!("{clash}: on this keyboard's layout every control has its usual keys")
    });
    let bindings = bound.unwrap_or_else(|_| Bindings::with_defaults(labels));
    let pad_bindings = PadBindings::new(&preferences.settings.buttons, labels).unwrap_or_default();
    app.insert_resource(preferences)
        .insert_resource(bindings)
        .insert_resource(pad_bindings)
        .add_systems(Update, (take_in_bindings, save_settings).chain())
        .add_systems(Last, save_settings_at_exit);
    clash
}

fn take_in_bindings(
    mut preferences: ResMut<Preferences>,
    bindings: Res<Bindings>,
    pad_bindings: Res<PadBindings>,
) {
    if bindings.is_changed() && !bindings.is_added() {
        preferences.settings.keys = bindings.settings();
    }
    if pad_bindings.is_changed() && !pad_bindings.is_added() {
        preferences.settings.buttons = pad_bindings.settings();
    }
}

fn save_settings(
    time: Res<Time<Real>>,
    mut preferences: ResMut<Preferences>,
    mut toast: ResMut<Toast>,
) {
    if preferences.settings == preferences.saved {
        return;
    }
    let now = time.elapsed();
    if now > *preferences.changed.get_or_insert(now) + SAVE_DELAY
        && let Err(fault) = preferences.save()
    {
        toast.say(fault);
    }
}

fn save_settings_at_exit(mut exits: MessageReader<AppExit>, mut preferences: ResMut<Preferences>) {
    if exits.read().next().is_some()
        && let Err(fault) = preferences.save()
    {
        error!("{fault}");
    }
}
