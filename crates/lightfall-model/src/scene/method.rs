//! How light is traced: the methods, and what distinguishes one from another.

use super::promises;

crate::words! {
    /// How light is traced.
    pub enum Method {
        /// The closed form, with or without spin.
        Auto = "auto": "Best for this scene (auto)",
        /// Small steps in space, without spin; the article's method.
        Verlet = "verlet": "Verlet steps (verlet)",
        /// Elliptic functions, with or without spin; no steps, and nothing to set.
        Closed = "closed": "Closed form (closed)",
        /// Steps in Mino time, with or without spin; the independent second method.
        Mino = "mino": "Mino time (mino)",
        /// Runge-Kutta steps in ingoing coordinates, for comparison.
        KerrSchild = "kerr-schild": "Kerr-Schild steps (kerr-schild)",
        /// In double precision on the processor; it draws no picture.
        Reference = "reference": "Reference (reference)",
    }
}

/// The field that trades a method's accuracy against time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccuracySetting {
    /// There is none: the method is as exact as its numbers.
    None,
    /// `quality.max_error_px`: the method keeps its error below this one.
    MaxError,
    /// `quality.step_scale`, with the other fields of the step policy: the error follows from the
    /// steps.
    StepScale,
}

/// What distinguishes a method from the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MethodProperties {
    /// Whether it traces holes that spin.
    pub spins: bool,
    /// Whether it can begin inside the horizon.
    pub inside: bool,
    /// Whether a shader exists for it.
    pub on_gpu: bool,
    /// Whether it takes steps, each with a residual of the null constraint.
    pub steps: bool,
    /// Whether every ray gets an answer; otherwise some run out of steps.
    pub answers_every_ray: bool,
    /// The field that sets its accuracy.
    pub setting: AccuracySetting,
    /// The article's least step, in r_s; zero for methods without one.
    pub min_step: f64,
    /// [`Method::backward_p99`] without spin.
    p99_without_spin: Option<f64>,
    /// [`Method::backward_max`] without spin.
    max_without_spin: f64,
}

const CLOSED: MethodProperties = MethodProperties {
    spins: true,
    inside: true,
    on_gpu: true,
    steps: false,
    answers_every_ray: true,
    setting: AccuracySetting::None,
    min_step: 0.0,
    p99_without_spin: Some(promises::CLOSED_P99),
    max_without_spin: promises::CLOSED_MAX,
};

const MINO: MethodProperties = MethodProperties {
    spins: true,
    inside: true,
    on_gpu: true,
    steps: true,
    answers_every_ray: true,
    setting: AccuracySetting::MaxError,
    min_step: 0.0,
    p99_without_spin: Some(promises::MINO_P99),
    max_without_spin: promises::MINO_MAX,
};

/// The article's methods are held to a pixel of the article's own pictures, 960x540 at 60 degrees.
const KERR_SCHILD: MethodProperties = MethodProperties {
    spins: true,
    inside: false,
    on_gpu: true,
    steps: true,
    answers_every_ray: false,
    setting: AccuracySetting::StepScale,
    min_step: 0.008,
    p99_without_spin: None,
    max_without_spin: 2.1e-3,
};

impl Method {
    /// The method's properties: a new method is a new row.
    pub const fn properties(self) -> MethodProperties {
        match self {
            Self::Auto | Self::Closed => CLOSED,
            Self::Mino => MINO,
            Self::KerrSchild => KERR_SCHILD,
            Self::Verlet => MethodProperties {
                spins: false,
                min_step: 0.018,
                ..KERR_SCHILD
            },
            Self::Reference => MethodProperties {
                on_gpu: false,
                setting: AccuracySetting::None,
                ..MINO
            },
        }
    }

    /// The methods that a shader traces by, those that answer every ray first.
    pub fn on_gpu() -> Vec<Self> {
        let mut methods: Vec<Self> = Self::ALL
            .into_iter()
            .filter(|method| *method != Self::Auto && method.properties().on_gpu)
            .collect();
        methods.sort_by_key(|method| !method.properties().answers_every_ray);
        methods
    }

    /// The words of the methods with some property, for a sentence: "verlet, closed and mino",
    /// where `last` is "and".
    pub fn list(last: &str, has: impl Fn(&MethodProperties) -> bool) -> String {
        let methods = Self::ALL.into_iter();
        let words: Vec<_> = methods
            .filter(|method| has(&method.properties()))
            .map(Self::word)
            .collect();
        match words.split_last() {
            Some((end, [])) => (*end).into(),
            Some((end, rest)) => format!("{} {last} {end}", rest.join(", ")),
            None => "none".into(),
        }
    }

    /// The backward error that 99 of 100 rays around a hole of spin `chi` hold at the default
    /// setting, in radians; none where nothing is promised.
    pub fn backward_p99(self, chi: f64) -> Option<f64> {
        let spins = self.resolved() == Self::Closed && chi != 0.0;
        self.properties().p99_without_spin.map(|p99| {
            if spins {
                promises::CLOSED_SPINNING_P99
            } else {
                p99
            }
        })
    }

    /// The largest backward error of any ray around a hole of spin `chi`, in radians, if the
    /// method's own setting is not larger.
    pub fn backward_max(self, chi: f64) -> f64 {
        if self.resolved() == Self::Closed && chi != 0.0 {
            promises::CLOSED_SPINNING_MAX + promises::CLOSED_LINGERING / (1.0 - chi * chi).sqrt()
        } else {
            self.properties().max_without_spin
        }
    }

    /// What `auto` means: the method with the smallest error at its speed (docs/ACCURACY.md).
    pub const BEST: Self = Self::Closed;

    /// This method, or what `auto` means.
    #[must_use]
    pub fn resolved(self) -> Self {
        if self == Self::Auto { Self::BEST } else { self }
    }
}
