//! The colour of a nebula: hydrogen that young stars ionise shines in a few lines.

use crate::spectrum;
use glam::DVec3;
use std::array;

/// The lines of a nebula behind two and a half magnitudes of dust: wavelength in nm and share of the
/// energy over that of H-alpha. Hydrogen alone has 0.35 in H-beta (Osterbrock & Ferland 2006, table
/// 4.4, case B at 10 000 K), and dust takes more of the blue. The line of oxygen differs between
/// nebulae; it is weak in those that look pink.
const LINES: [(f64, f64); 3] = [(656.3, 1.0), (486.1, 0.16), (500.7, 0.15)];

/// The frequency ratios of the first and the last entry of [`table`]. Below the first one all lines
/// are infrared, and above the last one ultraviolet.
pub const MIN_SHIFT: f64 = 0.62;
/// See [`MIN_SHIFT`].
pub const MAX_SHIFT: f64 = 1.73;

/// Number of entries of [`table`].
pub const TABLE_LEN: usize = 32;

/// Linear sRGB of a nebula per unit of flux, seen with the frequency ratio `g`. Each line is seen at
/// its wavelength over g. The unit is chosen so that g = 1 has the luminance one, as far as a screen
/// shows its colour.
pub fn colour(g: f64) -> DVec3 {
    let seen = |g: f64| -> DVec3 {
        let lines = LINES.map(|(wavelength, share)| share * spectrum::line_xyz(wavelength / g));
        let rgb = spectrum::rgb_from_xyz() * lines.into_iter().sum::<DVec3>();
        rgb.max(DVec3::ZERO)
    };
    seen(g) / LUMINANCE.dot(seen(1.0))
}

/// The luminance of linear sRGB (ITU-R BT.709-6, item 3.2).
const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// The table that the shader samples: [`colour`] at equal steps of ln g.
pub fn table() -> [DVec3; TABLE_LEN] {
    array::from_fn(|i| {
        let share = i as f64 / (TABLE_LEN - 1) as f64;
        colour(MIN_SHIFT * (MAX_SHIFT / MIN_SHIFT).powf(share))
    })
}
