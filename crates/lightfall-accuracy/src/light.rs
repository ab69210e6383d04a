//! The errors of light from matter with depth.

use super::ray::Ray;
use glam::{DVec3, Vec3};
use lightfall_model::scene::Scene;
use lightfall_optics::medium::{Medium, Passage, Tolerance};
use lightfall_optics::reference::Reference;
use rayon::prelude::*;

/// The nodes of a chunk of the f64 twin, which halves chunks until they agree.
const NODES: usize = 8;

/// The share of a picture's bright pixels below which light counts as dark.
const FLOOR_SHARE: f64 = 0.01;

/// The light of the converged f64 twin along rays of a scene's camera, and the optical depth of their
/// ways. `relative` is the largest difference between a chunk and its halves, as a share of the
/// chunk's light. `None` if the scene has no matter with depth, or its observer does not exist.
pub fn true_passages(scene: &Scene, rays: &[Ray], relative: f64) -> Option<Vec<Passage>> {
    let tolerance = Tolerance {
        relative,
        // Nothing that f32 could tell comes from behind it.
        end_depth: 20.0,
    };
    let (medium, reference) = (Medium::of(scene, NODES)?, Reference::new(scene).ok()?);
    let axes = scene.camera.tetrad_from_camera();
    let seen = |ray: &Ray| {
        let direction = (axes * ray.direction()).normalize();
        medium.seen(&reference.photon(direction), tolerance)
    };
    Some(rays.par_iter().map(seen).collect())
}

/// The error below which a picture does not tell light from darkness: a hundredth of what 95 of 100
/// pixels with light stay below.
pub fn light_floor(truth: impl IntoIterator<Item = DVec3>) -> f64 {
    let lights = truth.into_iter().map(DVec3::max_element);
    let lit = sorted(lights.filter(|light| *light > 0.0));
    FLOOR_SHARE * at_share(&lit, 0.95).max(f64::MIN_POSITIVE)
}

/// The errors of the rays with light, relative to the larger of the true light and the picture's floor:
/// of red, green and blue the one that is farthest off, relative to the largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightErrors {
    /// Number of rays with light, true or found.
    pub lit: usize,
    /// The median of their errors; NaN without any.
    pub p50: f64,
    /// The 95th percentile.
    pub p95: f64,
    /// The 99th percentile.
    pub p99: f64,
    /// The largest.
    pub max: f64,
}

impl LightErrors {
    /// The errors of found light in a picture with this [`light_floor`].
    pub fn between(found: &[Vec3], truth: &[DVec3], floor: f64) -> Self {
        let pairs = found.iter().map(|light| light.as_dvec3()).zip(truth);
        // NaN counts as light.
        let lit = pairs.filter(|(found, truth)| **truth != DVec3::ZERO || *found != DVec3::ZERO);
        let errors = sorted(lit.map(|(found, truth)| error(found, *truth, floor)));
        Self {
            lit: errors.len(),
            p50: at_share(&errors, 0.5),
            p95: at_share(&errors, 0.95),
            p99: at_share(&errors, 0.99),
            max: at_share(&errors, 1.0),
        }
    }
}

/// The error of a ray's light. One that is no number is infinite.
pub fn error(found: DVec3, truth: DVec3, floor: f64) -> f64 {
    let off = (found - truth).abs();
    if off.is_finite() {
        off.max_element() / truth.max_element().max(floor)
    } else {
        f64::INFINITY
    }
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The smallest value that is no less than this share of all.
fn at_share(sorted: &[f64], share: f64) -> f64 {
    let index = (share * sorted.len() as f64).ceil() as usize;
    let value = sorted.get(index.clamp(1, sorted.len().max(1)) - 1);
    value.copied().unwrap_or(f64::NAN)
}
