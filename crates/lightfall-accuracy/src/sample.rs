//! Samples of rays: spread over the picture, spread over the sky, or close to the edge of the
//! shadow.

use super::ray::Ray;
use super::reference_camera::ReferenceCamera;
use super::search::edge::Edge;
use glam::{DVec2, DVec3};
use lightfall_model::scene::Scene;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Distances from the shadow's edge of the usual sample, as shares of the shadow's radius.
pub const EDGE_DISTANCES: [f64; 2] = [1e-6, 0.3];

/// Number of rays near the edge at each position angle. They share one search for the edge.
const RAYS_PER_POSITION_ANGLE: usize = 8;

/// Steps of the R2 sequence, inverse powers of the plastic number (Roberts 2018): its points are
/// spread evenly without forming a lattice.
const PLASTIC: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_2];

const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// `count` rays spread evenly over the scene's picture.
pub fn rays_over_picture(scene: &Scene, count: usize) -> Vec<Ray> {
    let size = scene.picture.size().as_dvec2();
    let ray = |i: usize| {
        let share = DVec2::from_array(PLASTIC.map(|step| (0.5 + step * (i + 1) as f64).fract()));
        Ray::toward(scene.camera.looking(share * size, size))
    };
    (0..count).map(ray).collect()
}

/// `count` rays: half of them spread over the scene's picture, half close to the shadow's edge at
/// the usual distances. Only the first half if there is no shadow.
pub fn rays_over_picture_and_near_edge(scene: &Scene, count: usize) -> Vec<Ray> {
    let mut rays = rays_over_picture(scene, count - count / 2);
    rays.extend(rays_near_edge(scene, count / 2, EDGE_DISTANCES));
    rays
}

/// `count` rays spread evenly over the whole sky, on a Fibonacci spiral.
pub fn rays_over_sky(count: usize) -> Vec<Ray> {
    let ray = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let (sin, cos) = (TAU * (i as f64 * GOLDEN).fract()).sin_cos();
        let across = (1.0 - z * z).sqrt();
        Ray::toward(DVec3::new(across * cos, across * sin, z))
    };
    (0..count).map(ray).collect()
}

/// `count` rays close to the shadow's edge, on both sides and all around it. Their distances from
/// the edge are spread evenly in the logarithm over `range`, as shares of the shadow's radius (or
/// of the rest of the sky if that is smaller). Empty if there is no shadow.
pub fn rays_near_edge(scene: &Scene, count: usize, range: [f64; 2]) -> Vec<Ray> {
    let Ok(camera) = ReferenceCamera::new(scene) else {
        return Vec::new();
    };
    let directions = count.div_ceil(RAYS_PER_POSITION_ANGLE);
    let [nearest, farthest] = range.map(f64::ln);
    let ray = |(direction, i): (usize, usize), edge: Edge| {
        let share =
            (0.5 + PLASTIC[0] * (direction * RAYS_PER_POSITION_ANGLE + i + 1) as f64).fract();
        let distance = (nearest + share * (farthest - nearest)).exp()
            * f64::min(edge.middle(), TAU / 2.0 - edge.middle());
        let toward =
            Ray::toward(edge.direction(0.0, if i % 2 == 0 { distance } else { -distance }));
        Ray {
            edge: Some(edge),
            ..toward
        }
    };
    let edges = (0..directions).into_par_iter().filter_map(|direction| {
        let position_angle = TAU * (direction as f64 + 0.5) / directions as f64;
        camera.edge(position_angle).map(|edge| (direction, edge))
    });
    let rays = edges.flat_map_iter(|(direction, edge)| {
        (0..RAYS_PER_POSITION_ANGLE).map(move |i| (direction, i, edge))
    });
    let mut rays: Vec<Ray> = rays
        .map(|(direction, i, edge)| ray((direction, i), edge))
        .collect();
    rays.truncate(count);
    rays
}
