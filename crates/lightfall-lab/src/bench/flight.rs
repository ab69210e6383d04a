//! The error of a ship's flight against its run time, for three tolerances of a step.
//!
//! Each ship circles ten times. The engine is on, but moves nothing, so that the equations with an engine
//! are integrated. E, L, t and the angle of the gyroscopes are known in closed form.

use crate::import::or_nan;
use crate::table::table;
use glam::{DMat3, DVec3};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::geometry::ship::{Controls, DEFAULT_TOLERANCE, Ship, ShipError};
use lightfall_model::scene::{ObserverKind, Scene};
use lightfall_optics::ship::{BoardError, Clocks, Mount, board, write_scene};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use std::time::Instant;
use thiserror::Error;

/// Spins and radii (r_s) of the circles.
const CIRCLES: [[f64; 2]; 3] = [[0.0, 6.0], [0.9, 2.0], [0.998, 0.63]];
/// Tolerances of a step, the last one that of the program.
const TOLERANCES: [f64; 3] = [1e-9, 1e-12, DEFAULT_TOLERANCE];
/// Number of turns of a flight, and how often it is flown for its time.
const TURNS: f64 = 10.0;
const FLIGHTS: usize = 9;
/// Number of frames whose mean time is stated.
const FRAMES: u32 = 10_000;
/// Own time of a frame over r^(3/2), in r_s/c: a sixtieth of a second at the usual pace.
const FRAME: f64 = 0.1 / 60.0;

/// An engine that moves nothing by more than rounding.
const WEAK: Controls = Controls {
    acceleration: DVec3::new(1e-30, 0.0, 0.0),
    rotation: DVec3::ZERO,
};

/// Why a flight cannot be measured.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FlightFault {
    /// There is no such ship.
    #[error(transparent)]
    Board(#[from] BoardError),
    /// The ship cannot move so.
    #[error(transparent)]
    Ship(#[from] ShipError),
    /// The ship is no observer of a scene.
    #[error(transparent)]
    Observer(#[from] ObserverError),
    /// The ship left its circle.
    #[error("the ship left the circle at {r} r_s around a hole with the spin {spin}")]
    Lost {
        /// The spin.
        spin: f64,
        /// The radius, in r_s.
        r: f64,
    },
}

/// A flight of ten turns on a circle. Errors are absolute, in r_s and c.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct FlightMeasurement {
    /// The hole's spin.
    pub spin: f64,
    /// The circle's radius, in r_s.
    pub r: f64,
    /// The tolerance of a step, relative to the largest component of the axes.
    pub tolerance: f64,
    /// Whether it is the program's.
    pub own: bool,
    /// How often the equations are evaluated in a turn.
    pub evaluations_per_turn: f64,
    /// Median time of a turn, in microseconds, on one core.
    pub us_per_turn: f64,
    /// Difference between the largest and the least time of a turn, in microseconds.
    pub spread_us: f64,
    /// Mean time of the step of an ordinary frame, in microseconds.
    pub us_per_frame: f64,
    /// Error of E.
    #[serde(deserialize_with = "or_nan")]
    pub energy: f64,
    /// Error of L.
    #[serde(deserialize_with = "or_nan")]
    pub angular_momentum: f64,
    /// Error of t.
    #[serde(deserialize_with = "or_nan")]
    pub far_time: f64,
    /// Error of the gyroscopes' direction, in radians.
    #[serde(deserialize_with = "or_nan")]
    pub gyroscope: f64,
    /// The error that the flight states of itself.
    #[serde(deserialize_with = "or_nan")]
    pub stated: f64,
}

/// Number of rows of [`run_flights`].
pub fn flight_rows() -> usize {
    CIRCLES.len() * TOLERANCES.len()
}

/// Flies all circles with all tolerances, except the known rows of an earlier run. `done` is called after
/// each new row. Returns all rows.
///
/// # Errors
/// A flight cannot be measured.
pub fn run_flights(
    known: &[FlightMeasurement],
    mut done: impl FnMut(&FlightMeasurement),
) -> Result<Vec<FlightMeasurement>, FlightFault> {
    let mut rows = Vec::with_capacity(flight_rows());
    for [spin, r] in CIRCLES {
        for tolerance in TOLERANCES {
            let is_it =
                |row: &&FlightMeasurement| [row.spin, row.r, row.tolerance] == [spin, r, tolerance];
            if let Some(row) = known.iter().find(is_it) {
                rows.push(row.clone());
                continue;
            }
            let row = measured(spin, r, tolerance)?;
            done(&row);
            rows.push(row);
        }
    }
    Ok(rows)
}

/// How the ship is turned on the axes of the scene's observer.
fn attitude(ship: &Ship, scene: &Scene) -> Result<DMat3, FlightFault> {
    let mut scene = scene.clone();
    write_scene(ship, &Mount::NOSE, &mut scene)?;
    Ok(scene.camera.heading() * Mount::NOSE.0.transpose())
}

fn measured(spin: f64, r: f64, tolerance: f64) -> Result<FlightMeasurement, FlightFault> {
    let lost = FlightFault::Lost { spin, r };
    let Some(orbit) = (Kerr { spin }).circular_orbit(r) else {
        return Err(lost);
    };
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg) = (r, 90.0);
    scene.observer.kind = ObserverKind::Orbit;
    let start = board(&scene, &Mount::NOSE)?.with_tolerance(tolerance)?;
    let own_time = TURNS * TAU / (orbit.angular_velocity * orbit.u_t);
    let mut ship = start;
    let mut times = Vec::with_capacity(FLIGHTS);
    for _ in 0..FLIGHTS {
        ship = start;
        let clock = Instant::now();
        ship.advance(&WEAK, own_time)?;
        times.push(1e6 * clock.elapsed().as_secs_f64() / TURNS);
    }
    times.sort_by(f64::total_cmp);
    let mut frames = start;
    let clock = Instant::now();
    for _ in 0..FRAMES {
        frames.advance(&WEAK, FRAME * r.powf(1.5))?;
    }
    let us_per_frame = 1e6 * clock.elapsed().as_secs_f64() / f64::from(FRAMES);

    let far = Clocks::new(&ship).far.ok_or(lost)?;
    // In the circling axes gyroscopes turn with sqrt(M/r^3) about the axis (Rindler & Perlick 1990).
    let turn = DMat3::from_axis_angle(DVec3::Y, (0.5 / r.powi(3)).sqrt() * own_time);
    let difference = attitude(&ship, &scene)? - turn * attitude(&start, &scene)?;
    let columns = (0..3).map(|axis| difference.col(axis).length());
    let constants = ship.constants();
    Ok(FlightMeasurement {
        spin,
        r,
        tolerance,
        own: tolerance == DEFAULT_TOLERANCE,
        evaluations_per_turn: ship.evaluations() as f64 / TURNS,
        us_per_turn: times[FLIGHTS / 2],
        spread_us: times[FLIGHTS - 1] - times[0],
        us_per_frame,
        energy: (constants.energy - orbit.energy).abs(),
        angular_momentum: (constants.angular_momentum - orbit.angular_momentum).abs(),
        far_time: (far - TURNS * TAU / orbit.angular_velocity).abs(),
        gyroscope: columns.fold(0.0, f64::max),
        stated: ship.error().stated(),
    })
}

/// The rows as a Markdown table.
pub fn flight_table(rows: &[FlightMeasurement]) -> String {
    let cells = |row: &FlightMeasurement| {
        let own = if row.own { " (own)" } else { "" };
        let errors = [
            row.energy,
            row.angular_momentum,
            row.far_time,
            row.gyroscope,
            row.stated,
        ];
        format!(
            "{}, {} | {:.0e}{own} | {:.0} | {:.0} | {:.1} | {}",
            row.spin,
            row.r,
            row.tolerance,
            row.evaluations_per_turn,
            row.us_per_turn,
            row.us_per_frame,
            errors.map(|error| format!("{error:.0e}")).join(" | ")
        )
    };
    table(
        "spin, r | tolerance | evaluations a turn | us a turn | us a frame | error of E | L | t, r_s/c | \
         gyroscopes, rad | stated",
        rows.iter().map(cells),
    )
}
