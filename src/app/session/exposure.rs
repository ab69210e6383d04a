//! Automatic exposure during flights: it follows the light meter smoothly. Every other change of the
//! scene is metered at once ([`SceneEditor`](crate::app::state::scene_editor::SceneEditor)), so that
//! no switch leaves the picture black or white.

use crate::app::state::preferences::Preferences;
use crate::app::state::resolution::Resolution;
use bevy::prelude::*;
use lightfall_core::optics::exposure::metered_exposure;
use lightfall_core::scene::{Frame, Scene};
use lightfall_render::CurrentScene;

/// Seconds in which the difference from the metered exposure shrinks to 1/e. After a second nothing
/// is left even of the largest difference, and a smaller one looks like an eye adapting.
const FOLLOW_SECONDS: f64 = 0.2;
/// Seconds between two measurements.
const METER_INTERVAL: f64 = 0.1;
/// Largest time that counts for one frame, in seconds.
const MAX_FRAME_SECONDS: f64 = 0.25;
/// A smaller difference, in powers of two, shows nowhere and is closed at once: the exposure of a
/// picture at rest is the meter's own, whatever came before.
const TOLERANCE: f64 = 0.02;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, follow_light);
}

/// The light meter: its last measurement, and the scene that it measured.
#[derive(Default)]
pub struct Meter {
    /// Seconds since the last measurement.
    age: f64,
    /// The scene that was measured, without its exposure.
    scene: Option<Scene>,
    /// The exposure that suits the scene. `None` if the meter sees no light.
    wanted: Option<f64>,
}

impl Meter {
    /// The exposure of a scene with automatic exposure after `seconds` more. `None` where it stays
    /// as it is.
    pub fn follow(&mut self, scene: &Scene, seconds: f64) -> Option<f64> {
        let now = scene.picture.exposure_ev;
        self.age += seconds;
        if self.age > METER_INTERVAL {
            // The light meter does not see what moves in the disk.
            let mut metered = scene.without_presentation().without_clock();
            metered.picture.exposure_ev = 0.0;
            if self.scene.as_ref() != Some(&metered) {
                self.wanted = metered_exposure(scene).ok().flatten();
                (self.scene, self.age) = (Some(metered), 0.0);
            }
        }
        let wanted = self.wanted?;
        let missing = wanted - now;
        if missing.abs() <= TOLERANCE {
            return (missing != 0.0).then_some(wanted);
        }
        let share = 1.0 - (-seconds.min(MAX_FRAME_SECONDS) / FOLLOW_SECONDS).exp();
        Some(now + share * missing)
    }
}

fn follow_light(
    time: Res<Time>,
    preferences: Res<Preferences>,
    resolution: Res<Resolution>,
    mut scene: ResMut<CurrentScene>,
    mut meter: Local<Meter>,
) {
    if !scene.picture.automatic_exposure || preferences.settings.reduced_motion {
        *meter = Meter::default();
        return;
    }
    // Not at the resolution that is drawn: a change of the exposure would change the resolution, and
    // a coarser picture is metered a little differently.
    let metered = resolution.scene_in_window(&scene);
    let Some(exposure) = meter.follow(&metered, time.delta_secs_f64()) else {
        return;
    };
    let frame = Frame {
        exposure_ev: exposure,
        ..Frame::of(&scene)
    };
    scene.show_in(&frame);
}
