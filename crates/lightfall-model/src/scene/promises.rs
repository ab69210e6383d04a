//! The promises: what the program states of its errors, one constant each.
//!
//! Tests on a GPU hold every promise on every change; [`promises`] says which file they are in.
//! `lightfall doctor` holds those of the default method on every machine. docs/ACCURACY.md states
//! them in a table that `scripts/docs` writes and a test compares with [`table`].
//!
//! The error of a ray is its backward error: the smallest turn of the ray that explains the answer.

/// The error of 99 of 100 rays of `closed` around holes without spin, in radians.
pub const CLOSED_P99: f64 = 3e-7;
/// The error of every such ray, in radians: what f32 leaves of a direction.
pub const CLOSED_MAX: f64 = 1e-6;

/// The error of 99 of 100 rays of `closed` around holes that spin, in radians.
pub const CLOSED_SPINNING_P99: f64 = 6e-7;
/// The error of every such ray, in radians, besides [`CLOSED_LINGERING`]. Random scenes reach it, next to
/// the horizon and for observers that move fast.
pub const CLOSED_SPINNING_MAX: f64 = 6e-6;
/// The further error, in radians, of a ray that lingers next to the horizon, times 1 / (r_+ - r_-) in
/// r_s. The azimuth of such a ray is a rate times a time: the rate grows as 1 / (r_+ - r_-), and f32
/// keeps 1e-7 of it.
pub const CLOSED_LINGERING: f64 = 2e-7;

/// The error of 99 of 100 rays of `mino` at its default setting, in radians.
pub const MINO_P99: f64 = 4e-6;
/// The error of every ray of `mino` at its tightest setting, in radians.
pub const MINO_MAX: f64 = 2e-6;

/// The error of a delay of `closed` for the place that the method has found, in r_s/c.
pub const CLOSED_DELAY: f64 = 1e-3;
/// The same of `mino`: twice as large, from the quadrature over the method's long steps.
pub const MINO_DELAY: f64 = 2e-3;
/// The turn of the disk's matter, in radians, that the error of a delay is worth.
pub const MATTER_TURN: f64 = 1e-3;

/// The error of a star's place without spin, in pixels of 960x540.
pub const STAR_PLACE_PX: f64 = 1e-3;
/// The same for 99 of 100 images with spin.
pub const STAR_PLACE_SPINNING_PX: f64 = 2e-3;
/// The relative error of a star's flux with spin, for 99 of 100 images.
pub const STAR_FLUX_SPINNING: f64 = 2e-3;
/// The share of the stars' light that a picture with spin misses, from 20 r_s.
pub const STAR_LIGHT_MISSED: f64 = 5e-4;
/// The same for an observer who falls through 4.5 r_s.
pub const STAR_LIGHT_MISSED_FALLING: f64 = 2e-2;
/// The change of a star's flux while the camera turns by tenths of a pixel, from peak to peak.
pub const STAR_FLICKER: f64 = 1e-3;

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

/// Every promise.
pub fn promises() -> [Promise; 15] {
    let promise = |what, bound: f64, unit, tests| Promise {
        what,
        bound: format!("{bound:e}{unit}"),
        tests,
    };
    [
        promise(
            "`closed` without spin: the turn of 99 of 100 rays",
            CLOSED_P99,
            " rad",
            "promises.rs",
        ),
        promise("the same of every ray", CLOSED_MAX, " rad", "promises.rs"),
        promise(
            "`closed` with spin: the turn of 99 of 100 rays",
            CLOSED_SPINNING_P99,
            " rad",
            "promises.rs",
        ),
        Promise {
            what: "the same of every ray, with the horizons r_+ and r_- in r_s",
            bound: format!("{CLOSED_SPINNING_MAX:e} + {CLOSED_LINGERING:e}/(r_+ - r_-) rad"),
            tests: "promises.rs, report.rs",
        },
        promise(
            "`mino`: the turn of 99 of 100 rays",
            MINO_P99,
            " rad",
            "promises.rs",
        ),
        promise(
            "`mino` at its tightest setting: the turn of every ray",
            MINO_MAX,
            " rad",
            "promises.rs, report.rs",
        ),
        promise(
            "delay of a hit by `closed`, for the place found",
            CLOSED_DELAY,
            " r_s/c",
            "delay.rs",
        ),
        promise(
            "delay of a hit by `mino`, for the place found",
            MINO_DELAY,
            " r_s/c",
            "delay.rs",
        ),
        promise(
            "turn of the disk's matter in the error of a delay, for the place found",
            MATTER_TURN,
            " rad",
            "report.rs",
        ),
        promise(
            "place of a star without spin, of 960x540",
            STAR_PLACE_PX,
            " pixels",
            "stars/images.rs",
        ),
        promise(
            "place of a star with spin, in 99 of 100 images",
            STAR_PLACE_SPINNING_PX,
            " pixels",
            "stars/mesh.rs",
        ),
        promise(
            "flux of a star with spin, in 99 of 100 images",
            STAR_FLUX_SPINNING,
            " of it",
            "stars/mesh.rs",
        ),
        promise(
            "light of the stars that is missed with spin, from 20 r_s",
            STAR_LIGHT_MISSED,
            " of it",
            "stars/mesh.rs",
        ),
        promise(
            "the same, falling through 4.5 r_s",
            STAR_LIGHT_MISSED_FALLING,
            " of it",
            "stars/many.rs",
        ),
        promise(
            "flux of a star while the camera turns by tenths of a pixel",
            STAR_FLICKER,
            " of it",
            "stars/light.rs",
        ),
    ]
}

/// The promises as a Markdown table.
pub fn table() -> String {
    let rows = promises()
        .map(|Promise { what, bound, tests }| format!("| {what} | {bound} | {tests} |\n"));
    format!(
        "| promise | at most | tests |\n|---|---|---|\n{}",
        rows.concat()
    )
}
