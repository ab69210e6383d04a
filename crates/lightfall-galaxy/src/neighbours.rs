//! The galaxies next to ours that the naked eye sees.

use glam::DVec3;
use lightfall_optics::stars::celestial_direction;

/// A galaxy as a round disk of exponential brightness.
struct Neighbour {
    /// Galactic longitude and latitude in degrees.
    place: [f64; 2],
    /// V of all its light, and its colour B-V (de Vaucouleurs et al. 1991, RC3).
    magnitude: f64,
    b_v: f64,
    /// Scale length in degrees.
    scale: f64,
}

/// The Magellanic Clouds and the Andromeda Galaxy.
const NEIGHBOURS: [Neighbour; 3] = [
    Neighbour {
        place: [280.47, -32.89],
        magnitude: 0.4,
        b_v: 0.51,
        scale: 1.4,
    },
    Neighbour {
        place: [302.80, -44.30],
        magnitude: 2.2,
        b_v: 0.45,
        scale: 0.7,
    },
    Neighbour {
        place: [121.17, -21.57],
        magnitude: 3.4,
        b_v: 0.92,
        scale: 0.4,
    },
];

/// Their light from a galactic direction (unit vector), in stars of V = 0 per steradian: V, and B
/// where a star of B-V = 0 counts the same in both.
pub(crate) fn light_from(direction: DVec3) -> [f64; 2] {
    let mut light = [0.0; 2];
    for Neighbour {
        place: [l, b],
        magnitude,
        b_v,
        scale,
    } in &NEIGHBOURS
    {
        let middle = celestial_direction(*l, *b);
        let scale = scale.to_radians();
        let distance = middle.angle_between(direction) / scale;
        if distance < 12.0 {
            let peak = 10_f64.powf(-0.4 * magnitude) / (std::f64::consts::TAU * scale * scale);
            let v = peak * (-distance).exp();
            light[0] += v;
            light[1] += v * 10_f64.powf(-0.4 * b_v);
        }
    }
    light
}
