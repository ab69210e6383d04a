//! Nebulae: clouds of hydrogen that young stars ionise, and remnants of supernovae.

use crate::turbulence::Turbulence;
use glam::DVec3;
use lightfall_optics::stars::celestial_direction;
use std::sync::LazyLock;

/// A nebula on the sky: a ball or a shell without a sharp edge.
struct Nebula {
    /// Right ascension and declination in degrees, J2000.
    place: [f64; 2],
    /// Its radius in degrees. Beyond, it fades.
    radius: f64,
    /// Its brightness in magnitudes per square second of arc.
    magnitude: f64,
    /// Whether it is a shell, which is dark in the middle.
    shell: bool,
}

const fn ball(ra: f64, dec: f64, radius: f64, magnitude: f64) -> Nebula {
    Nebula {
        place: [ra, dec],
        radius,
        magnitude,
        shell: false,
    }
}

const fn shell(ra: f64, dec: f64, radius: f64, magnitude: f64) -> Nebula {
    Nebula {
        shell: true,
        ..ball(ra, dec, radius, magnitude)
    }
}

/// The most conspicuous nebulae. Places and sizes are rounded from the catalogues of Sharpless
/// (1959, ApJS 4, 257) and of Rodgers, Campbell & Whiteoak (1960, MNRAS 121, 103). How bright they
/// are is a choice, after photographs, which show the red of hydrogen better than the eye sees it.
const NEBULAE: [Nebula; 75] = [
    // Orion and Monoceros
    ball(83.8, -5.4, 0.45, 18.9), // Orion Nebula
    ball(83.8, -5.2, 1.1, 21.9),
    ball(83.85, -4.8, 0.3, 21.2),
    ball(85.2, -2.5, 0.55, 21.4), // behind the Horsehead
    ball(85.4, -1.9, 0.3, 20.9),  // Flame
    ball(87.8, 4.0, 1.1, 23.9),   // Barnard's Loop, from north to south
    ball(88.9, 1.8, 1.0, 23.3),
    ball(89.4, -0.4, 1.0, 22.9),
    ball(89.4, -2.6, 1.0, 22.9),
    ball(88.8, -4.8, 1.0, 23.1),
    ball(87.6, -6.8, 1.0, 23.3),
    ball(85.8, -8.6, 1.1, 23.5),
    ball(83.2, -9.9, 1.2, 23.7),
    ball(80.0, -10.2, 1.3, 24.0),
    shell(83.8, 9.9, 3.4, 23.4),   // around lambda Orionis
    shell(97.9, 4.95, 0.7, 21.0),  // Rosette
    ball(100.2, 9.9, 1.0, 22.2),   // Cone
    ball(106.1, -10.6, 1.0, 22.2), // Seagull
    ball(92.4, 20.5, 0.4, 21.6),   // NGC 2174
    shell(94.3, 22.5, 0.4, 22.2),  // IC 443
    // From Perseus and Auriga through Cassiopeia to Cepheus
    ball(60.3, 36.3, 0.9, 21.9), // California
    ball(61.6, 36.4, 0.8, 22.2),
    ball(79.1, 34.4, 0.5, 21.9), // IC 405
    ball(80.7, 33.4, 0.4, 21.8), // IC 410
    shell(84.8, 28.0, 1.5, 23.8),
    shell(38.2, 61.5, 1.2, 21.8), // Heart
    ball(42.8, 60.4, 1.0, 22.0),  // Soul
    ball(13.2, 56.6, 0.35, 21.7), // NGC 281
    shell(0.8, 67.3, 1.1, 22.2),  // NGC 7822
    ball(344.2, 62.6, 0.6, 22.4),
    ball(349.6, 60.6, 0.7, 22.4),
    ball(334.9, 56.1, 0.7, 22.6),
    shell(324.8, 57.5, 1.4, 22.0), // IC 1396
    ball(317.9, 60.0, 1.1, 23.1),
    // Cygnus
    ball(314.8, 44.5, 1.1, 21.1), // North America
    ball(314.2, 43.2, 0.6, 21.4),
    ball(312.7, 44.4, 0.7, 21.5), // Pelican
    ball(305.6, 40.3, 1.4, 21.6), // around gamma Cygni
    ball(303.4, 41.3, 1.0, 21.8),
    ball(307.8, 39.8, 1.0, 22.0),
    ball(303.0, 38.4, 0.25, 21.6),
    ball(300.0, 35.3, 0.35, 21.8),
    ball(319.8, 44.0, 0.9, 22.9),
    shell(312.8, 30.9, 1.4, 22.3), // Veil
    // From Serpens through Sagittarius and Scorpius to Ophiuchus
    ball(274.7, -13.8, 0.5, 20.6), // Eagle
    ball(274.5, -11.7, 0.9, 22.0),
    ball(275.2, -16.2, 0.4, 19.7), // Omega
    ball(271.0, -24.4, 0.7, 19.9), // Lagoon
    ball(270.6, -23.0, 0.3, 20.6), // Trifid
    ball(274.3, -19.7, 0.5, 22.3),
    ball(261.3, -34.2, 0.6, 21.0), // NGC 6357
    ball(260.2, -35.9, 0.6, 21.2), // NGC 6334
    ball(254.3, -40.4, 0.9, 21.6), // IC 4628
    ball(250.3, -48.8, 0.7, 21.4), // NGC 6188
    ball(245.0, -50.9, 0.7, 22.2),
    ball(249.3, -10.6, 4.5, 23.9), // around zeta Ophiuchi
    ball(245.3, -25.6, 1.1, 23.0), // around sigma Scorpii
    ball(240.1, -22.6, 2.2, 23.8),
    ball(239.7, -26.1, 1.4, 23.8),
    // From Centaurus through Carina to Vela and Puppis
    ball(174.6, -63.2, 0.9, 21.2), // IC 2944
    ball(168.0, -61.2, 0.6, 20.9), // NGC 3576 and 3603
    ball(161.2, -59.7, 0.7, 19.2), // Carina
    ball(161.0, -59.5, 1.5, 21.0),
    ball(159.3, -58.6, 0.4, 20.9), // NGC 3324
    ball(156.1, -57.8, 0.5, 21.5),
    ball(134.8, -47.5, 0.5, 21.5),
    ball(131.0, -41.3, 1.0, 22.4),
    ball(141.0, -52.0, 0.9, 22.8),
    shell(129.0, -45.5, 2.7, 23.2),  // Vela's remnant
    shell(128.0, -43.0, 16.0, 24.9), // Gum Nebula
    ball(118.2, -26.4, 0.35, 21.8),  // NGC 2467
    shell(103.7, -23.9, 0.4, 22.5),
    // The Large Magellanic Cloud
    ball(84.7, -69.1, 0.35, 19.8), // Tarantula
    ball(74.2, -66.4, 0.25, 21.0),
    ball(80.5, -67.9, 0.25, 21.3),
];

/// Filaments and bays, in units of a nebula's radius: sheets and clumps, and winds that bend its
/// outline.
const FILAMENTS: Turbulence = Turbulence {
    seed: 131,
    scale: 0.9,
    octaves: 5,
    persistence: 0.7,
};
const FILAMENT_CONTRAST: f64 = 6.0;
const WINDS: Turbulence = Turbulence {
    seed: 151,
    scale: 1.1,
    octaves: 4,
    persistence: 0.6,
};
const WIND: f64 = 1.1;

/// Half the width of a shell, in units of its radius.
const SHELL_WIDTH: f64 = 0.2;

/// Structure smaller than a texel is left out, in radians.
const FINEST: f64 = 0.006;

/// A nebula is followed this many radii from its middle. There it has faded.
const REACH: f64 = 3.0;

/// The nebulae's middles, radii in radians, and brightness in stars of V = 0 per steradian.
static PLACED: LazyLock<[(DVec3, f64, f64); NEBULAE.len()]> = LazyLock::new(|| {
    NEBULAE.each_ref().map(|nebula| {
        let [ra, dec] = nebula.place;
        let per_steradian = 3600_f64.to_degrees().powi(2);
        let brightness = per_steradian * 10_f64.powf(-0.4 * nebula.magnitude);
        (
            celestial_direction(ra, dec),
            nebula.radius.to_radians(),
            brightness,
        )
    })
});

/// Their luminance from a direction (unit vector, J2000), in stars of V = 0 per steradian.
pub(crate) fn light_from(direction: DVec3) -> f64 {
    NEBULAE
        .iter()
        .zip(PLACED.iter())
        .map(|(nebula, (middle, radius, brightness))| {
            if middle.angle_between(direction) > REACH * radius {
                return 0.0;
            }
            brightness * profile(nebula, (direction - middle) / radius, middle / radius)
        })
        .sum()
}

/// The brightness at a place `offset` from the middle over that of the nebula, in units of its
/// radius. `middle` tells nebulae apart.
fn profile(nebula: &Nebula, offset: DVec3, middle: DVec3) -> f64 {
    let finest = FINEST / nebula.radius.to_radians();
    let place = middle + offset;
    let bent = offset + WIND * WINDS.vector_at(place, finest);
    let radius = bent.length();
    let smooth = if nebula.shell {
        let across = (radius - 0.85) / SHELL_WIDTH;
        (-0.5 * across * across).exp() + 0.25 * (-radius.powi(4)).exp()
    } else {
        (-1.2 * radius * radius).exp()
    };
    let filaments = FILAMENTS.at(place, finest) + FILAMENTS.ridges(place, finest);
    smooth * 1.6 / (1.0 + (-FILAMENT_CONTRAST * filaments).exp())
}
