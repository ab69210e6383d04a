//! Tabulated delays.

use super::{CLAIM, flat_ray, pixel_scene, through_pixel};
use crate::echo::ON_THE_AXIS;
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::schwarzschild::CRITICAL_IMPACT;
use lightfall_core::optics::reference::HoleAndDisk;
use lightfall_core::optics::trace::Hit;
use std::f64::consts::{FRAC_PI_2, PI};

/// Half of the last of nine decimals, besides the claim.
const NINE_DECIMALS: f64 = 0.5e-9 + CLAIM;

/// Half of the last of eight decimals, besides the claim.
const EIGHT_DECIMALS: f64 = 0.5e-8 + CLAIM;

/// Radius, azimuth, redshift and delay of a hit.
type Row = [f64; 4];

/// Static camera at 20 r_s, 83 degrees from the axis, 960 x 540 pixels, 50 degrees high; disk from
/// the innermost stable orbit to 11 r_s. For each pixel the first hit without spin and with
/// chi = 0.9. From the orbit's equation with 30 digits without spin, and from Hamilton's equations
/// in Boyer-Lindquist coordinates.
pub const PIXELS: [([f64; 2], Option<Row>, Row); 9] = [
    (
        [200.5, 300.5],
        Some([8.982567384, -0.840521083, 1.219729203, 16.537330074]),
        [8.986950031, -0.842342769, 1.217094232, 16.517843719],
    ),
    (
        [760.5, 300.5],
        Some([8.999380567, 0.842295606, 0.760021468, 16.546653497]),
        [8.979773081, 0.838791605, 0.762362899, 16.559420831],
    ),
    (
        [480.5, 150.5],
        Some([6.241008452, 3.141082740, 0.893525711, 30.685644158]),
        [6.368636016, 3.047345431, 0.900556035, 30.803226826],
    ),
    (
        [430.5, 190.5],
        Some([3.119340583, -3.065856879, 0.948458857, 27.874973231]),
        [3.986957905, 3.073084983, 0.967767788, 28.556943056],
    ),
    (
        [600.5, 215.5],
        Some([6.699634334, 2.878389570, 0.773522909, 30.383614843]),
        [5.302591279, 2.784404942, 0.710350616, 29.122661924],
    ),
    (
        [300.5, 240.5],
        Some([8.724456533, -2.503525406, 1.118491441, 30.267749611]),
        [9.450462177, -2.531218118, 1.102140461, 30.897684985],
    ),
    (
        [480.5, 380.5],
        Some([6.669360707, -3.141041209, 0.902623438, 32.078323385]),
        [6.932004168, 3.022627043, 0.910887901, 32.328708438],
    ),
    (
        [560.5, 352.5],
        Some([8.567811095, -3.023233526, 0.864183432, 34.179732699]),
        [5.589897134, 3.115398545, 0.771765004, 31.177793350],
    ),
    (
        [410.5, 262.5],
        None,
        [1.948238433, -2.490531801, 1.421139822, 25.191397073],
    ),
];

/// The same camera 60 degrees from the axis: pixel, spin, and both hits.
const TWO_HITS: [([f64; 2], f64, [Row; 2]); 4] = [
    (
        [540.5, 330.5],
        0.0,
        [
            [3.94808682, 0.46364761, 0.69313924, 19.00308274],
            [3.76490230, -2.67794504, 0.67563984, 31.05093968],
        ],
    ),
    (
        [480.5, 341.5],
        0.9,
        [
            [4.08223998, -0.00937066, 0.82996017, 18.39071067],
            [1.56885948, 2.51639004, 0.53005026, 28.76718392],
        ],
    ),
    (
        [540.5, 330.5],
        0.9,
        [
            [3.91740424, 0.44639800, 0.70886648, 19.01640148],
            [1.63585671, 3.00530665, 0.35886369, 29.23910281],
        ],
    ),
    (
        [430.5, 330.5],
        0.9,
        [
            [3.81334713, -0.40346397, 0.94688257, 18.98487568],
            [5.63229826, 2.48274318, 0.95956318, 32.79988610],
        ],
    ),
];

#[track_caller]
fn assert_hit(what: &str, found: Option<Hit>, expected: Row, tolerance: f64) {
    let hit = found.unwrap_or_else(|| panic!("{what}: no hit"));
    let numbers = [hit.r, hit.phi, hit.g, hit.delay.unwrap()];
    for (found, expected) in numbers.into_iter().zip(expected) {
        assert!(
            (found - expected).abs() < tolerance,
            "{what}: {numbers:?} has {found} where {expected} is right"
        );
    }
}

#[test]
fn the_hits_of_pixels_have_their_tabulated_places_shifts_and_delays() {
    for (pixel, without_spin, with_spin) in PIXELS {
        for (spin, expected) in [(0.0, without_spin), (0.9, Some(with_spin))] {
            let trace = through_pixel(&pixel_scene(spin, 83.0), pixel);
            match expected {
                Some(row) => assert_hit(
                    &format!("{pixel:?}, {spin}"),
                    trace.hits[0],
                    row,
                    NINE_DECIMALS,
                ),
                None => assert_eq!(trace.hits, [None; 2], "{pixel:?}, {spin}"),
            }
        }
    }
}

#[test]
fn both_hits_of_a_ray_have_their_tabulated_places_shifts_and_delays() {
    for (pixel, spin, rows) in TWO_HITS {
        let trace = through_pixel(&pixel_scene(spin, 60.0), pixel);
        for (which, row) in rows.into_iter().enumerate() {
            let what = format!("{pixel:?}, {spin}, hit {which}");
            assert_hit(&what, trace.hits[which], row, EIGHT_DECIMALS);
        }
    }
}

/// Radius and lag of the hit of such a ray in an annulus about `radius`.
fn flat_hit(r: f64, b: f64, inward: bool, to_plane: f64, radius: f64) -> [f64; 2] {
    let hole = HoleAndDisk {
        kerr: Kerr { spin: 0.0 },
        annulus: Some([0.9 * radius, 1.1 * radius]),
    };
    let (constants, start) = flat_ray(r, b, inward, to_plane);
    let trace = hole.trace_with_lags(&constants, start);
    let hit = trace.hits[0].unwrap_or_else(|| panic!("from {r}, b = {b}: no hit at {radius}"));
    [hit.r, hit.delay.unwrap()]
}

/// Impact parameter and delay of the image of order `n` of the ring with this radius, seen from the
/// axis at 20 r_s, by the secant method from a good guess.
fn image_of_ring(radius: f64, n: u32, guess: f64) -> [f64; 2] {
    let angle = FRAC_PI_2 + f64::from(n) * PI;
    // b - b_c shrinks by e^pi with each order, and the radius grows evenly in its logarithm.
    let at = |x: f64| flat_hit(20.0, CRITICAL_IMPACT + x.exp(), true, angle, radius);
    let mut x = (guess - CRITICAL_IMPACT).ln();
    let mut before = (x + 1e-6, at(x + 1e-6)[0]);
    for _ in 0..6 {
        let now = (x, at(x)[0]);
        if now.1 == before.1 {
            break;
        }
        x -= (now.1 - radius) * (now.0 - before.0) / (now.1 - before.1);
        before = now;
    }
    let [found, delay] = at(x);
    // The last bit of b, as light next to the critical curve magnifies it.
    let rounding = 8.0 * f64::EPSILON * CRITICAL_IMPACT / x.exp();
    assert!(
        (found / radius - 1.0).abs() < 1e-11 + rounding,
        "{found} for {radius}"
    );
    [CRITICAL_IMPACT + x.exp(), delay]
}

#[test]
fn the_images_of_a_ring_echo_each_other_with_the_tabulated_delays() {
    for (radius, images) in ON_THE_AXIS {
        let found: [[f64; 2]; 3] = std::array::from_fn(|n| {
            let [b, delay] = images[n];
            let image = image_of_ring(radius, n as u32, b);
            // b is tabulated with 12 digits.
            assert!(
                (image[0] - b).abs() < 1e-10,
                "{radius}, {n}: {} and not {b}",
                image[0]
            );
            assert!(
                (image[1] - delay).abs() < CLAIM,
                "{radius}, {n}: {} and not {delay}",
                image[1]
            );
            image
        });
        let second = found[2][1] - found[1][1];
        // One more turn about the photon sphere takes pi b_c; what is missing shrinks by e^pi with
        // each half-turn, and a little more slowly at first.
        let closer = |image: [f64; 2], n| {
            let guess = CRITICAL_IMPACT + (image[0] - CRITICAL_IMPACT) / PI.exp();
            image_of_ring(radius, n, guess)
        };
        let third = closer(found[2], 3);
        let fourth = closer(third, 4);
        let limit = PI * CRITICAL_IMPACT;
        assert!((limit - 8.162_097_139_05).abs() < 1e-11);
        let missing = [second, third[1] - found[2][1], fourth[1] - third[1]].map(|t| t - limit);
        for pair in missing.windows(2) {
            let ratio = pair[0] / pair[1];
            assert!(
                (0.7..1.2).contains(&(ratio / PI.exp())),
                "{radius}: {missing:?}"
            );
        }
    }
}

#[test]
fn rays_outward_from_within_have_the_tabulated_delays() {
    for (r, b, radius, angle, delay) in [
        (1.2, 2.0, 5.0, 1.7354424971674, 8.8073108700147),
        (1.2, 2.59, 8.0, 6.2425900109079, 23.224437316306),
        (1.6, 2.0, 6.0, 1.1771885127546, 7.8477748067569),
    ] {
        let [found, lag] = flat_hit(r, b, false, angle, radius);
        // The angle's last digit, times what light next to the critical curve makes of it.
        assert!((found - radius).abs() < CLAIM, "{r}: {found}");
        assert!((lag - delay).abs() < CLAIM, "{r}: {lag} and not {delay}");
    }
    let hole = Kerr { spin: 0.0 };
    for (r, b, radius, angle, difference) in [
        (0.7, 2.0, 5.0, 2.7187875126451, 2.9272028902628),
        (0.3, 1.5, 9.0, 2.774433860935, 1.8033173958998),
    ] {
        let [found, lag] = flat_hit(r, b, false, angle, radius);
        assert!((found - radius).abs() < CLAIM, "{r}: {found}");
        let ingoing = lag - hole.ingoing_time_lead(found);
        assert!(
            (ingoing - difference).abs() < CLAIM,
            "{r}: {ingoing} and not {difference}"
        );
    }
}
