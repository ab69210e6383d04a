//! The clock of a disk that moves, or of jets: whether anything moves, and how its time goes on while a camera
//! is moved from place to place.

use super::{DiskStructure, HotSpotKind, Scene};

impl Scene {
    /// Whether something moves in the scene, so that its picture depends on `disk.time`.
    pub fn disk_moves(&self) -> bool {
        let in_disk = self.disk.structure != DiskStructure::None
            || self.drawn_hot_spot() != HotSpotKind::None;
        self.disk.enabled && in_disk || self.jets_move()
    }

    /// Whether the picture shows that motion. Views of rays and of shifts show no light of the
    /// disk, and do not depend on `disk.time`.
    pub fn shows_disk_motion(&self) -> bool {
        self.disk_moves() && self.shows_sources()
    }

    /// The scene with the default `disk.time`, so that two scenes compare equal if only the disk's
    /// clock has gone on.
    #[must_use]
    pub fn without_clock(&self) -> Self {
        let mut scene = self.clone();
        scene.disk.time = Self::default().disk.time;
        scene
    }

    /// By how much the clock of a camera at the radius `r` (r_s) has to be ahead, in r_s/c, so that
    /// two cameras see the disk at the same stage. Only differences count.
    ///
    /// Outside the photon orbit it is the tortoise coordinate r*: light on its way out keeps t -
    /// r*. Inside the photon orbit nearly all of the disk's light is on its way in, and keeps the
    /// ingoing time t + r*, which is also the camera's own time at and inside the horizon. Without
    /// lensing light keeps t - r.
    pub fn disk_time_lead(&self, r: f64) -> f64 {
        let kerr = self.kerr();
        if !self.effects.lensing {
            return r;
        }
        let turn = kerr.photon_orbit_polar();
        if r >= turn {
            return kerr.ingoing_time_lead(r);
        }
        2.0 * kerr.ingoing_time_lead(turn) - kerr.camera_time_lead(r)
    }
}
