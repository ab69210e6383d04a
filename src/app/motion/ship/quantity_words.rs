//! The quantities of a flight in words: their names, and their values with units.

use lightfall_core::numbers::{YEAR, duration_in_words, four_digits, percent, three_digits};
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::scene::mission::{Mission, Quantity};

/// What the values of a mission's quantities are written with: the units of texts, the mass of its hole, and
/// the rapidity of its full tank.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measures {
    units: Units,
    mass: HoleMass,
    tank: f64,
}

impl Measures {
    /// Those of a mission.
    pub(crate) fn new(mission: &Mission, units: Units) -> Self {
        Self {
            units,
            mass: HoleMass::of_suns(mission.hole.mass_suns),
            tank: mission.ship.rapidity,
        }
    }

    /// A value with its unit. `digits` writes its number, except where the size alone counts.
    pub(crate) fn amount(
        self,
        quantity: Quantity,
        value: f64,
        digits: impl Fn(f64) -> String,
    ) -> String {
        let Self { units, mass, tank } = self;
        match quantity {
            Quantity::R | Quantity::Periapsis | Quantity::Apoapsis => units.length(value, digits),
            Quantity::Tau | Quantity::T | Quantity::LifeInside => units.time(value, digits),
            Quantity::TauYears | Quantity::TYears => duration_in_words(value * YEAR),
            Quantity::ThetaDeg | Quantity::RotationUsedDeg => format!("{}°", digits(value)),
            Quantity::Speed | Quantity::GasSpeed => format!("{} c", digits(value)),
            Quantity::Thrust => acceleration(value, mass, units),
            Quantity::GLoad => format!("{} g", digits(value)),
            Quantity::Tide if units.are_simple() => tide(value, mass),
            Quantity::Tide => format!("{} c²/r_s²", digits(value)),
            Quantity::RapidityUsed => fuel(value, tank, digits),
            Quantity::Rate
            | Quantity::Energy
            | Quantity::AngularMomentum
            | Quantity::CarterQ
            | Quantity::Turns
            | Quantity::EnergyRatio => digits(value),
        }
    }

    /// A value in few words: of fuel the share of the tank alone.
    pub(crate) fn short_amount(self, quantity: Quantity, value: f64) -> String {
        match quantity {
            Quantity::RapidityUsed => of_tank(value, self.tank),
            _ => self.amount(quantity, value, four_digits),
        }
    }
}

/// Fuel as a share of the tank and, for those who calculate, as the rapidity that it gives.
pub(crate) fn fuel(rapidity: f64, tank: f64, digits: impl Fn(f64) -> String) -> String {
    let share = of_tank(rapidity, tank);
    format!("{share} (rapidity {})", digits(rapidity))
}

/// A rapidity as a share of that of a full tank. Without a tank there is no fuel.
fn of_tank(rapidity: f64, tank: f64) -> String {
    percent(if tank > 0.0 { rapidity / tank } else { 0.0 })
}

/// An acceleration in c^2/r_s, and in g.
pub(crate) fn acceleration(size: f64, mass: HoleMass, units: Units) -> String {
    let gees = format!("{} g", three_digits(size * mass.gees()));
    match units.are_simple() {
        true => gees,
        false => format!("{} c²/r_s · {gees}", three_digits(size)),
    }
}

/// A tide in c^2/r_s^2, in g per metre.
pub(crate) fn tide(size: f64, mass: HoleMass) -> String {
    let per_metre = three_digits(size * mass.gees() / mass.metres());
    format!("{per_metre} g per metre")
}

/// What a quantity is called over the picture.
pub(crate) fn quantity_name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::R => "radius",
        Quantity::ThetaDeg => "polar angle",
        Quantity::Tau => "your clock",
        Quantity::T => "home's clock",
        // Their unit is that of the amount, which is years only where it is that long.
        Quantity::TauYears => "your time",
        Quantity::TYears => "home's time",
        Quantity::Rate => "home's clock ×",
        Quantity::Energy => "E",
        Quantity::AngularMomentum => "L",
        Quantity::CarterQ => "Q",
        Quantity::Periapsis => "lowest point",
        Quantity::Apoapsis => "highest point",
        Quantity::Turns => "turns",
        Quantity::Speed => "speed",
        Quantity::GasSpeed => "speed in gas",
        Quantity::Thrust => "thrust",
        Quantity::RapidityUsed => "fuel used",
        Quantity::RotationUsedDeg => "ship turned by",
        Quantity::EnergyRatio => "energy ratio",
        Quantity::LifeInside => "life inside",
        Quantity::Tide => "tide",
        Quantity::GLoad => "weight",
    }
}
