//! The colour of synchrotron light: the spectrum nu^-0.6 exp(-nu/nu_c), seen by the CIE 1931 2-degree
//! observer, in linear sRGB. The twin in WGSL is shaders/medium/jet.wgsl, which samples the table made
//! here.
//!
//! As in [`spectrum`](crate::spectrum), a colour is per unit of bolometric flux, in the same unit: light
//! with the frequency nu_c where its matter is at rest has the colour `colour(g nu_c)` times g^4.

use crate::spectrum::{WHITE_TEMPERATURE, black_body_xyz, colour_matching, planck, rgb_from_xyz};
use glam::DVec3;
use std::sync::LazyLock;

/// Number of entries of the table.
pub const TABLE_LEN: usize = 400;
/// nu_c of the table's first and last entries, over 540 THz. Light below is darker than the first entry,
/// whose largest channel is 2e-7 of the brightest entry's.
pub const TABLE_RANGE: [f64; 2] = [0.05, 5000.0];
/// The power of nu_c with which light falls beyond the table's last entry, where all that is visible lies
/// on the power law. The error is 2e-4, nu/nu_c at the last entry.
pub const FALL_BEYOND_TABLE: f64 = 1.0 - INDEX;

/// Minus the power of the spectrum: that of electrons whose number falls with the energy to the power
/// -2.2 (Rybicki & Lightman 1979, eq. 6.22).
const INDEX: f64 = 0.6;
/// Gamma(1 - INDEX): the integral of v^-INDEX e^-v.
const GAMMA: f64 = 2.218_159_543_757_688;
/// Wavelength of light of 540 THz, in nm.
const GREEN_NM: f64 = 555.0;
/// Wavelengths between which a black body radiates, in nm.
const THERMAL_NM: [f64; 2] = [50.0, 4e4];

/// Linear sRGB of light whose spectrum falls off at `frequency`, over 540 THz, per unit of bolometric
/// flux, by direct summation.
pub fn colour(frequency: f64) -> [f64; 3] {
    let xyz: DVec3 = MATCHING
        .iter()
        .map(|(wavelength, response)| {
            let nu = GREEN_NM / wavelength;
            let v = nu / frequency;
            // I_lambda = I_nu nu^2/555 nm, and the integral of I_nu is one.
            let of_frequency = v.powf(-INDEX) * (-v).exp() / (frequency * GAMMA);
            of_frequency * nu * nu / GREEN_NM * *response
        })
        .sum();
    (rgb_from_xyz() * xyz * *BLACK_BODY).to_array()
}

/// The table that the shader samples. Entry i is for ln nu_c between the ends of [`TABLE_RANGE`] and
/// holds the colour divided by its largest channel, and the natural logarithm of that channel.
pub fn table() -> Vec<[f32; 4]> {
    let [low, high] = TABLE_RANGE;
    (0..TABLE_LEN)
        .map(|i| {
            let share = i as f64 / (TABLE_LEN - 1) as f64;
            let rgb = DVec3::from(colour(low * (high / low).powf(share)));
            let largest = rgb.max_element();
            let [r, g, b] = (rgb / largest).as_vec3().to_array();
            [r, g, b, largest.ln() as f32]
        })
        .collect()
}

/// The flux of a black body of 6500 K over its luminance, whose unit is that of the colours.
static BLACK_BODY: LazyLock<f64> = LazyLock::new(|| {
    let temperature = WHITE_TEMPERATURE;
    let [low, high] = THERMAL_NM;
    let rate = |ln_nm: f64| planck(ln_nm.exp(), temperature) * ln_nm.exp();
    let flux = lightfall_model::geometry::quadrature::integral(low.ln(), high.ln(), &rate);
    flux / black_body_xyz(temperature).y
});

/// The colour-matching functions, parsed once. The asset is compiled in, and a test parses it.
static MATCHING: LazyLock<Vec<(f64, DVec3)>> = LazyLock::new(|| {
    colour_matching()
        .expect("assets/cie1931.csv is compiled in and a test reads it")
        .to_vec()
});
