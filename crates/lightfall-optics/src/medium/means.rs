//! Where the light of a way through matter comes from, on average.

use glam::{DVec3, DVec4};
use std::ops::{Add, Mul};

/// The luminance of linear sRGB (ITU-R BT.709-6, item 3.2).
const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// Means over the places where light was emitted, weighted by the luminance that reaches the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Means {
    /// Radius, in r_s.
    pub r: f64,
    /// Height r cos(theta) above the disk's plane, in r_s.
    pub height: f64,
    /// Observed over emitted frequency, with every effect.
    pub g: f64,
    /// Time from the emission to the arrival, in r_s/c: [`Lag`](crate::delay::Lag).
    pub delay: f64,
}

/// Sums over places: their luminance, and the values of [`Means`] multiplied by it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Sums {
    luminance: f64,
    values: DVec4,
}

impl Sums {
    /// A place that emits this light.
    pub fn of(light: DVec3, at: &Means) -> Self {
        let luminance = LUMINANCE.dot(light);
        let values = DVec4::new(at.r, at.height, at.g, at.delay);
        Self {
            luminance,
            values: luminance * values,
        }
    }

    /// The luminance.
    pub fn luminance(&self) -> f64 {
        self.luminance
    }

    /// The means; `None` without light.
    pub fn means(&self) -> Option<Means> {
        let [r, height, g, delay] = (self.values / self.luminance).to_array();
        (self.luminance > 0.0).then_some(Means {
            r,
            height,
            g,
            delay,
        })
    }
}

impl Add for Sums {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            luminance: self.luminance + other.luminance,
            values: self.values + other.values,
        }
    }
}

impl Mul<Sums> for f64 {
    type Output = Sums;

    fn mul(self, sums: Sums) -> Sums {
        Sums {
            luminance: self * sums.luminance,
            values: self * sums.values,
        }
    }
}
