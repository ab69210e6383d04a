//! The GPU time of each pass.

use super::PictureError;
use super::still::Studio;
use bevy::diagnostic::DiagnosticsStore;
use bevy::prelude::*;
use lightfall_core::scene::Scene;
use lightfall_render::AlwaysDraw;
use serde::Serialize;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// GPU time of one pass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PassTime {
    /// Name of the pass.
    pub pass: String,
    /// Median over frames in which the scene is drawn, in milliseconds.
    pub median_ms: f64,
    /// Median over frames in which nothing changed and the picture is kept, in milliseconds; zero
    /// if the pass does not run in them.
    pub kept_ms: f64,
}

impl Studio {
    /// The GPU time of each pass: draws the scene `frames` more times, and then as many frames in
    /// which nothing changes. The list is empty on a device without timestamps.
    ///
    /// # Errors
    /// Drawing failed.
    pub fn time(&mut self, frames: usize) -> Result<Vec<PassTime>, PictureError> {
        self.app.world_mut().resource_mut::<AlwaysDraw>().0 = true;
        if !self.medians(1)?.is_empty() {
            self.raise_clock()?;
        }
        let drawn = self.medians(frames)?;
        self.app.world_mut().resource_mut::<AlwaysDraw>().0 = false;
        let kept = self.medians(frames)?;
        let times = drawn.into_iter().map(|(pass, median_ms)| {
            let kept_ms = kept.get(&pass).copied().unwrap_or_default();
            PassTime {
                pass,
                median_ms,
                kept_ms,
            }
        });
        Ok(times.collect())
    }

    /// Shows a scene, draws frames until it is completely drawn, and returns the names of the passes
    /// that ran in them. The list is empty on a device without timestamps. The studio must time
    /// passes.
    ///
    /// # Errors
    /// The scene cannot be drawn, or drawing failed.
    pub fn passes_to_show(&mut self, scene: &Scene) -> Result<Vec<String>, PictureError> {
        // Measurements of earlier frames arrive before.
        self.settle()?;
        self.medians(0)?;
        let begin = Instant::now();
        self.show(scene)?;
        self.settle()?;
        self.medians(0)?;
        Ok(fresh_measurements(&self.app, begin)
            .map(|(pass, _)| pass.to_owned())
            .collect())
    }

    /// Draws frames until the graphics card works at the clock of a running game.
    fn raise_clock(&mut self) -> Result<(), PictureError> {
        let begin = Instant::now();
        while begin.elapsed() < WORK_BEFORE_TIMING {
            self.update()?;
        }
        Ok(())
    }

    /// Median GPU time of each pass that runs in the next frames, in milliseconds.
    fn medians(&mut self, frames: usize) -> Result<BTreeMap<String, f64>, PictureError> {
        for _ in 0..MEASUREMENT_DELAY {
            self.update()?;
        }
        let mut samples: BTreeMap<String, Vec<f64>> = default();
        for _ in 0..frames {
            let begin = Instant::now();
            self.update()?;
            for (pass, time) in fresh_measurements(&self.app, begin) {
                samples.entry(pass.into()).or_default().push(time);
            }
        }
        let median = |mut values: Vec<f64>| {
            values.sort_by(f64::total_cmp);
            values[values.len() / 2]
        };
        Ok(samples
            .into_iter()
            .map(|(pass, values)| (pass, median(values)))
            .collect())
    }
}

/// Number of frames until the device's measurements arrive.
const MEASUREMENT_DELAY: usize = 6;

/// Time for which a scene is drawn before its passes are timed. A graphics card lowers its clock while
/// it waits for the compilation of shaders, by up to a factor of four, and raises it again within a
/// second of work.
const WORK_BEFORE_TIMING: Duration = Duration::from_secs(2);

/// The passes whose GPU time has arrived since `begin`, and the latest time of each, in milliseconds.
fn fresh_measurements(app: &App, begin: Instant) -> impl Iterator<Item = (&str, f64)> {
    let diagnostics = app.world().resource::<DiagnosticsStore>().iter();
    diagnostics.filter_map(move |diagnostic| {
        let path = diagnostic.path().as_str().strip_prefix("render/")?;
        // The measurement of a pass that no longer runs stays in the store.
        let measurement = diagnostic.measurement().filter(|last| last.time >= begin)?;
        Some((path.strip_suffix("/elapsed_gpu")?, measurement.value))
    })
}
