//! Error of a ship's flight against its run time, for three tolerances of a step.
//!
//!     cargo run --release --example flight -p lightfall-optics
//!
//! Each ship circles ten times. The engine is on, but moves nothing, so that the equations with an engine
//! are integrated. E, L, t and the angle of the gyroscope are known in closed form. A frame is a
//! sixtieth of a second at the usual pace, 0.1 r^1.5 r_s/c a second.
#![allow(clippy::print_stdout, reason = "the table is the result")]

use glam::{DMat3, DVec3};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::ship::{Controls, Ship};
use lightfall_model::scene::{ObserverKind, Scene};
use lightfall_optics::ship::{Clocks, Mount, board, write_scene};
use std::error::Error;
use std::f64::consts::TAU;
use std::time::Instant;

const TURNS: f64 = 10.0;
const FRAMES: u32 = 20_000;

/// An engine that moves nothing by more than rounding.
const WEAK: Controls = Controls {
    acceleration: DVec3::new(1e-30, 0.0, 0.0),
    rotation: DVec3::ZERO,
};

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "spin,r,tolerance,evaluations_per_turn,us_per_turn,us_per_frame,energy,angular_momentum,far_time,gyroscope,stated"
    );
    for (spin, r) in [(0.0, 6.0), (0.9, 2.0), (0.998, 0.63)] {
        for tolerance in [1e-9, 1e-12, 3e-15] {
            row(spin, r, tolerance)?;
        }
    }
    Ok(())
}

/// How the ship is turned on the axes of the scene's observer.
fn attitude(ship: &Ship, scene: &Scene) -> Result<DMat3, Box<dyn Error>> {
    let mut scene = scene.clone();
    write_scene(ship, &Mount::NOSE, &mut scene)?;
    Ok(scene.camera.tetrad_from_camera() * Mount::NOSE.0.transpose())
}

fn row(spin: f64, r: f64, tolerance: f64) -> Result<(), Box<dyn Error>> {
    let kerr = Kerr { spin };
    let orbit = kerr.circular_orbit(r).ok_or("there is no such orbit")?;
    let mut scene = Scene::default();
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg) = (r, 90.0);
    scene.observer.kind = ObserverKind::Orbit;
    let start = board(&scene, &Mount::NOSE)?.with_tolerance(tolerance)?;
    let own = TURNS * TAU / (orbit.angular_velocity * orbit.u_t);
    let before = attitude(&start, &scene)?;
    let mut ship = start;
    let clock = Instant::now();
    ship.advance(&WEAK, own)?;
    let turn = clock.elapsed().as_secs_f64() / TURNS;
    let constants = ship.constants();
    let far = Clocks::new(&ship).far.ok_or("the ship fell in")?;
    // In the circling axes gyroscopes turn with sqrt(M/r^3) about the axis.
    let angle = (0.5 / r.powi(3)).sqrt() * own;
    let expected = DMat3::from_axis_angle(DVec3::Y, angle) * before;
    let gyroscope = (0..3)
        .map(|i| attitude(&ship, &scene).map(|now| now.col(i) - expected.col(i)))
        .collect::<Result<Vec<_>, _>>()?
        .into_iter()
        .fold(0.0, |most: f64, column| most.max(column.length()));
    let evaluations = ship.evaluations() as f64 / TURNS;
    let error = ship.error().stated();
    let frame = 0.1 * r.powf(1.5) / 60.0;
    let mut frames = start;
    let clock = Instant::now();
    for _ in 0..FRAMES {
        frames.advance(&WEAK, frame)?;
    }
    let per_frame = clock.elapsed().as_secs_f64() / f64::from(FRAMES);
    println!(
        "{spin},{r},{tolerance:e},{evaluations:.0},{:.0},{:.1},{:.0e},{:.0e},{:.0e},{gyroscope:.0e},{error:.0e}",
        1e6 * turn,
        1e6 * per_frame,
        (constants.energy - orbit.energy).abs(),
        (constants.angular_momentum - orbit.angular_momentum).abs(),
        (far - TURNS * TAU / orbit.angular_velocity).abs(),
    );
    Ok(())
}
