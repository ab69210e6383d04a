//! What an ordinary frame at the ship's controls costs on one core, and the path ahead in bent light on its
//! worker.
//!
//!     cargo run --release --example ship_frame
#![allow(clippy::print_stdout, reason = "the table is the result")]

use lightfall::app::{FlightStep, HoldKind, ShipFlight, ShipFrame, Stick, instruments};
use lightfall_core::optics::readout::si::MASSES;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{Heading, path_ahead, seen_path};
use lightfall_core::scene::{ObserverKind, Scene, presets};
use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

const FRAMES: u32 = 2000;
const FRAME: ShipFrame = ShipFrame {
    seconds: 1.0 / 60.0,
    turn_seconds: 1.0 / 60.0,
    stick: Stick::NEUTRAL,
    reduced_motion: false,
};

fn main() -> Result<(), Box<dyn Error>> {
    println!("spin,r,flies,advance_us,instruments_us,marks_us,map_us,seen_path_ms,seen_points");
    for (spin, r) in [(0.0, 6.0), (0.0, 3.0), (0.9, 6.0), (0.9, 1.5)] {
        for flies in ["coast", "orbit", "star"] {
            row(spin, r, flies)?;
        }
    }
    Ok(())
}

/// The mean time of something, in microseconds.
fn mean(count: u32, mut of: impl FnMut()) -> f64 {
    let clock = Instant::now();
    (0..count).for_each(|_| of());
    1e6 * clock.elapsed().as_secs_f64() / f64::from(count)
}

fn row(spin: f64, r: f64, flies: &str) -> Result<(), Box<dyn Error>> {
    let above = presets::find("above").ok_or("no such preset")?;
    let mut scene = above.scene(&[])?;
    scene.hole.spin = spin;
    (scene.camera.r, scene.camera.theta_deg) = (r, 90.0);
    scene.observer.kind = ObserverKind::Orbit;
    let mut ship = ShipFlight::default();
    ship.board(&scene, MASSES[0])?;
    match flies {
        "orbit" => {
            ship.switch_hold(HoldKind::Orbit)?;
        }
        "star" => (0..5).for_each(|_| {
            ship.face_next();
        }),
        _ => {}
    }
    let mut current: Scene = scene;
    let advance = mean(FRAMES, || {
        if let (FlightStep::Moved(next), _) = ship.advance(&FRAME, &current) {
            current = next.into_scene();
        }
    });
    let words = mean(FRAMES, || {
        black_box(instruments(&ship, MASSES[0], Units::Hole));
    });
    let flown = ship.voyage().ok_or("nobody flies")?.flight.ship;
    let marks = mean(FRAMES, || {
        for heading in [Heading::Prograde, Heading::Retrograde] {
            black_box(heading.direction(black_box(&flown)));
        }
    });
    let map = mean(20, || drop(black_box(path_ahead(&flown, 256))));
    let mut points = 0;
    let seen = mean(5, || {
        let path = seen_path(&current).unwrap_or_default();
        points = path.points.iter().flatten().count();
    });
    println!(
        "{spin},{r},{flies},{advance:.1},{words:.1},{marks:.2},{map:.0},{:.1},{points}",
        1e-3 * seen
    );
    Ok(())
}
