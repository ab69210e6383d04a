//! Writes what a pilot hears as WAV files, to be heard or to be looked at as spectrograms: an orbit at
//! 6 r_s, a fall from there through the horizon, and a burn of ten seconds away from the hole.
//!
//!     cargo run --release -p lightfall-optics --example cockpit_sound -- FOLDER

use lightfall_model::scene::{ObserverKind, Scene};
use lightfall_optics::exposure::roughly_metered_exposure;
use lightfall_optics::ship::{
    Clocks, Flight, Heading, Mount, Orders, Rocket, Thrust, board, write_scene,
};
use lightfall_optics::sound::{Cockpit, Readings, flux_of_exposure};
use std::error::Error;
use std::path::{Path, PathBuf};

/// Samples per second, and frames per second, in which the light meter measures only the tenth.
const RATE: u32 = 48_000;
const FRAMES: u32 = 60;
const SECONDS: u32 = 12;
/// The burn's acceleration, in c^2/r_s, and the seconds in which it begins and ends.
const THRUST: f64 = 0.25;
const BURN: [f64; 2] = [1.0, 11.0];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("name a folder")?);
    for (name, kind, burns) in [
        ("orbit", ObserverKind::Orbit, false),
        ("fall", ObserverKind::Rain, false),
        ("burn", ObserverKind::Static, true),
    ] {
        let mut scene = Scene::default();
        scene.hole.spin = 0.0;
        scene.camera.r = 6.0;
        scene.camera.theta_deg = if kind == ObserverKind::Orbit {
            90.0
        } else {
            80.0
        };
        scene.observer.kind = kind;
        write_wav(
            &folder.join(name).with_extension("wav"),
            &flown(scene, burns)?,
        )?;
    }
    Ok(())
}

/// The sound of a flight, whose own time passes by one r_s/c per second.
fn flown(mut scene: Scene, burns: bool) -> Result<Vec<f32>, Box<dyn Error>> {
    let ship = board(&scene, &Mount::NOSE)?;
    let mut flight = Flight::new(ship, Rocket::new(10.0, 2.0 * THRUST, 1.0)?);
    let mut cockpit = Cockpit::new(RATE, 1);
    let mut samples = Vec::new();
    let mut flux = 0.0;
    for frame in 0..SECONDS * FRAMES {
        let time = f64::from(frame) / f64::from(FRAMES);
        let thrust = if burns && (BURN[0]..BURN[1]).contains(&time) {
            Thrust::Along(Heading::Outward, THRUST)
        } else {
            Thrust::Off
        };
        flight.order(Orders {
            thrust,
            ..Orders::COAST
        });
        flight.advance(1.0 / f64::from(FRAMES))?;
        if frame % 6 == 0 {
            write_scene(&flight.ship, &Mount::NOSE, &mut scene)?;
            let exposure = roughly_metered_exposure(&scene)?;
            flux = exposure.map_or(flux, flux_of_exposure);
        }
        let readings = Readings {
            home_light: Clocks::new(&flight.ship).home_light,
            thrust: flight.acceleration().length() / flight.rocket.max_acceleration(),
            flux,
            volume: 1.0,
        };
        if frame % FRAMES == 0 {
            println!("{time:4.0} s  r {:.3}  {readings:.3?}", scene.camera.r);
        }
        cockpit.read(readings);
        samples.extend((0..RATE / FRAMES).map(|_| cockpit.sample()));
    }
    Ok(samples)
}

/// Writes samples of one channel as 32-bit numbers (WAVE_FORMAT_IEEE_FLOAT).
fn write_wav(file: &Path, samples: &[f32]) -> std::io::Result<()> {
    let data = 4 * samples.len() as u32;
    let mut bytes = Vec::new();
    bytes.extend(b"RIFF");
    bytes.extend((36 + data).to_le_bytes());
    bytes.extend(b"WAVEfmt ");
    for (number, size) in [
        (16, 4),
        (3, 2),
        (1, 2),
        (RATE, 4),
        (4 * RATE, 4),
        (4, 2),
        (32, 2),
    ] {
        bytes.extend(&number.to_le_bytes()[..size]);
    }
    bytes.extend(b"data");
    bytes.extend(data.to_le_bytes());
    bytes.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
    std::fs::write(file, bytes)
}
