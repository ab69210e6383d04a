//! The great clouds of dust near the Sun, which make the dark lanes of the Milky Way.

use glam::DVec3;
use lightfall_optics::stars::celestial_direction;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// A cloud: a ball without edge. Places and distances are rounded from what is known of the real
/// clouds (Dame et al. 1987, ApJ 322, 706; Zucker et al. 2020, A&A 633, A51). Sizes and depths are
/// choices.
struct Cloud {
    /// Galactic longitude and latitude in degrees, and distance in kpc.
    place: [f64; 3],
    /// Standard deviation of its density, in kpc.
    size: f64,
    /// Extinction through its middle, in magnitudes V.
    depth: f64,
}

const fn cloud(longitude: f64, latitude: f64, distance: f64, size: f64, depth: f64) -> Cloud {
    Cloud {
        place: [longitude, latitude, distance],
        size,
        depth,
    }
}

/// The Great Rift from the centre to Cygnus, then the others by longitude.
const CLOUDS: [Cloud; 26] = [
    cloud(1.0, 5.0, 0.15, 0.008, 1.6), // Pipe
    cloud(9.0, 4.0, 0.16, 0.014, 1.7),
    cloud(19.0, 4.5, 0.23, 0.025, 1.9), // Serpens
    cloud(28.0, 3.5, 0.27, 0.028, 2.0), // Aquila
    cloud(37.0, 2.5, 0.35, 0.032, 1.9),
    cloud(47.0, 1.5, 0.45, 0.035, 1.8),
    cloud(57.0, 1.5, 0.55, 0.040, 1.5), // Vulpecula
    cloud(67.0, 1.5, 0.60, 0.040, 1.3),
    cloud(76.0, 1.0, 0.65, 0.045, 1.2), // Cygnus
    cloud(85.0, 2.0, 0.65, 0.045, 1.1),
    cloud(93.0, 3.5, 0.60, 0.030, 0.8),
    cloud(110.0, 14.0, 0.35, 0.030, 0.8),  // Cepheus
    cloud(160.0, -19.0, 0.29, 0.016, 0.8), // Perseus
    cloud(164.0, -8.5, 0.47, 0.030, 0.9),  // California
    cloud(171.0, -15.0, 0.14, 0.013, 1.0), // Taurus
    cloud(206.0, -15.0, 0.41, 0.022, 0.8), // Orion B
    cloud(212.0, -19.0, 0.41, 0.020, 0.8), // Orion A
    cloud(222.0, -2.0, 1.00, 0.060, 1.0),  // Canis Major
    cloud(266.0, 1.0, 0.80, 0.060, 1.2),   // Vela
    cloud(300.0, -15.5, 0.18, 0.010, 0.8), // Chamaeleon
    cloud(302.0, -0.5, 0.18, 0.0085, 2.2), // Coalsack
    cloud(317.0, -4.0, 0.60, 0.030, 1.0),  // Circinus
    cloud(339.0, 11.0, 0.16, 0.014, 0.9),  // Lupus
    cloud(347.0, 2.5, 0.20, 0.016, 1.4),   // Scorpius
    cloud(354.0, 15.5, 0.14, 0.011, 1.2),  // Ophiuchus
    cloud(0.0, -18.5, 0.15, 0.006, 0.7),   // Corona Australis
];

/// The clouds' middles, sizes and densities in the middle.
static PLACED: LazyLock<[(DVec3, f64, f64); CLOUDS.len()]> = LazyLock::new(|| {
    CLOUDS.map(|Cloud { place, size, depth }| {
        let [longitude, latitude, distance] = place;
        let middle = distance * celestial_direction(longitude, latitude);
        (middle, size, depth / (size * TAU.sqrt()))
    })
});

/// Extinction of the clouds at a point (kpc, galactic axes), in magnitudes V per kpc.
pub(crate) fn extinction(point: DVec3) -> f64 {
    PLACED
        .iter()
        .map(|(middle, size, density)| {
            let square = (point - middle).length_squared() / (size * size);
            // Farther out a cloud is less than a thousandth of its middle.
            if square > 14.0 {
                0.0
            } else {
                density * (-0.5 * square).exp()
            }
        })
        .sum()
}
