//! The rocket: how much thrust and fuel a ship has.

use thiserror::Error;

/// A rocket without stages. Fuel is counted as the rapidity that it can still give: eta, the integral
/// of the proper acceleration. With exhaust of the speed w relative to the ship, the mass falls as
/// exp(-eta/w) (Ackeret 1946).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rocket {
    /// All the rapidity that a full tank gives.
    rapidity: f64,
    /// The largest proper acceleration, in c^2/r_s.
    max_acceleration: f64,
    /// The speed of the exhaust, in c.
    exhaust: f64,
    used: f64,
}

/// Why there is no such rocket.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RocketError {
    /// A tank or an engine of another size.
    #[error("ship.{field} is {value}; it must be a finite number, not negative")]
    Size {
        /// Which of them.
        field: &'static str,
        /// Its size.
        value: f64,
    },
    /// Exhaust that is not slower than light, or stands still.
    #[error("ship.exhaust is {0}; it must be above 0 and at most 1, the speed of light")]
    Exhaust(f64),
}

impl Rocket {
    /// A rocket with a full tank.
    ///
    /// # Errors
    /// There is no such rocket.
    pub fn new(rapidity: f64, max_acceleration: f64, exhaust: f64) -> Result<Self, RocketError> {
        for (field, value) in [("rapidity", rapidity), ("acceleration", max_acceleration)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(RocketError::Size { field, value });
            }
        }
        if !(exhaust > 0.0 && exhaust <= 1.0) {
            return Err(RocketError::Exhaust(exhaust));
        }
        Ok(Self {
            rapidity,
            max_acceleration,
            exhaust,
            used: 0.0,
        })
    }

    /// The largest acceleration of the engine now, in c^2/r_s: none without fuel.
    pub fn max_acceleration(&self) -> f64 {
        if self.left() > 0.0 {
            self.max_acceleration
        } else {
            0.0
        }
    }

    /// The rapidity spent so far.
    pub fn used(&self) -> f64 {
        self.used
    }

    /// The rapidity that is left.
    pub fn left(&self) -> f64 {
        self.rapidity - self.used
    }

    /// The ship's mass over that with a full tank.
    pub fn mass(&self) -> f64 {
        (-self.used / self.exhaust).exp()
    }

    /// For how long the fuel lasts at this acceleration, in r_s/c.
    pub fn time_left(&self, acceleration: f64) -> f64 {
        if acceleration > 0.0 {
            self.left() / acceleration
        } else {
            f64::INFINITY
        }
    }

    /// Spends this much rapidity, or what is left.
    pub fn spend(&mut self, rapidity: f64) {
        // What rounding leaves in a tank is nothing.
        const REST: f64 = 1e-14;
        self.used += rapidity;
        if self.left() <= REST * self.rapidity {
            self.used = self.rapidity;
        }
    }
}
