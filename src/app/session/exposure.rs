//! Automatic exposure: it approaches what the light meter measures, slowly enough for the eye.

use crate::app::controls::control::AppCommand;
use crate::app::state::preferences::Preferences;
use crate::app::state::toast::Toast;
use crate::render::CurrentScene;
use bevy::prelude::*;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::exposure::metered_exposure;
use lightfall_core::scene::Scene;

/// Largest change, in powers of two per second.
const MAX_RATE: f64 = 0.6;
/// Seconds between two measurements.
const METER_INTERVAL: f64 = 0.25;
/// Smaller differences are left alone, so that a picture at rest stays at rest.
const TOLERANCE: f64 = 0.05;
/// The exposures that are chosen automatically.
const RANGE: [f64; 2] = [-8.0, 8.0];

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, (toggle_automatic_exposure, adapt_exposure).chain());
}

fn toggle_automatic_exposure(
    mut commands: MessageReader<AppCommand>,
    mut preferences: ResMut<Preferences>,
    mut toast: ResMut<Toast>,
) {
    for _ in commands
        .read()
        .filter(|command| **command == AppCommand::AutomaticExposure)
    {
        let settings = &mut preferences.settings;
        settings.automatic_exposure = !settings.automatic_exposure;
        toast.say(
            match (settings.automatic_exposure, settings.reduced_motion) {
                (false, _) => "The exposure stays as it is",
                (true, false) => "The exposure follows the light of the disk",
                (true, true) => {
                    "The exposure would follow the light, but motion is reduced in the settings"
                }
            },
        );
    }
}

/// The light meter: its last measurement, and the scene that it measured.
#[derive(Default)]
struct Meter {
    /// Seconds since the last measurement.
    age: f64,
    /// The scene without its exposure, which the meter does not read.
    scene: Option<Scene>,
    /// The exposure that suits the scene. `None` if the meter sees no disk.
    wanted: Option<f64>,
}

impl Meter {
    /// Measures again if the last measurement is old and the scene has changed since then.
    fn read(&mut self, scene: &Scene, seconds: f64) -> Option<f64> {
        self.age += seconds;
        if self.age > METER_INTERVAL {
            self.age = 0.0;
            let mut metered = scene.clone();
            metered.picture.exposure_ev = 0.0;
            if self.scene.as_ref() != Some(&metered) {
                self.wanted = metered_exposure(&metered)
                    .ok()
                    .flatten()
                    .map(|wanted| wanted.clamp(RANGE[0], RANGE[1]));
                self.scene = Some(metered);
            }
        }
        self.wanted
    }
}

fn adapt_exposure(
    time: Res<Time>,
    preferences: Res<Preferences>,
    mut scene: ResMut<CurrentScene>,
    mut meter: Local<Meter>,
) {
    if !preferences.settings.exposes_automatically() {
        return;
    }
    let Some(wanted) = meter.read(&scene, time.delta_secs_f64()) else {
        return;
    };
    let missing = wanted - scene.picture.exposure_ev;
    if missing.abs() > TOLERANCE {
        let step = MAX_RATE * time.delta_secs_f64().min(METER_INTERVAL);
        let mut exposed = scene.scene().clone();
        exposed.picture.exposure_ev += missing.clamp(-step, step);
        match Drawable::new(exposed) {
            Ok(exposed) => scene.0 = exposed,
            Err(reason) => error_once!("the exposure stays as it is: {reason}"),
        }
    }
}
