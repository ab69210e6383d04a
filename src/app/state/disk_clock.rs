//! The disk's clock, which the motions drive.

use super::MAX_FRAME_SECONDS;
use bevy::prelude::Resource;
use lightfall_core::scene::Scene;

/// The disk's clock, and the scene for which it was read last.
#[derive(Resource, Clone, Debug, Default)]
pub struct DiskClock {
    /// Time at the camera, in r_s/c.
    time: f64,
    last: Option<Reading>,
}

/// The scene as the clock has left it.
#[derive(Clone, Debug)]
struct Reading {
    name: String,
    time: f64,
    r: f64,
}

impl DiskClock {
    /// A clock that shows this time.
    #[must_use]
    pub fn at(time: f64) -> Self {
        Self { time, last: None }
    }

    /// The time that it shows, in r_s/c.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Sets it to a time, from which it goes on.
    pub fn set(&mut self, time: f64) {
        self.time = time;
    }

    /// Goes on by `seconds` from the scene's `disk.time`, and returns the time then; what exceeds
    /// the longest frame does not count. Where the camera has been moved since the last call, the
    /// disk is seen at the same stage as before. A time that something else has set is kept, and a
    /// scene that was loaded begins at its own.
    pub fn advance(&mut self, seconds: f64, scene: &Scene) -> f64 {
        let mut time = scene.disk.time;
        if let Some(last) = &self.last
            && (last.time, &last.name) == (time, &scene.name)
            && last.r != scene.camera.r
        {
            time += scene.disk_time_lead(scene.camera.r) - scene.disk_time_lead(last.r);
        }
        time += scene.disk.rate * seconds.min(MAX_FRAME_SECONDS);
        self.note(scene, time);
        time
    }

    /// Notes that something else drives the clock.
    pub fn follow(&mut self, scene: &Scene) {
        self.note(scene, scene.disk.time);
    }

    fn note(&mut self, scene: &Scene, time: f64) {
        self.time = time;
        self.last = Some(Reading {
            name: scene.name.clone(),
            time,
            r: scene.camera.r,
        });
    }
}
