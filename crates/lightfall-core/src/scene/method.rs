//! How light is traced: the methods by name.

use serde::{Deserialize, Serialize};

/// How light is traced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// The method best suited to the scene among those that are built.
    #[default]
    Auto,
    /// Velocity Verlet in Schwarzschild's areal Cartesian coordinates.
    Verlet,
    /// Schwarzschild's null geodesics in closed form.
    Closed,
    /// Kerr's null geodesics in Mino time.
    Mino,
    /// Kerr's null geodesics in ingoing Kerr-Schild coordinates, by Runge-Kutta.
    KerrSchild,
    /// The f64 reference, on the CPU only.
    Reference,
}

impl Method {
    /// Those that a shader traces by, the solved ones first.
    pub const ON_GPU: [Self; 4] = [Self::Closed, Self::Mino, Self::Verlet, Self::KerrSchild];

    /// What `auto` means for a hole of spin `chi`.
    #[must_use]
    pub fn for_spin(chi: f64) -> Self {
        if chi == 0.0 { Self::Closed } else { Self::Mino }
    }

    /// This method, or what `auto` means for a hole of spin `chi`.
    #[must_use]
    pub fn resolved(self, chi: f64) -> Self {
        if self == Self::Auto {
            Self::for_spin(chi)
        } else {
            self
        }
    }

    /// Every method.
    pub const ALL: [Self; 6] = [
        Self::Auto,
        Self::Verlet,
        Self::Closed,
        Self::Mino,
        Self::KerrSchild,
        Self::Reference,
    ];

    /// Its name, as presets and the command line have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Verlet => "verlet",
            Self::Closed => "closed",
            Self::Mino => "mino",
            Self::KerrSchild => "kerr-schild",
            Self::Reference => "reference",
        }
    }

    /// The method of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }
}
