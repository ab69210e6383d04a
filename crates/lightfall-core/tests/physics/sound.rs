//! The sound of the ship's cockpit, measured from its samples.

use super::assert_close;
use lightfall_core::optics::ship::{Clocks, Mount, board};
use lightfall_core::optics::sound::{
    AUDIBLE, CEILING, CLICK_RATES, Cockpit, Readings, SAMPLE_RATES, beacon_frequency, click_rate,
    flux_of_exposure, limited,
};
use lightfall_core::random::Random;
use lightfall_core::scene::{ObserverKind, Scene};

const RATE: u32 = 48_000;
const SEED: u64 = 7;

/// Nothing but the beacon, at full volume.
fn beacon(g: f64) -> Readings {
    Readings {
        home_light: g,
        volume: 1.0,
        ..Readings::SILENCE
    }
}

/// Nothing but the engine.
fn engine(thrust: f64) -> Readings {
    Readings {
        thrust,
        ..beacon(0.0)
    }
}

/// Nothing but the clicks.
fn clicks(flux: f64) -> Readings {
    Readings {
        flux,
        ..beacon(0.0)
    }
}

/// The samples of some seconds, with the readings at the start of each frame.
fn samples(
    rate: u32,
    seconds: f64,
    frame: f64,
    mut readings: impl FnMut(f64) -> Readings,
) -> Vec<f64> {
    let mut cockpit = Cockpit::new(rate, SEED);
    let mut next_frame = 0.0;
    let count = (seconds * f64::from(rate)) as usize;
    let one = |i: usize| {
        let time = i as f64 / f64::from(rate);
        if time >= next_frame {
            cockpit.read(readings(time));
            next_frame += frame;
        }
        f64::from(cockpit.sample())
    };
    (0..count).map(one).collect()
}

fn steady(rate: u32, seconds: f64, readings: Readings) -> Vec<f64> {
    samples(rate, seconds, seconds, |_| readings)
}

/// The moments, in samples, at which the samples go through zero upward.
fn crossings(samples: &[f64]) -> Vec<f64> {
    let pairs = samples.windows(2).enumerate();
    pairs
        .filter(|(_, pair)| pair[0] < 0.0 && pair[1] >= 0.0)
        .map(|(i, pair)| i as f64 + pair[0] / (pair[0] - pair[1]))
        .collect()
}

/// Mean of the squares.
fn power(samples: &[f64]) -> f64 {
    samples.iter().map(|sample| sample * sample).sum::<f64>() / samples.len() as f64
}

#[test]
fn the_beacon_is_heard_at_220_hertz_times_g_for_every_sample_rate() {
    for rate in [8_000, 44_100, 48_000, 96_000] {
        for g in [0.1, 0.5, 1.0, 2.7, 8.0] {
            let heard = steady(rate, 3.0, beacon(g));
            let times = crossings(&heard[rate as usize..]);
            let span = times[times.len() - 1] - times[0];
            let frequency = (times.len() - 1) as f64 / span * f64::from(rate);
            // Each end is known to better than a sample, of two seconds.
            let bound = 1.0 / f64::from(rate);
            assert_close(
                format!("g {g} at {rate} samples/s"),
                frequency,
                220.0 * g,
                bound,
            );
        }
    }
}

#[test]
fn the_beacon_follows_g_while_it_glides() {
    // What a frame of the window is late on average, and the glide of the tone.
    let (frame, late) = (1.0 / 60.0, 1.0 / 120.0 + 0.02);
    let g = |time: f64| 0.5 + 0.5 * time.max(0.0);
    let heard = samples(RATE, 3.0, frame, |time| beacon(g(time)));
    let times: Vec<f64> = crossings(&heard)
        .iter()
        .map(|time| time / f64::from(RATE))
        .collect();
    let mut worst = 0.0_f64;
    for pair in times.windows(2).filter(|pair| pair[0] > 0.2) {
        let (frequency, middle) = (1.0 / (pair[1] - pair[0]), 0.5 * (pair[0] + pair[1]));
        worst = worst.max((frequency - 220.0 * g(middle - late)).abs());
    }
    // As far as g changes the tone in one frame.
    let bound = 220.0 * 0.5 * frame;
    assert!(worst < bound, "off by {worst} Hz, bound {bound} Hz");
    // No period is lost or doubled: their number is the integral of the frequency, which is late.
    let periods = 220.0 * (0.5 * 3.0 + 0.25 * 9.0) - late * 220.0 * 1.5;
    let found = times.len() as f64;
    assert!(
        (found - periods).abs() < 1.5,
        "{found} periods, expected {periods}"
    );
}

#[test]
fn the_beacon_goes_on_through_the_horizon_as_light_that_falls_in_does() {
    for r in [6.0, 1.5, 1.0, 0.5, 0.25] {
        let mut scene = Scene::default();
        scene.hole.spin = 0.0;
        scene.camera.r = r;
        scene.observer.kind = ObserverKind::Rain;
        let ship = board(&scene, &Mount::NOSE).unwrap();
        let heard = beacon_frequency(Clocks::new(&ship).home_light).unwrap();
        // Rain without spin measures radial light with 1/(1 + sqrt(1/r)) (Taylor & Wheeler 2000,
        // "Exploring Black Holes", ch. B); home is at 1000 r_s.
        let expected = 220.0 / (1.0 + (1.0 / r).sqrt()) * (1.0 - 1e-3_f64).sqrt();
        assert_close(format!("r {r}"), heard, expected, 1e-12);
    }
}

#[test]
fn the_receiver_is_silent_beyond_what_is_audible() {
    for g in [0.0, -1.0, 0.09, 32.1, f64::INFINITY, f64::NAN] {
        assert_eq!(beacon_frequency(g), None, "{g}");
        let heard = steady(RATE, 0.1, beacon(g));
        assert!(heard.iter().all(|sample| *sample == 0.0), "{g}");
    }
    assert_eq!(beacon_frequency(32.0), Some(AUDIBLE[1]));
}

#[test]
fn the_power_of_the_engines_noise_is_as_the_square_of_thrust() {
    let full = steady(RATE, 4.0, engine(0.8));
    // Noise without a limiter at work: the same for every thrust but for the factor, to the digits
    // of a sample.
    assert!(full.iter().all(|sample| sample.abs() < 0.6));
    for thrust in [0.4, 0.1, 0.01] {
        let weaker = steady(RATE, 4.0, engine(thrust));
        let expected = power(&full) * (thrust / 0.8_f64).powi(2);
        assert_close(
            format!("thrust {thrust}"),
            power(&weaker),
            expected,
            2.0_f64.powi(-23),
        );
    }
    assert_eq!(power(&steady(RATE, 1.0, engine(0.0))), 0.0);
}

#[test]
fn the_engine_is_about_as_loud_for_every_sample_rate() {
    let levels = [8_000, 44_100, 96_000].map(|rate| power(&steady(rate, 4.0, engine(0.5))));
    for level in levels {
        // Half of its hertz are below the noise's cutoff, so four seconds tell its power to about
        // three percent; at 8000 samples a second the filter is a fifth wider.
        assert_close("power of the noise", level, levels[1], 0.25);
    }
}

/// How many clicks begin in these samples.
fn number_of_clicks(samples: &[f64]) -> usize {
    let dead = (0.003 * f64::from(RATE)) as usize;
    let (mut count, mut ends) = (0, 0);
    for (i, sample) in samples.iter().enumerate() {
        if *sample != 0.0 && i >= ends {
            count += 1;
            ends = i + dead - 1;
        }
    }
    count
}

#[test]
fn clicks_come_as_often_as_their_law_says() {
    for flux in [0.01, 1.0, 100.0, 4096.0, 1e9] {
        let seconds = 120.0;
        let expected = click_rate(flux) * seconds;
        let found = number_of_clicks(&steady(RATE, seconds, clicks(flux))) as f64;
        // Three standard deviations of a Poisson distribution.
        assert!(
            (found - expected).abs() < 3.0 * expected.sqrt(),
            "flux {flux}: {found} clicks, expected {expected}"
        );
    }
    assert_eq!(number_of_clicks(&steady(RATE, 10.0, clicks(0.0))), 0);
}

#[test]
fn the_law_of_the_clicks_is_a_cube_root_with_limits() {
    assert_eq!(click_rate(flux_of_exposure(0.0)), 4.0);
    assert_close("eight times the flux", click_rate(8.0), 8.0, 1e-15);
    let [low, high] = CLICK_RATES;
    // The light meter's range.
    assert_close(
        "brightest",
        click_rate(flux_of_exposure(-12.0)),
        high,
        1e-15,
    );
    assert!(click_rate(flux_of_exposure(7.0)) > low);
    assert_eq!([1e-300, 1e300].map(click_rate), [low, high]);
    for none in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert_eq!(click_rate(none), 0.0, "{none}");
    }
}

#[test]
fn no_reading_makes_a_sample_that_is_no_number_or_beyond_full_scale() {
    let values = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN_POSITIVE,
        -1.0,
        0.0,
        0.7,
        1.0,
        30.0,
    ];
    for rate in [0, RATE, u32::MAX] {
        let mut cockpit = Cockpit::new(rate, SEED);
        for i in 0..10_000 {
            let of = |place: u32| values[i / 10_usize.pow(place) % 10];
            cockpit.read(Readings {
                home_light: of(0),
                thrust: of(1),
                flux: of(2),
                volume: of(3),
            });
            for _ in 0..20 {
                let sample = f64::from(cockpit.sample());
                assert!(sample.abs() <= CEILING, "{sample} of reading {i}");
            }
        }
    }
    assert!(limited(f64::MAX) <= CEILING && limited(-f64::MAX) >= -CEILING);
    assert_eq!(
        SAMPLE_RATES.map(|rate| Cockpit::new(rate, 0).sample()),
        [0.0; 2]
    );
}

#[test]
fn readings_that_jump_make_no_jumps_of_the_samples() {
    let step = |samples: &[f64]| {
        let pairs = samples.windows(2);
        pairs
            .map(|pair| (pair[1] - pair[0]).abs())
            .fold(0.0, f64::max)
    };
    let loud = Readings {
        thrust: 1.0,
        ..beacon(2.0)
    };
    let usual = step(&steady(RATE, 4.0, loud));
    let mut random = Random::new(SEED);
    let jumping = samples(RATE, 4.0, 0.005, |_| Readings {
        home_light: if random.one_in(3) {
            0.0
        } else {
            2.0 * random.unit()
        },
        thrust: f64::from(u8::from(random.one_in(2))),
        flux: 0.0,
        volume: f64::from(u8::from(random.one_in(2))),
    });
    // A tone or noise that were switched would step by its amplitude, 0.2 and more.
    let found = step(&jumping);
    assert!(usual < 0.1, "{usual}");
    assert!(found < 1.1 * usual, "{found}, and {usual} without jumps");
}

#[test]
fn volume_zero_fades_to_exact_silence() {
    let heard = samples(RATE, 3.0, 0.5, |time| Readings {
        volume: if time < 0.5 { 1.0 } else { 0.0 },
        flux: 1.0,
        thrust: 0.5,
        ..beacon(1.0)
    });
    let second = RATE as usize;
    assert!(power(&heard[..second / 2]) > 1e-3);
    assert!(heard[second..].iter().any(|sample| *sample != 0.0));
    // The fade takes 0.05 s times ln(1e9), 1.04 s.
    assert!(heard[2 * second..].iter().all(|sample| *sample == 0.0));
}

#[test]
fn the_same_seed_gives_the_same_samples() {
    let heard = |seed| {
        let mut cockpit = Cockpit::new(RATE, seed);
        cockpit.read(Readings {
            thrust: 1.0,
            flux: 4096.0,
            ..beacon(1.0)
        });
        (0..10_000).map(|_| cockpit.sample()).collect::<Vec<_>>()
    };
    assert_eq!(heard(1), heard(1));
    assert_ne!(heard(1), heard(2));
}
