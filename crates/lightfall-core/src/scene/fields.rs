//! The field table: every leaf field of a [`Scene`](super::Scene) with its kind, range, unit and
//! meaning. Validation, `presets show`, the documentation and the panel all read it from here.

use super::MAX_RADIUS;
use std::fmt;
use std::ops::Bound::{self, Excluded, Included, Unbounded};

/// One leaf field of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// Dotted key, as in `--set KEY=VALUE`.
    pub key: &'static str,
    /// What kind of value it takes, and from which range.
    pub kind: Kind,
    /// Unit, as it follows a number; empty where there is none.
    pub unit: &'static str,
    /// What it means, in one line.
    pub about: &'static str,
}

/// The kinds of value a field takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A finite number.
    Float(Range),
    /// A whole number.
    Integer(Range),
    /// True or false.
    Boolean,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// One line of text, no longer than [`MAX_TEXT_CHARS`].
    Text,
    /// Three finite numbers, the components of a velocity below that of light.
    Velocity,
}

/// Most characters a text field may have.
pub const MAX_TEXT_CHARS: usize = 200;

/// An interval of numbers, each end open or closed. Whole numbers up to 2^53 are exact in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end.
    pub low: Bound<f64>,
    /// Upper end.
    pub high: Bound<f64>,
}

impl Range {
    /// Every finite number.
    pub const FINITE: Self = Self {
        low: Unbounded,
        high: Unbounded,
    };

    /// `low <= x <= high`.
    const fn closed(low: f64, high: f64) -> Self {
        Self {
            low: Included(low),
            high: Included(high),
        }
    }

    /// `low < x <= high`.
    const fn above(low: f64, high: f64) -> Self {
        Self {
            low: Excluded(low),
            high: Included(high),
        }
    }

    /// Whether a number is finite and inside.
    pub fn contains(&self, number: f64) -> bool {
        number.is_finite() && std::ops::RangeBounds::contains(&(self.low, self.high), &number)
    }
}

impl fmt::Display for Range {
    /// The interval in words, e.g. `above 0 and at most 16`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let (Included(low), Included(high)) = (self.low, self.high) {
            return if low == high {
                write!(f, "equal to {}", number(low))
            } else {
                write!(
                    f,
                    "from {} to {}",
                    number(round_inside(low, 1.0)),
                    number(round_inside(high, -1.0))
                )
            };
        }
        let low = match self.low {
            Included(low) => format!("at least {}", number(round_inside(low, 1.0))),
            Excluded(low) => format!("above {}", number(round_inside(low, 1.0))),
            Unbounded => String::new(),
        };
        let high = match self.high {
            Included(high) => format!("at most {}", number(round_inside(high, -1.0))),
            Excluded(high) => format!("below {}", number(round_inside(high, -1.0))),
            Unbounded => String::new(),
        };
        let and = if low.is_empty() || high.is_empty() {
            ""
        } else {
            " and "
        };
        write!(f, "{low}{and}{high}")
    }
}

/// A limit in few digits, on its own inner side, so that what is said is allowed: `side` is 1 for
/// the lower, -1 for the upper. One that was written in few digits stays.
fn round_inside(limit: f64, side: f64) -> f64 {
    const DIGITS: i32 = 6;
    if limit.fract() == 0.0
        || !limit.is_finite()
        || format!("{limit:e}")
            .find('e')
            .is_some_and(|length| length <= 10)
    {
        return limit;
    }
    let scale = 10.0_f64.powi(DIGITS - 1 - limit.abs().log10().floor() as i32);
    side * (side * limit * scale).ceil() / scale
}

/// The shortest digits that give the number back, with an exponent only where zeros would hide its
/// size.
pub(super) fn number(x: f64) -> String {
    if x == 0.0 || (1e-4..1e16).contains(&x.abs()) || !x.is_finite() {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

impl Field {
    /// What the field takes, in words, e.g. `a number from 0 to 180 degrees`.
    pub fn allowed(&self) -> String {
        self.allowed_in(match self.kind {
            Kind::Float(range) | Kind::Integer(range) => range,
            _ => Range::FINITE,
        })
    }

    /// The same, with the range that holds beside the other fields of some scene.
    pub(super) fn allowed_in(&self, range: Range) -> String {
        let words = |noun: &str| {
            let unit = if self.unit.is_empty() {
                String::new()
            } else {
                format!(" {}", self.unit)
            };
            if range == Range::FINITE {
                format!("{noun}{unit}")
            } else {
                format!("{noun} {range}{unit}")
            }
        };
        match self.kind {
            Kind::Float(_) => words("a number"),
            Kind::Integer(_) => words("an integer"),
            Kind::Boolean => "true or false".into(),
            Kind::Choice(choices) => format!("one of {}", choices.join(", ")),
            Kind::Text => format!("one line of text, at most {MAX_TEXT_CHARS} characters"),
            Kind::Velocity => {
                "three numbers, [outward, toward growing theta, toward growing phi], of length below 1 c".into()
            }
        }
    }
}

/// The field with this key.
pub fn field(key: &str) -> Option<&'static Field> {
    FIELDS.iter().find(|field| field.key == key)
}

const fn float(key: &'static str, range: Range, unit: &'static str, about: &'static str) -> Field {
    Field {
        key,
        kind: Kind::Float(range),
        unit,
        about,
    }
}

const fn integer(
    key: &'static str,
    range: Range,
    unit: &'static str,
    about: &'static str,
) -> Field {
    Field {
        key,
        kind: Kind::Integer(range),
        unit,
        about,
    }
}

const fn boolean(key: &'static str, about: &'static str) -> Field {
    Field {
        key,
        kind: Kind::Boolean,
        unit: "",
        about,
    }
}

const fn choice(key: &'static str, choices: &'static [&'static str], about: &'static str) -> Field {
    Field {
        key,
        kind: Kind::Choice(choices),
        unit: "",
        about,
    }
}

const fn text(key: &'static str, about: &'static str) -> Field {
    Field {
        key,
        kind: Kind::Text,
        unit: "",
        about,
    }
}

/// A radius in the disk.
pub(super) const EDGE: Range = Range::above(0.0, 1e6);
/// From pole to pole.
pub(super) const POLAR: Range = Range::closed(0.0, 180.0);
/// A turn either way.
const TURN: Range = Range::closed(-360.0, 360.0);
/// A share of a whole.
const SHARE: Range = Range::closed(0.0, 1.0);
/// An artistic scale of light.
const SCALE: Range = Range::closed(0.0, 1e3);
/// Longest side of a picture, in pixels: what every device that the passes run on can do (WebGPU's
/// default limit).
pub const MAX_PICTURE_SIDE: u32 = 8192;
/// A side of a picture.
const SIDE: Range = Range::closed(1.0, MAX_PICTURE_SIDE as f64);
/// A radius where a camera may be around some hole; the hole's own horizons narrow it (see
/// `limits`).
const CAMERA: Range = Range::closed(0.1, MAX_RADIUS);
/// A vertical field of view, from a millionth of a radian up.
const FIELD_OF_VIEW: Range = Range::closed(1e-6_f64.to_degrees(), 179.0);

/// Every leaf field of a scene, in the order of its declaration.
pub const FIELDS: &[Field] = &[
    integer(
        "schema",
        Range::closed(super::SCHEMA as f64, super::SCHEMA as f64),
        "",
        "Version of the preset format",
    ),
    text("name", "Short name"),
    text("title", "One line that says what there is to see"),
    choice(
        "method",
        &[
            "auto",
            "verlet",
            "closed",
            "mino",
            "kerr-schild",
            "reference",
        ],
        "How light is traced",
    ),
    choice(
        "view",
        &[
            "colour",
            "unfinished",
            "classes",
            "residual",
            "order",
            "redshift",
            "error",
        ],
        "What is shown: the light, the light with rays without an answer in magenta, or a diagnostic",
    ),
    float(
        "hole.spin",
        Range {
            low: Excluded(-1.0),
            high: Excluded(1.0),
        },
        "",
        "chi = a/M; positive turns with the disk",
    ),
    float(
        "camera.r",
        CAMERA,
        "r_s",
        "Boyer-Lindquist radius of the camera, outside the horizon unless observer.kind is rain",
    ),
    float(
        "camera.theta_deg",
        POLAR,
        "degrees",
        "Angle from the disk normal",
    ),
    float("camera.phi_deg", TURN, "degrees", "Azimuth"),
    float(
        "camera.fov_deg",
        FIELD_OF_VIEW,
        "degrees",
        "Vertical field of view",
    ),
    float(
        "camera.yaw_deg",
        TURN,
        "degrees",
        "Turn to the right, away from the hole's centre",
    ),
    float(
        "camera.pitch_deg",
        TURN,
        "degrees",
        "Turn upward, after the yaw",
    ),
    float(
        "camera.roll_deg",
        TURN,
        "degrees",
        "Turn clockwise about the line of sight, last",
    ),
    choice(
        "observer.kind",
        &["static", "zamo", "orbit", "rain"],
        "How the camera moves",
    ),
    Field {
        key: "observer.velocity",
        kind: Kind::Velocity,
        unit: "c",
        about: "One more boost, in the observer's frame",
    },
    boolean(
        "effects.lensing",
        "Whether light is bent; off breaks the physics on purpose",
    ),
    boolean(
        "effects.doppler",
        "Whether motion shifts light; off breaks the physics on purpose",
    ),
    boolean(
        "effects.beaming",
        "Whether a shift changes the brightness by g^4; off breaks the physics on purpose",
    ),
    boolean(
        "effects.gravitational_shift",
        "Whether potentials shift light; off breaks the physics on purpose",
    ),
    boolean(
        "effects.aberration",
        "Whether motion displaces directions; off breaks the physics on purpose",
    ),
    boolean("disk.enabled", "Whether there is a disk"),
    float(
        "disk.inner",
        EDGE,
        "r_s",
        "Inner edge; never inside the innermost stable circular orbit",
    ),
    boolean(
        "disk.follow_isco",
        "Whether the inner edge is the innermost stable circular orbit, whatever disk.inner says",
    ),
    float(
        "disk.outer",
        EDGE,
        "r_s",
        "Outer edge; outside the innermost stable circular orbit",
    ),
    choice(
        "disk.model",
        &["newtonian", "page-thorne"],
        "Radial profile of the flux",
    ),
    float(
        "disk.temperature_k",
        Range::closed(100.0, 1e6),
        "K",
        "Temperature scale: T = temperature_k F^(1/4); a hotter disk keeps its total flux, ever less of it visible",
    ),
    float(
        "disk.brightness",
        SCALE,
        "",
        "Artistic scale of the emission",
    ),
    float(
        "disk.edge_taper",
        Range::closed(0.0, 0.5),
        "",
        "Width of the fade at each edge, as a fraction of its radius",
    ),
    float(
        "disk.transmission",
        SHARE,
        "",
        "Share of the light from behind that passes through",
    ),
    choice(
        "sky.mode",
        &["stars", "grid", "off"],
        "What is drawn at infinity",
    ),
    integer(
        "sky.seed",
        Range::closed(0.0, u32::MAX as f64),
        "",
        "Which stars",
    ),
    float("sky.brightness", SCALE, "", "Scale of the sky's light"),
    boolean(
        "sky.reference_star",
        "Whether one bright star is added, in any mode but `off`",
    ),
    float(
        "sky.reference_theta_deg",
        POLAR,
        "degrees",
        "The reference star's angle from the disk normal",
    ),
    float(
        "sky.reference_phi_deg",
        TURN,
        "degrees",
        "The reference star's azimuth",
    ),
    boolean("probe.enabled", "Whether the foreground probe is there"),
    float(
        "probe.r",
        Range::above(1.0, MAX_RADIUS),
        "r_s",
        "Radius where the probe hovers",
    ),
    float(
        "probe.theta_deg",
        POLAR,
        "degrees",
        "The probe's angle from the disk normal",
    ),
    float("probe.phi_deg", TURN, "degrees", "The probe's azimuth"),
    float(
        "probe.size",
        Range::above(0.0, 1e3),
        "r_s",
        "Length of the probe's body",
    ),
    boolean(
        "probe.antialias",
        "Whether the probe's edges are smoothed, by four samples a pixel",
    ),
    integer("picture.width", SIDE, "pixels", "Width of the HDR picture"),
    integer(
        "picture.height",
        SIDE,
        "pixels",
        "Height of the HDR picture",
    ),
    integer(
        "picture.grid_width",
        SIDE,
        "cells",
        "Width of the presentation grid; not more than picture.width",
    ),
    integer(
        "picture.grid_height",
        SIDE,
        "cells",
        "Height of the presentation grid; not more than picture.height",
    ),
    float(
        "picture.exposure_ev",
        Range::closed(-20.0, 20.0),
        "powers of two",
        "Exposure",
    ),
    float(
        "picture.bloom",
        SHARE,
        "",
        "Strength of the bloom; zero leaves it out",
    ),
    integer(
        "picture.levels",
        Range::closed(2.0, 256.0),
        "levels",
        "How many levels a channel is rounded to",
    ),
    boolean(
        "picture.dither",
        "Whether a 4x4 Bayer pattern spreads the rounding error",
    ),
    boolean("picture.bypass", "Whether the pixel treatment is left out"),
    float(
        "quality.max_error_px",
        Range::closed(1e-4, 1.0),
        "pixels",
        "Largest error of a ray, for method mino",
    ),
    float(
        "quality.step_scale",
        Range::above(0.0, 16.0),
        "",
        "Scale of the step rule of verlet and kerr-schild: 1.55 cheap, 0.85 balanced, 0.45 high",
    ),
    integer(
        "quality.max_steps",
        Range::closed(1.0, 768.0),
        "steps",
        "Most steps of verlet and kerr-schild",
    ),
    float(
        "quality.max_affine",
        Range::above(0.0, 1e9),
        "r_s",
        "Most affine length of verlet and kerr-schild",
    ),
];
