//! A hot spot in the disk: its place at a time. shaders/disk/hot_spot/spot.wgsl gives its flux.

use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_model::scene::{self, HotSpotKind, Scene};
use std::f64::consts::TAU;

/// The finest structure of a sheared spot, as a share of the radius.
///
/// A sheared spot becomes an arc that winds up and gets ever thinner. In a real disk turbulence
/// mixes thin windings, and neither a picture nor f32 could resolve them. So orbits within this
/// share of the radius are mixed: the arc gets no thinner, its windings fade into each other, and
/// after some ten orbits a ring is left. The mean along each orbit does not change.
pub const FINEST_SHEARED: f64 = 0.02;

/// The scene's hot spot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HotSpot {
    spot: scene::HotSpot,
    angular_velocity: f64,
}

impl HotSpot {
    /// The scene's hot spot; `None` if it has none, or if no matter can orbit there.
    pub fn new(scene: &Scene) -> Option<Self> {
        let there = scene.drawn_hot_spot() != HotSpotKind::None;
        let orbit = there.then(|| scene.kerr().circular_orbit(scene.hot_spot.r));
        Some(Self {
            spot: scene.hot_spot,
            angular_velocity: orbit.flatten()?.angular_velocity,
        })
    }

    /// Radius of the spot's middle, in r_s.
    pub fn r(&self) -> f64 {
        self.spot.r
    }

    /// Angular velocity of the spot's middle, in radians per r_s/c.
    pub fn angular_velocity(&self) -> f64 {
        self.angular_velocity
    }

    /// The period of the spot's middle, in r_s/c.
    pub fn period(&self) -> f64 {
        TAU / self.angular_velocity
    }

    /// Boyer-Lindquist azimuth of the spot's middle at the Boyer-Lindquist time `t` (r_s/c), in
    /// (-pi, pi].
    pub fn azimuth(&self, t: f64) -> f64 {
        let turned = self.angular_velocity * (t - self.spot.time);
        wrap_angle(self.spot.phi_deg.to_radians() + turned)
    }
}
