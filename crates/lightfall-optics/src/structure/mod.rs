//! The structure of the disk's light: a statistical model of turbulence that the rotation carries
//! and shears. The twin in WGSL is shaders/disk/structure/waves.wgsl.
//!
//! The flux in the matter's frame is that of the smooth disk times exp(sigma f) over its mean. f is
//! a random field of mean zero and variance one in x = ln r and phi, longer along trailing spirals
//! than across them (Lee & Gammie 2021). It is a sum of shearing waves (Goldreich & Lynden-Bell
//! 1965) in overlapping rings. Each wave moves with the exact angular velocity of circular orbits,
//! fades out before it winds up, and is reborn with another phase.
//!
//! With a period, the lives of each ring's waves divide it, and their phases repeat after it.

mod draw;
mod field;
mod model;
mod rings;

pub use draw::{Ring, Wave};
pub use field::{Covariance, Event, Field, Term};
pub use model::{MAX_WAVES, Model, OCTAVES};
pub use rings::{MAX_RINGS, Rings};

use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::{Disk, Scene};

/// Largest change in (ln r, phi) from a pixel to its neighbour in the same image of the disk:
/// `MAX_DX` and `MAX_DPHI` in the shader.
pub const MAX_CHANGE: [f64; 2] = [0.9, 0.75];

/// The structure of a scene's disk: everything that does not depend on time.
#[derive(Clone, Debug, PartialEq)]
pub struct Structure {
    /// The hole.
    pub kerr: Kerr,
    /// The model's numbers.
    pub model: Model,
    /// Where the rings are.
    pub places: Rings,
    /// The rings with their waves, from the innermost.
    pub rings: Vec<Ring>,
}

impl Structure {
    /// The structure of the scene's disk, with at most `limit` waves in each ring; `None` for a
    /// smooth disk.
    pub fn new(scene: &Scene, limit: Option<u32>) -> Option<Self> {
        let model = Model::new(&scene.disk, limit)?;
        let kerr = scene.kerr();
        let places = Rings::new(scene.inner_edge(), scene.disk.outer);
        let rings = (0..places.count)
            .map(|i| Ring::new(&model, i, places.centre(i), kerr))
            .collect();
        Some(Self {
            kerr,
            model,
            places,
            rings,
        })
    }

    /// Standard deviations of the logarithms of the flux and of the density in a disk with thickness.
    /// One field decides both: where it is large, matter is dense, and bright or, in lanes, dark.
    pub fn spread(&self, disk: &Disk) -> [f64; 2] {
        [self.model.contrast * (1.0 - 2.0 * disk.lanes), disk.lumps]
    }
}
