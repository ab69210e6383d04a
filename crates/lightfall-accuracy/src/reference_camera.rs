//! The reference for the rays of a scene's camera, and the shadow's edge on its sky.

use super::camera_tracer::CameraTracer;
use super::ray::Ray;
use super::search::edge::{Edge, Shadow};
use glam::DVec3;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::Scene;
use lightfall_optics::trace::{Hit, Trace};

/// The edges of the wider disk: the inner one as a share of the disk's own, outside the crossings
/// of orbits about the hole where the disk is far; the outer one in r_s, beyond f64's precision.
const WIDER_INNER: f64 = 1.0 / 3.0;
const WIDER_OUTER: f64 = 1e12;

/// The reference for the rays of a scene's camera. Directions are (right, up, forward).
pub(super) struct ReferenceCamera {
    pub(super) tracer: CameraTracer,
    /// The same without a disk, for the outcome alone, because a capture is certain much earlier.
    without_disk: CameraTracer,
    /// The same with a wider disk, for crossings of the plane next to the disk.
    wider_disk: CameraTracer,
    /// The shadow on the camera's sky, if it has an edge.
    shadow: Option<Shadow>,
    /// Whether the hole spins, so that orbits do not lie in planes.
    pub(super) is_spinning: bool,
    /// Scale of turns that matter, in radians: a thousandth of the picture's half height, but no
    /// less than f32 resolves.
    pub(super) scale: f64,
}

impl ReferenceCamera {
    /// The reference for the rays of a scene's camera.
    ///
    /// # Errors
    /// If the scene's observer cannot exist.
    pub(super) fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let mut empty = scene.clone();
        empty.disk.enabled = false;
        let without_disk = CameraTracer::new(&empty)?;
        let half_height = 0.5 * f64::from(scene.picture.height) * scene.pixel_angle();
        let mut wider = scene.clone();
        wider.disk.follow_isco = false;
        wider.disk.inner = WIDER_INNER * scene.inner_edge();
        wider.disk.outer = WIDER_OUTER;
        Ok(Self {
            tracer: CameraTracer::new(scene)?,
            shadow: Shadow::of(scene, &without_disk),
            without_disk,
            wider_disk: CameraTracer::new(&wider)?,
            is_spinning: scene.hole.spin != 0.0 && scene.effects.lensing,
            scale: (1e-3 * half_height).clamp(1e-7, 1e-3),
        })
    }

    /// The ray with the shadow's edge at its position angle, if there is one.
    pub(super) fn with_edge(&self, ray: &Ray) -> Ray {
        let edge = ray.edge.or_else(|| {
            self.shadow
                .map(|shadow| shadow.edge_toward(&self.without_disk, ray.direction()))
        });
        Ray { edge, ..*ray }
    }

    /// The reference's answer to the ray that arrives from a direction of the camera.
    pub(super) fn trace(&self, direction: DVec3) -> Trace {
        self.tracer.trace(direction)
    }

    /// The ray's crossing of the wider disk that is nearest to the radius `r`.
    pub(super) fn crossing_near(&self, direction: DVec3, r: f64) -> Option<Hit> {
        let crossings = self.wider_disk.trace(direction).hits.into_iter().flatten();
        let distance = |hit: &Hit| (1.0 - r / hit.r).abs();
        crossings.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// The shadow's edge around a position angle, where there is a shadow.
    pub(super) fn edge(&self, position_angle: f64) -> Option<Edge> {
        self.shadow
            .map(|shadow| shadow.edge(&self.without_disk, position_angle))
    }
}
