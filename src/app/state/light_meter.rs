//! The light meter, which chooses the exposure of scenes with automatic exposure.

use super::MAX_FRAME_SECONDS;
use bevy::prelude::Resource;
use lightfall_core::optics::exposure::{metered_exposure, roughly_metered_exposure};
use lightfall_core::scene::Scene;

/// Seconds in which the difference from the metered exposure shrinks to 1/e. After a second nothing
/// is left even of the largest difference, and a smaller one looks like an eye adapting.
const FOLLOW_SECONDS: f64 = 0.2;
/// Seconds between two measurements.
const METER_INTERVAL: f64 = 0.1;
/// A smaller difference, in powers of two, is invisible and is closed at once, so that the exposure
/// of a picture at rest does not depend on earlier scenes.
const TOLERANCE: f64 = 0.02;

/// The exposure that the light meter has chosen, its last measurement, and the scene that it
/// measured.
#[derive(Resource, Default)]
pub(crate) struct LightMeter {
    exposure_ev: f64,
    /// Seconds since the last measurement.
    age: f64,
    /// The scene that was measured, without its exposure.
    scene: Option<Scene>,
    /// Whether it was measured again, with more rays, after it had stopped to move.
    at_rest: bool,
    /// The exposure that suits the scene. `None` before the first measurement.
    wanted: Option<f64>,
}

impl LightMeter {
    /// A meter that has chosen this exposure.
    pub(crate) fn at(exposure_ev: f64) -> Self {
        Self {
            exposure_ev,
            ..Self::default()
        }
    }

    /// The exposure in which a scene is shown: the meter's, or its own.
    pub(crate) fn exposure_of(&self, scene: &Scene) -> f64 {
        if scene.picture.automatic_exposure {
            self.exposure_ev
        } else {
            scene.picture.exposure_ev
        }
    }

    /// The exposure that it has chosen.
    #[cfg(feature = "sound")]
    pub(crate) fn chosen(&self) -> f64 {
        self.exposure_ev
    }

    /// Chooses an exposure, from which it goes on.
    pub(crate) fn set(&mut self, exposure_ev: f64) {
        self.exposure_ev = exposure_ev;
    }

    /// Forgets what it has measured.
    pub(crate) fn forget(&mut self) {
        *self = Self::at(self.exposure_ev);
    }

    /// Comes nearer to the exposure that suits a scene, for `seconds`.
    pub(crate) fn follow(&mut self, scene: &Scene, seconds: f64) {
        self.age += seconds;
        if self.age > METER_INTERVAL && scene.view.shows_light() {
            // The light meter does not see what moves in the disk.
            let mut metered = scene.without_presentation().without_clock();
            metered.picture.exposure_ev = 0.0;
            let rests = self.scene.as_ref() == Some(&metered);
            if !(rests && self.at_rest) {
                let measured = if rests {
                    metered_exposure(scene)
                } else {
                    roughly_metered_exposure(scene)
                };
                // Where nothing is seen, the scene's own exposure counts.
                let own = scene.picture.exposure_ev;
                self.wanted = measured.ok().map(|metered| metered.unwrap_or(own));
                (self.scene, self.at_rest, self.age) = (Some(metered), rests, 0.0);
            }
        }
        let Some(wanted) = self.wanted else {
            return;
        };
        let missing = wanted - self.exposure_ev;
        if missing.abs() <= TOLERANCE {
            self.exposure_ev = wanted;
        } else {
            let share = 1.0 - (-seconds.min(MAX_FRAME_SECONDS) / FOLLOW_SECONDS).exp();
            self.exposure_ev += share * missing;
        }
    }
}
