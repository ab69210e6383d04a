//! One ray of the scene's camera.

use super::search::edge::Edge;
use glam::{DVec3, Vec3};

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
