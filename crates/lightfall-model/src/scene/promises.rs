//! The promises: what the program states of its errors.
//!
//! Tests on a GPU hold every promise on every change; its row says in which files. `lightfall
//! doctor` holds those of the default method on every machine. docs/ACCURACY.md states them in a
//! table that `scripts/docs` writes and a test compares with [`table`].
//!
//! The error of a ray is its backward error: the smallest turn of the ray that explains the answer.

/// A promise, for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Promise {
    /// What is promised.
    pub what: &'static str,
    /// The bound, with its unit.
    pub bound: String,
    /// The files of the tests that hold it, in the folder of the core's GPU tests.
    pub tests: &'static str,
}

/// Declares the promises: for each the constant of its bound, and its row in their table.
macro_rules! promises {
    ($(
        $(#[doc = $meaning:literal])+
        $NAME:ident = $bound:literal, $unit:expr, $what:literal, $tests:literal;
    )+) => {
        $($(#[doc = $meaning])+ pub const $NAME: f64 = $bound;)+

        /// Every promise.
        pub fn promises() -> Vec<Promise> {
            vec![$(Promise {
                what: $what,
                bound: format!("{:e}{}", $NAME, $unit),
                tests: $tests,
            }),+]
        }
    };
}

promises! {
    /// The error of 99 of 100 rays of `closed` around holes without spin, in radians.
    CLOSED_P99 = 3e-7, " rad", "`closed` without spin: the turn of 99 of 100 rays", "promises.rs";
    /// The error of every such ray, in radians: what f32 leaves of a direction.
    CLOSED_MAX = 1e-6, " rad", "the same of every ray", "promises.rs";
    /// The error of 99 of 100 rays of `closed` around holes that spin, in radians.
    CLOSED_SPINNING_P99 = 6e-7, " rad",
        "`closed` with spin: the turn of 99 of 100 rays", "promises.rs";
    /// The error of every such ray, in radians, besides [`CLOSED_LINGERING`]. Random scenes reach
    /// it, next to the horizon and for observers that move fast.
    CLOSED_SPINNING_MAX = 6e-6, format!(" + {CLOSED_LINGERING:e}/(r_+ - r_-) rad"),
        "the same of every ray, with the horizons r_+ and r_- in r_s", "promises.rs, extremes.rs";
    /// The error of 99 of 100 rays of `mino` at its default setting, in radians.
    MINO_P99 = 4e-6, " rad", "`mino`: the turn of 99 of 100 rays", "promises.rs";
    /// The error of every ray of `mino` at its tightest setting, in radians.
    MINO_MAX = 2e-6, " rad",
        "`mino` at its tightest setting: the turn of every ray", "promises.rs, extremes.rs";
    /// The error of a delay of `closed` for the place that the method has found, in r_s/c.
    CLOSED_DELAY = 1e-3, " r_s/c", "delay of a hit by `closed`, for the place found", "delay.rs";
    /// The same of `mino`: twice as large, from the quadrature over the method's long steps.
    MINO_DELAY = 2e-3, " r_s/c", "delay of a hit by `mino`, for the place found", "delay.rs";
    /// The turn of the disk's matter, in radians, that the error of a delay is worth.
    MATTER_TURN = 1e-3, " rad",
        "turn of the disk's matter in the error of a delay, for the place found", "extremes.rs";
    /// The error of a star's place without spin, in pixels of 960x540.
    STAR_PLACE_PX = 1e-3, " pixels", "place of a star without spin, of 960x540", "stars/images.rs";
    /// The same for 99 of 100 images with spin.
    STAR_PLACE_SPINNING_PX = 2e-3, " pixels",
        "place of a star with spin, in 99 of 100 images", "stars/mesh.rs";
    /// The relative error of a star's flux with spin, for 99 of 100 images.
    STAR_FLUX_SPINNING = 2e-3, " of it",
        "flux of a star with spin, in 99 of 100 images", "stars/mesh.rs";
    /// The share of the stars' light that a picture with spin misses, from 20 r_s.
    STAR_LIGHT_MISSED = 5e-4, " of it",
        "light of the stars that is missed with spin, from 20 r_s", "stars/mesh.rs";
    /// The same for an observer who falls through 4.5 r_s.
    STAR_LIGHT_MISSED_FALLING = 2e-2, " of it",
        "the same, falling through 4.5 r_s", "stars/many.rs";
    /// The error of the light of smooth matter with depth at the default setting, relative to the larger
    /// of the light and 1 % of the brightest of 95 of 100 pixels, for 95 of 100 pixels.
    MEDIUM_LIGHT = 2e-2, " of it",
        "light of smooth matter with depth by default, in 95 of 100 lit pixels", "medium.rs";
    /// The change of a star's flux while the camera turns by tenths of a pixel, from peak to peak.
    STAR_FLICKER = 1e-3, " of it",
        "flux of a star while the camera turns by tenths of a pixel", "stars/light.rs";
}

/// The further error, in radians, of a ray of `closed` that lingers next to the horizon of a hole
/// that spins, times 1 / (r_+ - r_-) in r_s. The azimuth of such a ray is a rate times a time: the
/// rate grows as 1 / (r_+ - r_-), and f32 keeps 1e-7 of it.
pub const CLOSED_LINGERING: f64 = 2e-7;

/// The promises as a Markdown table.
pub fn table() -> String {
    let row = |Promise { what, bound, tests }| format!("| {what} | {bound} | {tests} |\n");
    let rows: String = promises().into_iter().map(row).collect();
    format!("| promise | at most | tests |\n|---|---|---|\n{rows}")
}
