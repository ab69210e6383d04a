//! The reference method: traces rays in f64, for any spin.
//!
//! A ray ends at u = 0, which is infinity itself, or as soon as its capture is certain. Infinity
//! and the crossings of the disk's plane are roots of the step's own series.
//!
//! A crossing within a step or at its end belongs to that step, never to the step that starts
//! there. So no crossing counts twice, and a camera in the plane does not see the disk at its own
//! place. A ray that lies in the plane has no isolated crossing and therefore no hit.

use crate::camera_rays::{CameraRays, camera_in_disk_frame};
use crate::shift::Shift;
use crate::trace::{Hit, Outcome, Trace};
use crate::{disk, straight};
use glam::{DMat3, DVec3};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries, PhotonState};
use lightfall_model::geometry::observer::{ObserverError, Photon};
use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_model::scene::Scene;

/// Maximum number of steps of a ray. A ray within 1e-15 of the critical curve takes a few hundred.
const MAX_STEPS: u32 = 10_000;

/// The rays of a scene's camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    hole_and_disk: HoleAndDisk,
    camera_rays: CameraRays,
    shift: Shift,
    lensing: bool,
    r: f64,
    n: DVec3,
    hole_from_disk: DMat3,
}

/// The hole and the disk, which rays can hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoleAndDisk {
    /// The hole.
    pub kerr: Kerr,
    /// Inner and outer edge of the disk, in r_s; `None` without a disk.
    pub annulus: Option<[f64; 2]>,
}

/// A step along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<'a> {
    /// The motion from the step's start on.
    pub expansion: &'a PhotonSeries,
    /// The step's length in Mino time.
    pub length: f64,
    /// The Mino time of the hit that the trace has found in the step.
    pub hit: Option<f64>,
}

impl Reference {
    /// Prepares the rays of `scene`.
    ///
    /// # Errors
    /// If the scene's observer does not exist.
    pub fn new(scene: &Scene) -> Result<Self, ObserverError> {
        let camera_rays = CameraRays::in_disk_frame(scene)?;
        let annulus = scene
            .disk
            .enabled
            .then(|| [scene.inner_edge(), scene.disk.outer]);
        let hole_and_disk = HoleAndDisk {
            kerr: scene.kerr(),
            annulus,
        };
        let (shift, lensing) = (Shift::new(scene), scene.effects.lensing);
        Ok(Self {
            hole_and_disk,
            camera_rays,
            shift,
            lensing,
            r: scene.camera.r,
            n: camera_in_disk_frame(scene),
            hole_from_disk: scene.disk.hole_from_disk(),
        })
    }

    /// Follows the ray that arrives from `direction`, given on the observer's axes and of any
    /// length. For a direction that is zero or not finite the outcome is `Unfinished` and the
    /// residual NaN. Only straight rays, where they cost nothing, have delays.
    pub fn trace(&self, direction: DVec3) -> Trace {
        self.trace_by(direction, HoleAndDisk::trace)
    }

    /// As [`trace`](Self::trace), with the hits' delays if the camera is outside the horizon.
    pub fn trace_with_delays(&self, direction: DVec3) -> Trace {
        let mut trace = self.trace_with_lags(direction);
        // `Lag` makes the same comparison, so rounding cannot make the two disagree.
        if 1.0 / self.r >= 1.0 / self.hole_and_disk.kerr.horizon() {
            for hit in trace.hits.iter_mut().flatten() {
                hit.delay = None;
            }
        }
        trace
    }

    /// As [`trace`](Self::trace), with the hits' [lags](crate::delay::Lag) in place of
    /// their delays, wherever the camera is. Outside the horizon both are the same.
    pub fn trace_with_lags(&self, direction: DVec3) -> Trace {
        self.trace_by(direction, HoleAndDisk::trace_with_lags)
    }

    fn trace_by(
        &self,
        direction: DVec3,
        lensed: impl Fn(&HoleAndDisk, &PhotonConstants, PhotonState) -> Trace,
    ) -> Trace {
        let Some(direction) = (direction / direction.abs().max_element()).try_normalize() else {
            return Trace::empty(f64::NAN);
        };
        self.trace_photon_by(&self.photon(direction), lensed)
    }

    /// Follows the backward ray of a photon at the camera, as [`trace`](Self::trace) follows that
    /// of a direction.
    pub fn trace_photon(&self, photon: &Photon) -> Trace {
        self.trace_photon_by(photon, HoleAndDisk::trace)
    }

    fn trace_photon_by(
        &self,
        photon: &Photon,
        lensed: impl Fn(&HoleAndDisk, &PhotonConstants, PhotonState) -> Trace,
    ) -> Trace {
        let HoleAndDisk { kerr, annulus } = self.hole_and_disk;
        let (mut trace, lambda) = if self.lensing {
            let (constants, start) = PhotonConstants::of_photon(kerr, photon, self.r, self.n);
            (
                lensed(&self.hole_and_disk, &constants, start),
                constants.angular_momentum / constants.energy,
            )
        } else {
            // Without frame dragging no shift depends on lambda.
            (straight::trace(kerr, annulus, photon, self.r, self.n), 0.0)
        };
        for hit in trace.hits.iter_mut().flatten() {
            hit.g = self.shift.of_disk(hit.g, hit.r, lambda);
        }
        trace.sky = trace.sky.map(|sky| self.hole_from_disk * sky);
        trace
    }

    /// The photon that arrives from a unit direction, in the disk's frame.
    pub fn photon(&self, direction: DVec3) -> Photon {
        self.camera_rays.photon(direction)
    }

    /// The unit direction, on the observer's axes, from which a photon in the disk's frame arrives.
    /// `None` if the observer measures no frequency.
    pub fn direction_of(&self, photon: &Photon) -> Option<DVec3> {
        self.camera_rays.matrix.direction_of(photon, self.n)
    }

    /// The hole and the disk.
    pub fn hole_and_disk(&self) -> HoleAndDisk {
        self.hole_and_disk
    }

    /// The camera's place: its radius, in r_s, and its unit vector on the celestial sphere of the
    /// disk's frame.
    pub fn camera(&self) -> (f64, DVec3) {
        (self.r, self.n)
    }

    /// Whether light is bent.
    pub fn lensing(&self) -> bool {
        self.lensing
    }
}

impl HoleAndDisk {
    /// Follows the backward ray with these constants from `start` to its end.
    pub fn trace(&self, constants: &PhotonConstants, start: PhotonState) -> Trace {
        self.follow(constants, start, |_| {})
    }

    /// As [`trace`](Self::trace), and calls `visit` with every step.
    pub fn follow(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        visit: impl FnMut(&Step),
    ) -> Trace {
        self.follow_beyond(constants, start, 2, visit)
    }

    /// As [`follow`](Self::follow), but a ray that has crossed the plane twice goes on, too, to where
    /// it can no longer be between the disk's edges: matter with depth is met anywhere there.
    pub fn follow_to_inner_edge(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        visit: impl FnMut(&Step),
    ) -> Trace {
        self.follow_beyond(constants, start, usize::MAX, visit)
    }

    /// Follows a ray to its end. The space between the disk's edges matters until the ray has crossed
    /// the plane `max_hits` times there.
    fn follow_beyond(
        &self,
        constants: &PhotonConstants,
        start: PhotonState,
        max_hits: usize,
        mut visit: impl FnMut(&Step),
    ) -> Trace {
        let u_horizon = 1.0 / self.kerr.horizon();
        // Hits lie between these values of u. Without a disk the interval is empty.
        let [u_outer, u_inner] = self
            .annulus
            .map_or([0.0, 0.0], |[inner, outer]| [1.0 / outer, 1.0 / inner]);
        let mut trace = Trace::empty(constants.residual(&start));
        let mut state = start;
        if constants.stays_inside(&state, u_horizon) {
            return trace.ending(Outcome::Captured);
        }
        while trace.steps < MAX_STEPS {
            let hits = trace.hits.iter().flatten().count();
            let nothing_more = state.u >= u_inner || hits >= max_hits;
            let inward = state.du > 0.0;
            if inward
                && (state.u >= u_horizon
                    || nothing_more && constants.cannot_turn_within(state.u, u_horizon))
            {
                return trace.ending(Outcome::Captured);
            }
            let expansion = constants.expand(&state);
            let reach = constants.reach(&expansion);
            let to_infinity = time_to_infinity(&expansion, reach);
            let end_time = to_infinity.unwrap_or(reach);
            let end = expansion.at(end_time);
            if !(end_time > 0.0 && end.n.is_finite() && end.u.is_finite()) {
                return trace;
            }
            trace.steps += 1;
            trace.residual = trace.residual.max(constants.residual(&end));
            let mut hit_time = None;
            if let Some(time) = time_to_plane(&expansion, end.n.z, end_time) {
                let crossing = expansion.at(time);
                if crossing.u > u_outer && crossing.u < u_inner {
                    let hit = self.hit(constants, &crossing);
                    let free = trace.hits.iter_mut().find(|slot| slot.is_none());
                    if let (Some(slot), Some(hit)) = (free, hit) {
                        *slot = Some(hit);
                        hit_time = Some(time);
                    }
                }
            }
            visit(&Step {
                expansion: &expansion,
                length: end_time,
                hit: hit_time,
            });
            if to_infinity.is_some() {
                // Light of negative energy cannot come from infinity.
                if constants.energy <= 0.0 {
                    return trace.ending(Outcome::Captured);
                }
                let sky = DMat3::from_rotation_z(end.chi) * end.n;
                trace.sky = Some(sky.normalize());
                return trace.ending(Outcome::Sky);
            }
            state = end;
        }
        trace
    }

    /// The hit at a crossing of the disk's plane; `None` where no circular orbit exists.
    pub(super) fn hit(&self, constants: &PhotonConstants, crossing: &PhotonState) -> Option<Hit> {
        let r = 1.0 / crossing.u;
        let orbit = self.kerr.circular_orbit(r)?;
        let lead = if constants.ingoing {
            self.kerr.ingoing_azimuth_lead(r)
        } else {
            0.0
        };
        let azimuth = crossing.n.y.atan2(crossing.n.x) + crossing.chi - lead;
        let g = disk::redshift(&orbit, constants.energy, constants.angular_momentum);
        Some(Hit {
            r,
            phi: wrap_angle(azimuth),
            g,
            delay: None,
        })
    }
}

/// The Mino time within `reach` at which an outgoing ray is at u = 0, if it gets there. A step of
/// at most one radian is too short to pass infinity and come back, which takes more than two
/// radians.
fn time_to_infinity(expansion: &PhotonSeries, reach: f64) -> Option<f64> {
    let outward = expansion.u.0[1] < 0.0;
    (outward && expansion.u.at(reach).0 <= 0.0).then(|| expansion.u.root(reach))
}

/// The Mino time in (0, `end_time`] at which the ray crosses the disk's plane; `z_end` is n_z at
/// the end.
pub(super) fn time_to_plane(expansion: &PhotonSeries, z_end: f64, end_time: f64) -> Option<f64> {
    let z = expansion.n[2].0[0];
    (z > 0.0 && z_end <= 0.0 || z < 0.0 && z_end >= 0.0).then(|| expansion.n[2].root(end_time))
}
