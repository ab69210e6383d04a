//! The reference behind a scene's camera, together with the shadow's edge on its sky.

use super::camera_tracer::CameraTracer;
use super::ray::Ray;
use super::search::edge::{Edge, Shadow};
use glam::DVec3;
use lightfall_model::geometry::observer::{ObserverError, Photon};
use lightfall_model::scene::Scene;
use lightfall_optics::reference::Reference;
use lightfall_optics::trace::{Hit, Trace};

/// The edges of the wider disk: the inner one as a share of the disk's own, above the crossings of orbits
/// about the hole where the disk is far, and the outer one in r_s, at infinity for f64.
const WIDER_INNER: f64 = 1.0 / 3.0;
const WIDER_OUTER: f64 = 1e12;

/// The reference behind the scene's camera. Directions are (right, up, forward).
pub(super) struct ReferenceCamera {
    tracer: CameraTracer,
    /// The same without a disk, for the outcome alone: a capture is then certain much earlier.
    without_disk: CameraTracer,
    /// The same with a ring that is wider than the disk, for where light crosses the plane next to it.
    wider_disk: CameraTracer,
    /// The shadow on the camera's sky, if it has an edge.
    shadow: Option<Shadow>,
    /// Whether the hole spins, so that orbits do not lie in planes.
    pub(super) is_spinning: bool,
    /// Scale of turns that matter, in radians: a thousandth of the picture's half height, but no
    /// less than f32 can tell apart.
    pub(super) scale: f64,
}

impl ReferenceCamera {
    /// The reference behind a scene's camera.
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

    /// The same ray with the shadow's edge on its side, if there is one.
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

    /// The hit nearest to the radius `r` that the ray would have if the disk reached from a third of its inner
    /// radius to infinity.
    pub(super) fn crossing_near(&self, direction: DVec3, r: f64) -> Option<Hit> {
        let crossings = self.wider_disk.trace(direction).hits.into_iter().flatten();
        let distance = |hit: &Hit| (1.0 - r / hit.r).abs();
        crossings.min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }

    /// What another scene's reference answers to the ray that arrives from the same direction.
    pub(super) fn trace_by(&self, other: &Reference, direction: DVec3) -> Trace {
        other.trace(self.tracer.tetrad_from_camera * direction)
    }

    /// The reference's answer if the ray's photon is changed by `change`, and the angle between the ray
    /// and the one whose photon has the changed constants, in radians. `None` if no photon has them.
    pub(super) fn trace_changed(
        &self,
        direction: DVec3,
        change: impl Fn(&mut Photon),
    ) -> Option<(Trace, f64)> {
        self.tracer.trace_changed(direction, change)
    }

    /// The shadow's edge around a position angle, where there is a shadow.
    pub(super) fn edge(&self, position_angle: f64) -> Option<Edge> {
        self.shadow
            .map(|shadow| shadow.edge(&self.without_disk, position_angle))
    }
}
