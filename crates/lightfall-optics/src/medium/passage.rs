//! What reaches the camera along a ray, and how parts of its way are joined.

use super::means::{Means, Sums};
use glam::DVec3;

/// What reaches the camera along a ray.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passage {
    /// The light of the medium.
    pub light: DVec3,
    /// The optical depth of the whole way.
    pub depth: f64,
    /// Where the light comes from, if this was asked for.
    pub(super) sums: Sums,
}

impl Passage {
    /// This part of a ray's way, and the next one behind it.
    pub(super) fn followed_by(self, next: Self) -> Self {
        Self {
            light: self.light + (-self.depth).exp() * next.light,
            depth: self.depth + next.depth,
            sums: self.sums + (-self.depth).exp() * next.sums,
        }
    }

    /// Where its light comes from, on average; `None` if it has no light, or this was not asked for.
    pub fn means(&self) -> Option<Means> {
        self.sums.means()
    }

    /// Whether another result for the same way agrees.
    pub(super) fn agrees(&self, other: &Self, relative: f64) -> bool {
        let size = self.light.abs().max_element();
        let light = (self.light - other.light).abs().max_element() <= relative * size;
        let depth = (self.depth - other.depth).abs() <= relative * self.depth.max(1.0);
        light && depth
    }
}
