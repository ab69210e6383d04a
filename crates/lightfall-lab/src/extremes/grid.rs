//! A grid of ordinary places instead of extreme ones.

use super::cells::{Cell, base_scene, sky_and_edge_rays};

/// Spins, the camera's radii in r_s, and its angles from the disk normal in degrees.
const SPINS: [f64; 6] = [0.0, 0.5, 0.9, -0.9, 0.998, 0.9999];
const RADII: [f64; 4] = [2.0, 5.0, 20.0, 1000.0];
const ANGLES: [f64; 5] = [0.0, 10.0, 60.0, 89.0, 90.0];
/// More radii for a hole without spin, starting close to the horizon.
const SCHWARZSCHILD_RADII: [f64; 9] = [1.02, 1.2, 1.5, 1.6, 3.0, 10.0, 20.0, 100.0, 1000.0];

/// Every cell of the grid, with about `count` rays each, half of them near the shadow's edge.
pub fn grid(count: usize) -> Vec<Cell> {
    let schwarzschild = SCHWARZSCHILD_RADII.map(|r| (0.0, r, 75.0));
    let at_radius = |spin: f64, r: f64| ANGLES.map(|theta| (spin, r, theta));
    let kerr = SPINS
        .into_iter()
        .flat_map(|spin| RADII.into_iter().flat_map(move |r| at_radius(spin, r)));
    let cell = |(spin, r, theta): (f64, f64, f64)| {
        let mut scene = base_scene(spin, r);
        scene.camera.theta_deg = theta;
        Cell::new(
            "grid",
            format!("{r} r_s, {theta} degrees"),
            scene,
            |scene| sky_and_edge_rays(scene, count),
        )
    };
    schwarzschild.into_iter().chain(kerr).map(cell).collect()
}
