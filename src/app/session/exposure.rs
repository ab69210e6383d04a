//! Automatic exposure: slowly toward what the light meter says, never faster than eyes find calm.

use crate::app::controls::table::Command;
use crate::app::session::window::Preferences;
use crate::app::state::toast::Toast;
use crate::render::CurrentScene;
use bevy::prelude::*;
use lightfall_core::gpu::Drawable;
use lightfall_core::optics::exposure::metered_exposure;

/// Powers of two a second, at most.
const SLEW: f64 = 0.6;
/// Seconds between two looks at the meter.
const LOOK: f64 = 0.25;
/// Differences below this are left alone, so that a picture at rest stays at rest.
const ENOUGH: f64 = 0.05;
/// Exposures that are chosen by itself.
const RANGE: [f64; 2] = [-8.0, 8.0];

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, (switch, follow).chain());
}

fn switch(
    mut commands: MessageReader<Command>,
    mut preferences: ResMut<Preferences>,
    mut notice: ResMut<Toast>,
) {
    for _ in commands
        .read()
        .filter(|command| **command == Command::AutomaticExposure)
    {
        let settings = &mut preferences.settings;
        settings.automatic_exposure = !settings.automatic_exposure;
        notice.say(
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

fn follow(
    time: Res<Time>,
    preferences: Res<Preferences>,
    mut scene: ResMut<CurrentScene>,
    mut meter: Local<(f64, Option<f64>)>,
) {
    if !preferences.settings.follows_light() {
        return;
    }
    let (age, wanted) = &mut *meter;
    *age += time.delta_secs_f64();
    if *age > LOOK {
        (*age, *wanted) = (0.0, metered_exposure(&scene).ok().flatten());
    }
    let Some(wanted) = wanted.map(|wanted| wanted.clamp(RANGE[0], RANGE[1])) else {
        return;
    };
    let missing = wanted - scene.picture.exposure_ev;
    if missing.abs() > ENOUGH {
        let step = SLEW * time.delta_secs_f64().min(LOOK);
        let mut exposed = scene.scene().clone();
        exposed.picture.exposure_ev += missing.clamp(-step, step);
        match Drawable::new(exposed) {
            Ok(exposed) => scene.0 = exposed,
            Err(reason) => error_once!("the exposure stays as it is: {reason}"),
        }
    }
}
