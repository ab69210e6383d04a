//! Which values of the keyframes change nothing in a scene.

use super::Journey;
use crate::scene::{Idle, Output, Scene};

impl Journey {
    /// What the keyframes name and what changes nothing at any of them, by its name in a keyframe,
    /// with the reason. Nothing for a camera path, whose program writes all columns of the format.
    pub fn idle_values(&self, scene: &Scene) -> Vec<(&'static str, Idle)> {
        if self.path.is_some() {
            return Vec::new();
        }
        // These tracks name all that the others do.
        let is_named = |name| self.tracks_in_rain.of(name).is_some();
        let own = [
            ("velocity", "observer.velocity", is_named("velocity")),
            ("disk_tilt_deg", "disk.tilt_deg", is_named("disk_tilt_deg")),
            ("disk_node_deg", "disk.node_deg", is_named("disk_node_deg")),
            ("disk_rate", "disk.rate", !self.clock.rates.is_empty()),
            ("disk_time", "disk.time", !self.clock.times.is_empty()),
        ];
        let set = self.fields.keys().map(|key| (key, key, true));
        let scenes: Vec<Scene> = self
            .times()
            .into_iter()
            .map(|time| self.scene_at(time, scene))
            .collect();
        let idle = own
            .into_iter()
            .chain(set)
            .filter_map(|(name, key, is_named)| {
                let mut reasons = scenes.iter().map(|there| there.idle(key, Output::Sequence));
                let first = reasons.next().flatten().filter(|_| is_named)?;
                reasons
                    .all(|reason| reason.is_some())
                    .then_some((name, first))
            });
        idle.collect()
    }

    /// The scene at the keyframe of this time.
    pub(super) fn scene_at(&self, time: f64, scene: &Scene) -> Scene {
        let mut there = scene.clone();
        self.apply(time - self.start(), &mut there);
        there
    }
}
