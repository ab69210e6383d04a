//! Checks before a journey begins whether it can be flown in a scene.

use super::Journey;
use crate::scene::Scene;
use std::fmt::Display;
use thiserror::Error;

/// Moments that are checked from one keyframe to the next. Between two keyframes every quantity is
/// monotone, so a few moments find the places where the observer cannot exist.
const MOMENTS: u32 = 32;

/// Moments that are checked in all, unless there are more keyframes: the rows of a camera path may be close
/// to each other, and many.
const MAX_MOMENTS: u32 = 64_000;

/// Digits of radii and times in a sentence: a radius is interpolated in its logarithm, which rounds
/// its last digits.
const DIGITS: i32 = 6;

/// Where a journey cannot be flown, and why.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{place}: {reason}")]
pub struct Unflyable {
    /// The keyframe, or the two keyframes around the place; they count from 1. In a camera path, their lines.
    pub place: String,
    /// The value there, and what is allowed.
    pub reason: String,
}

impl Journey {
    /// Checks that the journey can be flown in this scene from the time `from`, in seconds after
    /// its beginning: at each keyframe, at each stop, then at moments in between. `possible` says whether a scene
    /// can be drawn.
    ///
    /// # Errors
    /// The first keyframe that is refused, or else the first stop, or else the first such moment.
    pub fn check<T, E: Display>(
        &self,
        scene: &Scene,
        from: f64,
        possible: impl Fn(Scene) -> Result<T, E>,
    ) -> Result<(), Unflyable> {
        let possible = |scene: Scene| possible(scene).map_err(|reason| reason.to_string());
        let refusal = |time: f64| {
            let mut there = self.scene_at(time, scene);
            let reason = possible(there.clone()).err()?;
            there.camera.r = rounded(there.camera.r);
            Some(possible(there).err().unwrap_or(reason))
        };
        let times = self.times();
        let ahead = |time: &f64| *time - self.start() >= from;
        for (index, &time) in times.iter().enumerate().filter(|(_, time)| ahead(time)) {
            if let Some(reason) = refusal(time) {
                return Err(Unflyable {
                    place: match &self.path {
                        Some(path) => format!("line {} (time_s = {time})", path.line(index)),
                        None => format!("keyframe {} (time = {time})", index + 1),
                    },
                    reason,
                });
            }
        }
        for (index, stop) in self.stops.iter().enumerate() {
            if let Some(reason) = refusal(stop.at).filter(|_| ahead(&stop.at)) {
                return Err(Unflyable {
                    place: format!("stop {} (at = {})", index + 1, stop.at),
                    reason,
                });
            }
        }
        let pairs = u32::try_from(times.len()).unwrap_or(u32::MAX).max(1);
        let moments = (MAX_MOMENTS / pairs).clamp(2, MOMENTS);
        for (index, pair) in times.windows(2).enumerate() {
            let (start, end) = (pair[0], pair[1]);
            // The last moment is just before the next keyframe, where the observer may change.
            let inner =
                (1..moments).map(|i| start + (end - start) * f64::from(i) / f64::from(moments));
            for moment in inner.chain([end.next_down()]).filter(ahead) {
                if let Some(reason) = refusal(moment) {
                    let time = rounded(moment);
                    let place = match &self.path {
                        Some(path) => format!(
                            "between lines {} and {} (time_s = {time})",
                            path.line(index),
                            path.line(index + 1)
                        ),
                        None => format!(
                            "between keyframes {} and {} (time = {time})",
                            index + 1,
                            index + 2
                        ),
                    };
                    return Err(Unflyable { place, reason });
                }
            }
        }
        Ok(())
    }
}

fn rounded(number: f64) -> f64 {
    let scale = 10.0_f64.powi(DIGITS - 1 - number.abs().log10().floor() as i32);
    (number * scale).round() / scale
}
