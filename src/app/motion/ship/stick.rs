//! What the hand does at the ship's controls.

use glam::DVec3;

/// The hand's input in a frame. Both vectors are on the ship's axes: the nose, left, up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stick {
    /// Thrust, of length one at most: a share of the thrust that is set.
    pub thrust: DVec3,
    /// Turn about an axis, by its length in radians.
    pub turn: DVec3,
    /// Factor of the thrust by the keys.
    pub gear: f64,
}

impl Stick {
    /// Hands off.
    pub const NEUTRAL: Self = Self {
        thrust: DVec3::ZERO,
        turn: DVec3::ZERO,
        gear: 1.0,
    };
}
