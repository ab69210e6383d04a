//! Motion blur: the mean of the light at several moments while a shutter is open.

use super::{Captured, Channels, PictureError, Sequence, Still, Studio};
use exr::prelude::f16;
use lightfall_core::numbers::number_with_comma;
use lightfall_core::scene::Scene;

/// The moments of a frame whose scene asks for one sample alone.
const DEFAULT_MOMENTS: u32 = 16;

/// Reads how long a shutter is open, as a share of the time from one frame to the next.
///
/// # Errors
/// The text is no number, or not above 0 and up to 1.
pub fn shutter_time(text: &str) -> Result<f64, String> {
    let is_allowed = |share: f64| share > 0.0 && share <= 1.0;
    let share = text.parse().ok().filter(|share: &f64| is_allowed(*share));
    share.ok_or_else(|| {
        let allowed = "it must be a number above 0 and up to 1, as a share of the time from one frame to the next";
        match number_with_comma(text, is_allowed) {
            Some(meant) => format!("{allowed}; did you mean {meant}?"),
            None => allowed.into(),
        }
    })
}

/// The scenes of a frame at moments that are evenly spread over the time in which the shutter is open. It
/// opens at the frame's own moment. There are as many as the scene has samples, or 16 if it has one; each
/// is drawn with one sample.
#[must_use]
pub fn moments(sequence: &Sequence, scene: &Scene, number: u32, shutter: f64) -> Vec<Scene> {
    let frame = f64::from(number);
    let own = sequence.scene_at(scene, frame);
    let count = match own.picture.samples {
        0 | 1 => DEFAULT_MOMENTS,
        samples => samples,
    };
    let moment = |index: u32| {
        let share = (f64::from(index) + 0.5) / f64::from(count);
        let mut then = sequence.scene_at(scene, frame + shutter * share);
        then.picture.samples = 1;
        then
    };
    (0..count).map(moment).collect()
}

impl Studio {
    /// The picture that a window would show of this light of a scene, in which the foreground is already.
    /// The scene has the exposure that was metered. It stays shown.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn developed(&mut self, scene: &Scene, light: &Captured) -> Result<Still, PictureError> {
        let mut developed = scene.clone();
        developed.picture.automatic_exposure = false;
        (developed.probe.enabled, developed.picture.samples) = (false, 1);
        let halves = light.rgba.iter().flatten();
        let bytes = halves.flat_map(|half| half.to_le_bytes()).collect();
        self.show(&developed)?;
        self.give_light(Some(bytes));
        let still = self.settle().and_then(|()| self.picture());
        self.give_light(None);
        still
    }

    /// The mean of the light of some scenes, and of the numbers of the layers that the channels name. The
    /// studio must keep light. The last scene stays shown.
    ///
    /// # Errors
    /// There is no scene, or drawing failed.
    pub fn mean_light(
        &mut self,
        moments: &[Scene],
        channels: &Channels,
    ) -> Result<(Captured, Vec<Vec<f32>>), PictureError> {
        let mut size = None;
        let mut light: Vec<[f32; 4]> = Vec::new();
        let mut layers: Vec<Vec<f32>> = Vec::new();
        let weight = 1.0 / moments.len().max(1) as f32;
        for moment in moments {
            self.show(moment)?;
            let seen = self.light()?;
            size = Some(seen.size);
            light.resize(seen.rgba.len(), [0.0; 4]);
            for (sum, pixel) in light.iter_mut().zip(&seen.rgba) {
                for (sum, bits) in sum.iter_mut().zip(pixel) {
                    *sum += weight * f16::from_bits(*bits).to_f32();
                }
            }
            let numbers = self.layers(channels)?;
            layers.resize(numbers.len(), Vec::new());
            for (sums, numbers) in layers.iter_mut().zip(numbers) {
                sums.resize(numbers.len(), 0.0);
                for (sum, number) in sums.iter_mut().zip(numbers) {
                    *sum += weight * number;
                }
            }
        }
        let size = size.ok_or(PictureError::Draw("no moment of it is drawn".into()))?;
        let half = |number: f32| f16::from_f32(number).to_bits();
        let mean = Captured {
            size,
            rgba: light.into_iter().map(|pixel| pixel.map(half)).collect(),
            depth: None,
        };
        Ok((mean, layers))
    }
}
