//! The colour of thermal light: Planck's spectrum, seen by the CIE 1931 2-degree observer, in
//! linear sRGB. The twin in WGSL is shaders/spectrum.wgsl, which samples the table made here.
//!
//! A colour is per unit of bolometric flux, so that it depends only on the temperature: light of
//! temperature T and relative flux F, seen with the frequency ratio g, has the colour `colour(g T)`
//! times F g^4. The unit is chosen so that 6500 K has the luminance Y = 1.
//!
//! Colours outside the gamut (red below 1900 K) have a negative channel, which is clipped only when
//! the colour is shown.

use glam::{DMat3, DVec3};
use std::sync::LazyLock;

/// Number of entries of the table.
pub const TABLE_LEN: usize = 512;

/// Temperature of the table's first entry, in kelvin.
pub const TABLE_MIN_TEMPERATURE: f64 = 500.0;

/// Temperature of the table's last entry, in kelvin.
pub const TABLE_MAX_TEMPERATURE: f64 = 1e6;

/// The temperature whose light has the luminance one per unit of bolometric flux, in kelvin.
pub const WHITE_TEMPERATURE: f64 = 6500.0;

/// The colour-matching functions. The file and the notice next to it name the source and licence.
const CIE_1931: &str = include_str!("../../../assets/cie1931.csv");

/// Number of wavelengths that are summed: 380, 390, ... 780 nm.
const WAVELENGTHS: usize = 41;

/// Second radiation constant h c / k_B, in nm K (CODATA 2018; exact except for rounding).
const SECOND_RADIATION: f64 = 14_387_768.77;

/// Spectral radiance of a black body, in arbitrary units, at `wavelength_nm` and `temperature`
/// (kelvin): 1 / (lambda^5 (exp(c_2 / (lambda T)) - 1)), lambda in micrometres. Planck's law.
pub fn planck(wavelength_nm: f64, temperature: f64) -> f64 {
    let micrometres = wavelength_nm / 1000.0;
    1.0 / (micrometres.powi(5) * (SECOND_RADIATION / (wavelength_nm * temperature)).exp_m1())
}

/// The 41 samples (wavelength in nm; x, y, z) of the colour-matching functions, from 380 to 780 nm.
///
/// # Errors
/// One sentence, if the asset lacks a sample or has a line that is not four numbers.
pub fn colour_matching() -> Result<[(f64, DVec3); WAVELENGTHS], String> {
    let mut samples = [None; WAVELENGTHS];
    let lines = CIE_1931
        .lines()
        .enumerate()
        .filter(|(_, line)| !line.starts_with('#') && !line.trim().is_empty());
    // The first line that is not a comment names the columns.
    for (number, line) in lines.skip(1) {
        let numbers: Vec<f64> = line
            .split(',')
            .map_while(|field| field.trim().parse().ok())
            .collect();
        let [wavelength, x, y, z] = numbers[..] else {
            return Err(format!(
                "cie1931.csv, line {}: expected four numbers, found \"{line}\"",
                number + 1
            ));
        };
        for (i, sample) in (0_u32..).zip(&mut samples) {
            if wavelength == 380.0 + 10.0 * f64::from(i) {
                *sample = Some((wavelength, DVec3::new(x, y, z)));
            }
        }
    }
    let missing = samples
        .iter()
        .position(Option::is_none)
        .map(|i| 380 + 10 * i);
    missing.map_or(Ok(samples.map(Option::unwrap_or_default)), |nm| {
        Err(format!("cie1931.csv has no line for {nm} nm"))
    })
}

/// CIE XYZ of a black body of `temperature` (kelvin), summed over the 41 samples; in arbitrary
/// units per unit of radiance at each wavelength.
pub fn black_body_xyz(temperature: f64) -> DVec3 {
    MATCHING
        .iter()
        .map(|(wavelength, response)| planck(*wavelength, temperature) * *response)
        .sum()
}

/// CIE XYZ of light of one wavelength (nm) and of unit flux, linear between the samples and zero
/// outside them; in arbitrary units.
pub fn line_xyz(wavelength_nm: f64) -> DVec3 {
    let (first, step) = (MATCHING[0].0, MATCHING[1].0 - MATCHING[0].0);
    let place = (wavelength_nm - first) / step;
    if !(0.0..=(WAVELENGTHS - 1) as f64).contains(&place) {
        return DVec3::ZERO;
    }
    let low = (place as usize).min(WAVELENGTHS - 2);
    MATCHING[low]
        .1
        .lerp(MATCHING[low + 1].1, place - low as f64)
}

/// The matrix from XYZ to linear sRGB, with Rec. 709's primaries and white D65 at Y = 1. Derived
/// from the chromaticities in ITU-R BT.709-6 table 1 items 1.3 and 1.4.
pub fn rgb_from_xyz() -> DMat3 {
    *RGB_FROM_XYZ
}

static RGB_FROM_XYZ: LazyLock<DMat3> = LazyLock::new(|| {
    let xyz = |x: f64, y: f64| DVec3::new(x / y, 1.0, (1.0 - x - y) / y);
    let primaries = DMat3::from_cols(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
    let amounts = primaries.inverse() * xyz(0.3127, 0.3290);
    (primaries * DMat3::from_diagonal(amounts)).inverse()
});

/// Linear sRGB of a black body of `temperature` (kelvin), per unit of bolometric flux (sigma T^4),
/// by direct summation.
pub fn colour(temperature: f64) -> [f64; 3] {
    let per_flux = (WHITE_TEMPERATURE / temperature).powi(4) / black_body_xyz(WHITE_TEMPERATURE).y;
    (rgb_from_xyz() * black_body_xyz(temperature) * per_flux).to_array()
}

/// The table that the shader samples. Entry i is for ln T = ln 500 + i ln(2000) / 511 and holds the
/// colour divided by its largest channel, and the natural logarithm of that channel. All four
/// vary slowly enough for linear interpolation in ln T. The colour itself does not: it falls like
/// exp(-c/T).
pub fn table() -> Vec<[f32; 4]> {
    (0..TABLE_LEN)
        .map(|i| {
            let share = i as f64 / (TABLE_LEN - 1) as f64;
            let rgb = DVec3::from(colour(
                TABLE_MIN_TEMPERATURE * (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).powf(share),
            ));
            let largest = rgb.max_element();
            let [r, g, b] = (rgb / largest).as_vec3().to_array();
            [r, g, b, largest.ln() as f32]
        })
        .collect()
}

/// The colour that the shader looks up in `table` for `temperature` (kelvin), in f64 and before
/// clipping. A temperature outside the table is replaced by the first or last one in it.
pub fn sample(table: &[[f32; 4]], temperature: f64) -> [f64; 3] {
    let share = (temperature.max(TABLE_MIN_TEMPERATURE) / TABLE_MIN_TEMPERATURE).ln()
        / (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).ln();
    let position = share.min(1.0) * (table.len() - 1) as f64;
    let low = (position.floor() as usize).min(table.len().saturating_sub(2));
    let weight = position - low as f64;
    let [r, g, b, ln_scale]: [f64; 4] = std::array::from_fn(|i| {
        (1.0 - weight) * f64::from(table[low][i]) + weight * f64::from(table[low + 1][i])
    });
    [r, g, b].map(|channel| channel * ln_scale.exp())
}

/// The colour-matching functions, parsed once. The asset is compiled in, and a test parses it.
static MATCHING: LazyLock<[(f64, DVec3); WAVELENGTHS]> = LazyLock::new(|| {
    colour_matching().expect("assets/cie1931.csv is compiled in and a test reads it")
});
