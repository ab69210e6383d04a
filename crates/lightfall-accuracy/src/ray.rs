//! One ray of the scene's camera.

use super::search::edge::Edge;
use glam::{DVec3, UVec2, Vec3};
use lightfall_model::scene::Scene;

/// One ray of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Direction (right, up, forward) of the camera, rounded to f32. Every method gets this
    /// direction, the reference as well.
    pub(super) given: Vec3,
    /// The shadow's edge on the great circle from its centre through the ray.
    pub(super) edge: Option<Edge>,
}

impl Ray {
    /// The ray closest to a direction (right, up, forward) of the camera.
    pub fn toward(direction: DVec3) -> Self {
        Self {
            given: direction.normalize_or_zero().as_vec3(),
            edge: None,
        }
    }

    /// The rays through the centres of a grid of cells (columns and rows) that divides the scene's
    /// picture, row by row from the top.
    pub(super) fn over_grid(scene: &Scene, [columns, rows]: [u32; 2]) -> Vec<Self> {
        let picture = scene.picture.size().as_dvec2();
        let cells = UVec2::new(columns, rows).as_dvec2();
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| [column, row]));
        let ray = |cell: [u32; 2]| {
            let place = (UVec2::from(cell).as_dvec2() + 0.5) / cells * picture;
            Self::toward(scene.camera.looking(place, picture))
        };
        places.map(ray).collect()
    }

    /// Its direction in f32, as the shaders get it.
    pub fn given(&self) -> Vec3 {
        self.given
    }

    /// Its direction as a unit vector in f64.
    pub fn direction(&self) -> DVec3 {
        self.given.as_dvec3().normalize_or_zero()
    }

    /// Angle from the shadow's edge, in radians, positive away from the shadow's centre. `None` if
    /// the sample did not look for the edge.
    pub fn distance_to_edge(&self) -> Option<f64> {
        self.edge.map(|edge| edge.place(self.direction())[1])
    }
}
