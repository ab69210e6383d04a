//! Conditions on the quantities of a flight.

use crate::scene::nearest_name;
use serde::Deserialize;

crate::words! {
    /// What a condition compares. Lengths are in r_s and times in r_s/c, where the name has no unit.
    pub enum Quantity {
        /// Boyer-Lindquist radius.
        R = "r",
        /// Polar angle, in degrees.
        ThetaDeg = "theta_deg",
        /// The ship's own time since the start.
        Tau = "tau",
        /// The time of clocks far away since the start.
        T = "t",
        /// The ship's own time, in years, for the mission's mass.
        TauYears = "tau_years",
        /// The time of clocks far away, in years.
        TYears = "t_years",
        /// How much time passes far away per own time.
        Rate = "rate",
        /// The energy per mass, E.
        Energy = "E",
        /// The angular momentum about the axis per mass, L.
        AngularMomentum = "L",
        /// Carter's constant per mass squared, Q.
        CarterQ = "Q",
        /// The lowest radius if the ship only coasts; zero if it falls in.
        Periapsis = "periapsis",
        /// The highest radius if the ship only coasts; infinite if it comes away.
        Apoapsis = "apoapsis",
        /// Turns about the axis since the start, of either sense.
        Turns = "turns",
        /// Speed relative to the observer with zero angular momentum, in c.
        Speed = "speed",
        /// Speed relative to the gas of a disk in the hole's equator, in c; only in that plane.
        GasSpeed = "gas_speed",
        /// Proper acceleration, in c^2/r_s.
        Thrust = "thrust",
        /// Rapidity spent.
        RapidityUsed = "rapidity_used",
        /// How far the ship was turned against its gyroscopes, in degrees.
        RotationUsedDeg = "rotation_used_deg",
        /// Mass times E, over the same at the start.
        EnergyRatio = "energy_ratio",
        /// The own time from the horizon to the centre if the ship falls on without thrust. Around a
        /// hole that spins, the own time since the horizon.
        LifeInside = "life_inside",
        /// The largest tidal stretching, in c^2/r_s^2.
        Tide = "tide",
        /// Proper acceleration in g, for the mission's mass.
        GLoad = "g_load",
    }
}

/// How a quantity is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    AtMost,
    /// `>`
    More,
    /// `>=`
    AtLeast,
    /// `==`
    Equal,
}

/// The signs, those of two characters first.
const SIGNS: [(&str, Comparison); 5] = [
    ("<=", Comparison::AtMost),
    (">=", Comparison::AtLeast),
    ("==", Comparison::Equal),
    ("<", Comparison::Less),
    (">", Comparison::More),
];

/// A condition, such as `r <= 1.6`.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "String")]
pub struct Condition {
    /// What is compared.
    pub quantity: Quantity,
    /// How.
    pub comparison: Comparison,
    /// With what.
    pub value: f64,
}

impl Condition {
    /// Whether the condition holds for this value of its quantity. A quantity that is not known where
    /// the ship is meets no condition.
    pub fn holds(&self, quantity: Option<f64>) -> bool {
        let Some(quantity) = quantity else {
            return false;
        };
        match self.comparison {
            Comparison::Less => quantity < self.value,
            Comparison::AtMost => quantity <= self.value,
            Comparison::More => quantity > self.value,
            Comparison::AtLeast => quantity >= self.value,
            Comparison::Equal => quantity == self.value,
        }
    }
}

impl TryFrom<String> for Condition {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let form = || format!("{text:?} is not a condition such as \"r <= 1.6\"");
        let (sign, comparison) = SIGNS
            .into_iter()
            .find(|(sign, _)| text.contains(sign))
            .ok_or_else(form)?;
        let (name, value) = text.split_once(sign).ok_or_else(form)?;
        let name = name.trim();
        let quantity = Quantity::from_word(name).ok_or_else(|| {
            let known = Quantity::WORDS.join(", ");
            match nearest_name(name, &Quantity::WORDS) {
                Some(meant) => {
                    format!("{text:?} names no quantity of a flight; did you mean {meant}?")
                }
                None => format!("{text:?} names no quantity of a flight: these are {known}"),
            }
        })?;
        let value = value
            .trim()
            .parse()
            .ok()
            .filter(|value: &f64| value.is_finite());
        Ok(Self {
            quantity,
            comparison,
            value: value.ok_or_else(form)?,
        })
    }
}
