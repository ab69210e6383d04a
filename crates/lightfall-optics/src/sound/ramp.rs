//! A value that follows another without jumps.

/// A value that comes nearer to its aim with each sample: the difference shrinks by the same factor.
pub(super) struct Ramp {
    value: f64,
    aim: f64,
    /// Share of the difference that a sample takes away.
    share: f64,
}

impl Ramp {
    /// A smaller difference is closed at once. It is far below the last bit of any device, and
    /// smaller numbers would at last be so small that processors are slow with them.
    const CLOSE: f64 = 1e-9;

    /// A value of zero whose difference from its aim shrinks to 1/e in this many seconds.
    pub(super) fn new(seconds: f64, rate: f64) -> Self {
        Self {
            value: 0.0,
            aim: 0.0,
            share: -(-1.0 / (seconds * rate)).exp_m1(),
        }
    }

    /// What to come to.
    pub(super) fn aim(&mut self, aim: f64) {
        self.aim = aim;
    }

    /// Is there at once.
    pub(super) fn jump(&mut self, aim: f64) {
        (self.value, self.aim) = (aim, aim);
    }

    /// Whether this is the value now, and stays so.
    pub(super) fn is_at(&self, value: f64) -> bool {
        self.value == value && self.aim == value
    }

    /// The value for the next sample.
    pub(super) fn next(&mut self) -> f64 {
        let missing = self.aim - self.value;
        if missing.abs() <= Self::CLOSE {
            self.value = self.aim;
        } else {
            self.value += self.share * missing;
        }
        self.value
    }
}
