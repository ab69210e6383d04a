//! Thermal colours against the laws of radiation, published chromaticities and direct summation.

use crate::assert_close;
use glam::DVec3;
use lightfall_core::optics::spectrum::{
    TABLE_LEN, TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE, black_body_xyz, colour,
    colour_matching, planck, rgb_from_xyz, sample, table,
};
use std::f64::consts::PI;

/// The tolerance is 1e-3 of the largest channel, and the largest error is printed. The temperatures
/// lie between the knots, at an irrational spacing.
#[test]
fn spectrum_table_is_good_to_a_thousandth_from_1000_to_100000_kelvin() {
    let table = table();
    assert_eq!(table.len(), TABLE_LEN);
    let mut worst = (0.0_f64, 0.0);
    let mut temperature = 1000.0_f64;
    while temperature < 100_000.0 {
        let (direct, looked_up) = (colour(temperature), sample(&table, temperature));
        let brightest = direct.into_iter().fold(0.0, f64::max);
        for (a, b) in direct.into_iter().zip(looked_up) {
            let error = (a - b).abs() / brightest;
            if error > worst.0 {
                worst = (error, temperature);
            }
        }
        temperature *= 1.0 + 1e-3 / PI;
    }
    println!("worst error of the look-up: {:e} at {} K", worst.0, worst.1);
    assert!(
        worst.0 <= 1e-3,
        "worst error {:e} at {} K",
        worst.0,
        worst.1
    );
}

/// At a knot the look-up equals the direct sum, except for the rounding of f32, which the magnitude
/// of the logarithm amplifies.
#[test]
fn spectrum_table_holds_the_direct_sum_at_its_knots() {
    let table = table();
    for i in [0, 100, 255, 511] {
        let temperature = TABLE_MIN_TEMPERATURE
            * (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).powf(i as f64 / 511.0);
        let (direct, looked_up) = (colour(temperature), sample(&table, temperature));
        let brightest = direct.into_iter().fold(0.0, f64::max);
        for (a, b) in direct.into_iter().zip(looked_up) {
            assert!(
                (a - b).abs() < 1e-5 * brightest,
                "{temperature} K: {direct:?} and {looked_up:?}"
            );
        }
    }
}

/// Outside its range the table returns its first or last entry, and no temperature panics.
#[test]
fn spectrum_table_answers_every_temperature() {
    let table = table();
    assert_eq!(sample(&table, 1.0), sample(&table, TABLE_MIN_TEMPERATURE));
    assert_eq!(sample(&table, 1e9), sample(&table, TABLE_MAX_TEMPERATURE));
    for temperature in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        assert!(
            sample(&table, temperature).into_iter().all(f64::is_finite),
            "{temperature} K"
        );
    }
}

/// Wien: lambda_max T = c_2 / 4.965114231744276 (the root of x = 5 (1 - exp(-x))).
#[test]
fn planck_peaks_at_wiens_wavelength() {
    for temperature in [3000.0, 6500.0, 30_000.0] {
        let peak = 14_387_768.77 / 4.965_114_231_744_276 / temperature;
        let at = |x: f64| planck(peak * x, temperature);
        assert!(
            at(1.0) > at(1.001) && at(1.0) > at(0.999),
            "{temperature} K"
        );
    }
}

/// Stefan-Boltzmann: the integral over all wavelengths is pi^4/15 (T/c_2)^4 in these units. The
/// trapezoidal rule in ln(lambda) converges faster than any power, so 1e-10 is only the error of
/// the truncated ends.
#[test]
fn planck_integrates_to_the_fourth_power_of_the_temperature() {
    for temperature in [1000.0, 6500.0, 1e5] {
        let step = 0.01;
        let sum: f64 = (-600..2000)
            .map(|i| {
                let wavelength_nm = 14_387_768.77 / temperature / 5.0 * (step * f64::from(i)).exp();
                planck(wavelength_nm, temperature) * wavelength_nm / 1000.0 * step
            })
            .sum();
        let expected = PI.powi(4) / 15.0 * (temperature / 14_387.768_77).powi(4);
        assert_close(format_args!("{temperature} K"), sum, expected, 1e-10);
    }
}

/// CIE 015: illuminant A, a black body of 2848 K on the old c_2 of 14350 um K, has x = 0.44757, y =
/// 0.40745. The asset summed as the CIE does, every 5 nm from 380 to 780, gives all five digits;
/// the 41 samples alone differ by 1e-4, which is their own error.
#[test]
fn black_body_of_illuminant_a_has_its_published_chromaticity() {
    let temperature = 2848.0 * 14_387.768_77 / 14_350.0;
    let every_five: DVec3 = include_str!("../../../../assets/cie1931.csv")
        .lines()
        .filter(|line| line.starts_with(|first: char| first.is_ascii_digit()))
        .map(|line| {
            let [wavelength, x, y, z] = line
                .split(',')
                .map(|f| f.parse().unwrap())
                .collect::<Vec<f64>>()[..]
            else {
                panic!("four numbers expected in {line}")
            };
            let counts = wavelength % 5.0 == 0.0 && (380.0..=780.0).contains(&wavelength);
            f64::from(u8::from(counts)) * planck(wavelength, temperature) * DVec3::new(x, y, z)
        })
        .sum();
    for (what, xyz, tolerance) in [
        ("every 5 nm", every_five, 6e-6),
        ("41 samples", black_body_xyz(temperature), 1.2e-4),
    ] {
        let (x, y) = (xyz.x / xyz.element_sum(), xyz.y / xyz.element_sum());
        assert!(
            (x - 0.44757).abs() < tolerance && (y - 0.40745).abs() < tolerance,
            "{what}: x = {x}, y = {y}"
        );
    }
}

/// IEC 61966-2-1's matrix, given to four digits.
#[test]
fn the_srgb_matrix_has_the_published_values() {
    let published = [
        [3.2406, -1.5372, -0.4986],
        [-0.9689, 1.8758, 0.0415],
        [0.0557, -0.2040, 1.0570],
    ];
    for (row, expected) in published.into_iter().enumerate() {
        for (column, expected) in expected.into_iter().enumerate() {
            let found = rgb_from_xyz().col(column)[row];
            assert!(
                (found - expected).abs() < 1e-3,
                "row {row}, column {column}: {found}"
            );
        }
    }
}

/// 6500 K lies just below daylight D65: nearly white, with luminance one by definition.
#[test]
fn black_body_of_6500_kelvin_is_nearly_white_with_luminance_one() {
    let [r, g, b] = colour(6500.0);
    assert_close("luminance", 0.2126 * r + 0.7152 * g + 0.0722 * b, 1.0, 1e-3);
    for channel in [r, g, b] {
        assert!((channel - 1.0).abs() < 0.1, "{r} {g} {b}");
    }
}

#[test]
fn cool_light_is_red_and_hot_light_is_blue() {
    let (cool, hot) = (colour(3000.0), colour(20_000.0));
    assert!(cool[0] > cool[1] && cool[1] > cool[2], "{cool:?}");
    assert!(hot[2] > hot[1] && hot[1] > hot[0], "{hot:?}");
}

#[test]
fn cie_asset_holds_the_41_samples() {
    let samples = colour_matching().unwrap();
    // y peaks at 555 nm with 1; at 560 nm it is 0.995 (CIE 1931).
    assert_close("y at 560 nm", samples[18].1.y, 0.995, 1e-9);
    assert_eq!(samples[18].0, 560.0);
}
