//! A soft limit for the sum of the voices.

/// No sample is above this, where 1 is the most that a device can play.
pub const CEILING: f64 = 0.95;

/// Below this a sample stays as it is.
const KNEE: f64 = 0.6;

/// The sample, bent so that it stays below [`CEILING`]: the identity up to 0.6, and beyond it a
/// hyperbolic tangent that continues it with the same slope. So the sum of loud voices does not
/// crackle, and voices that are not loud are not distorted.
pub fn limited(sample: f64) -> f64 {
    let beyond = sample.abs() - KNEE;
    if beyond <= 0.0 {
        return sample;
    }
    let room = CEILING - KNEE;
    (KNEE + room * (beyond / room).tanh()).copysign(sample)
}
