//! Read-outs in metres, seconds and g, for a hole of a given mass.

use super::Readout;

/// The speed of light, in m/s; exact.
pub const LIGHT_SPEED: f64 = 299_792_458.0;
/// The Sun's G M, in m^3/s^2: the nominal value of IAU 2015 resolution B3.
pub const SOLAR_GM: f64 = 1.327_124_4e20;
/// Standard gravity, in m/s^2; exact.
pub const STANDARD_GRAVITY: f64 = 9.806_65;

/// The mass of a hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoleMass {
    /// Name of the hole.
    pub name: &'static str,
    /// Mass, in solar masses.
    pub suns: f64,
}

/// The masses to choose from: Sagittarius A* (GRAVITY Collaboration 2022), M87* (Event Horizon
/// Telescope Collaboration 2019), and a hole that a star leaves behind.
pub const MASSES: [HoleMass; 3] = [
    HoleMass {
        name: "Sgr A*",
        suns: 4.30e6,
    },
    HoleMass {
        name: "M87*",
        suns: 6.5e9,
    },
    HoleMass {
        name: "10 suns",
        suns: 10.0,
    },
];

impl HoleMass {
    /// The mass of so many suns, with the name of the hole that has it, or as `this hole`.
    pub fn of_suns(suns: f64) -> Self {
        let known = MASSES.into_iter().find(|mass| mass.suns == suns);
        known.unwrap_or(Self {
            name: "this hole",
            suns,
        })
    }

    /// r_s = 2 G M / c^2, in m.
    pub fn metres(self) -> f64 {
        2.0 * SOLAR_GM * self.suns / (LIGHT_SPEED * LIGHT_SPEED)
    }

    /// r_s / c, in s.
    pub fn seconds(self) -> f64 {
        self.metres() / LIGHT_SPEED
    }

    /// An acceleration of one c^2/r_s, in g.
    pub fn gees(self) -> f64 {
        LIGHT_SPEED * LIGHT_SPEED / self.metres() / STANDARD_GRAVITY
    }
}

/// The read-outs that have a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SiReadout {
    /// Boyer-Lindquist radius, in km.
    pub r_km: f64,
    /// Proper acceleration, in g.
    pub acceleration_g: f64,
    /// Largest tidal stretching, in g per metre.
    pub tide_g_per_metre: f64,
}

impl Readout {
    /// The read-outs for a hole of this mass.
    pub fn in_si(&self, mass: HoleMass) -> SiReadout {
        SiReadout {
            r_km: self.r * mass.metres() / 1000.0,
            acceleration_g: self.acceleration * mass.gees(),
            tide_g_per_metre: self.tide * mass.gees() / mass.metres(),
        }
    }
}
