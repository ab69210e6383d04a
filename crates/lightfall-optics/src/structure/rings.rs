//! The rings that the disk is divided into, and how they overlap.

/// Maximum number of rings: a wider disk has wider rings.
pub const MAX_RINGS: usize = 16;

/// Width of a ring in ln r, where their number allows it: over it the angular velocity changes by a
/// factor of two.
const WIDTH: f64 = 0.45;

/// Rings of equal width in ln r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rings {
    /// ln r of the inner edge of the first ring.
    pub start: f64,
    /// Width in ln r, from the middle of one overlap to the middle of the next.
    pub width: f64,
    /// Number of rings.
    pub count: usize,
}

impl Rings {
    /// The rings between two radii.
    pub fn new(inner: f64, outer: f64) -> Self {
        let whole = (outer / inner).ln().max(1e-3);
        let count = (whole / WIDTH).round().clamp(1.0, MAX_RINGS as f64);
        Self {
            start: inner.ln(),
            width: whole / count,
            count: count as usize,
        }
    }

    /// ln r of the centre of a ring.
    pub fn centre(&self, ring: usize) -> f64 {
        self.start + (ring as f64 + 0.5) * self.width
    }
}
