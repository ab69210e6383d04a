//! The worst ray of a scene.

use super::cause::Cause;
use super::far_ray::FarRays;
use super::narrow_ring::count_unanswerable;
use crate::circumstances::Circumstances;
use crate::import::or_infinite;
use glam::DVec3;
use lightfall_accuracy::{Truth, tolerance};
use lightfall_model::numbers::counted;
use lightfall_model::scene::Scene;
use lightfall_optics::trace::Trace;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;

/// The ray of a scene with the largest error; among the unexplained rays, if there are any.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstRay {
    /// The scene, with the method.
    pub scene: Scene,
    /// The ray's direction on the observer's axes.
    pub direction: DVec3,
    /// The ray's backward error, in radians.
    pub backward: f64,
    /// The backward error over the method's tolerance.
    pub excess: f64,
    /// Why the error is beyond the tolerance, if it is and the reason is known.
    pub cause: Option<Cause>,
    /// Number of the scene's rays with an error beyond the tolerance.
    pub beyond: usize,
    /// Number of those rays whose error nothing explains.
    pub unexplained: usize,
    /// Number of rays that meet the ring by the method or by the reference alone, where the ring is
    /// too narrow for f32 to tell.
    pub unanswerable: usize,
}

impl WorstRay {
    /// The worst of a scene's rays. `None` if there are no rays.
    pub(super) fn of(scene: &Scene, truth: &Truth, traces: &[Trace]) -> Option<Self> {
        let tolerance = tolerance(scene);
        let mut errors = truth.judge_to_precision(0.5 * tolerance, traces);
        let far = FarRays::find(scene, truth, traces, &mut errors);
        let is_unexplained = |ray: usize| far.get(ray).is_some_and(|far| far.cause.is_none());
        let rank = |ray: usize| (is_unexplained(ray), errors[ray].backward);
        let worst = (0..errors.len()).max_by(|a, b| compare_ranks(rank(*a), rank(*b)))?;
        Some(Self {
            scene: scene.clone(),
            direction: scene.camera.tetrad_from_camera() * truth.rays[worst].direction(),
            backward: errors[worst].backward,
            excess: errors[worst].backward / tolerance,
            cause: far.get(worst).and_then(|far| far.cause),
            beyond: far.len(),
            unexplained: far.unexplained(),
            unanswerable: count_unanswerable(scene, truth, traces),
        })
    }

    /// The order of rays from the best to the worst of their scenes: unexplained ones last, otherwise
    /// by the error over the tolerance.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let rank = |ray: &Self| (ray.unexplained > 0, ray.excess);
        compare_ranks(rank(self), rank(other))
    }

    /// The command line that traces this ray again, by the method and by the reference.
    pub fn command(&self) -> String {
        let DVec3 { x, y, z } = self.direction;
        let scene = &self.scene;
        let (camera, disk) = (&scene.camera, &scene.disk);
        let kind = scene.observer.kind.word();
        let [v_r, v_theta, v_phi] = scene.observer.velocity;
        format!(
            "for device in gpu cpu; do echo {x:?},{y:?},{z:?} | lightfall trace --rays - --device $device --method {} \
             --spin {:?} --set camera.r={:?} --set camera.theta_deg={:?} --set camera.fov_deg={:?} --set observer.kind={kind} \
             --set 'observer.velocity=[{v_r:?},{v_theta:?},{v_phi:?}]' --set disk.follow_isco={} --set disk.inner={:?} --set disk.outer={:?}; done",
            scene.method.word(),
            scene.hole.spin,
            camera.r,
            camera.theta_deg,
            camera.fov_deg,
            disk.follow_isco,
            disk.inner,
            disk.outer,
        )
    }

    /// The ray as a row of a report.
    pub fn row(&self) -> HuntRow {
        let scene = &self.scene;
        let [v_r, v_theta, v_phi] = scene.observer.velocity;
        HuntRow {
            backward: self.backward,
            excess: self.excess,
            rays_beyond: self.beyond,
            rays_unexplained: self.unexplained,
            spin: scene.hole.spin,
            r: scene.camera.r,
            fov_deg: scene.camera.fov_deg,
            speed: v_r.hypot(v_theta).hypot(v_phi),
            verdict: self.verdict(),
            command: self.command(),
            rays_unanswerable: self.unanswerable,
        }
    }

    /// A sentence about this ray.
    pub fn verdict(&self) -> String {
        let error = if self.backward.is_finite() {
            format!(
                "at most {:.2e} rad, {:.2} of its tolerance",
                self.backward, self.excess
            )
        } else {
            "no bound".into()
        };
        let count = format!(
            "{} of the scene beyond it, {} unexplained",
            counted(self.beyond, "ray"),
            self.unexplained
        );
        match &self.cause {
            _ if self.beyond == 0 => error,
            None => format!("{error}: UNEXPLAINED; {count}"),
            Some(Cause::Roundings {
                input,
                others,
                backward,
            }) => {
                let inputs = match others {
                    0 => format!("{input} moved by half a unit in f32's last place gives"),
                    _ => format!(
                        "{input} and {}, each moved by half a unit in f32's last place, give together",
                        counted(*others, "other number")
                    ),
                };
                format!("{error}: {inputs} {backward:.2e} rad; {count}")
            }
            Some(Cause::NarrowRing) => {
                format!(
                    "{error}: the ring is too narrow for f32 to tell whether it is met; {count}"
                )
            }
        }
    }
}

/// Compares whether two rays are unexplained, and their errors after this. NaN is the largest error.
fn compare_ranks(a: (bool, f64), b: (bool, f64)) -> Ordering {
    let error = |error: f64| if error.is_nan() { f64::INFINITY } else { error };
    a.0.cmp(&b.0).then(error(a.1).total_cmp(&error(b.1)))
}

/// The worst ray of a scene, as a row of a report.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct HuntRow {
    /// The ray's backward error, in radians.
    #[serde(deserialize_with = "or_infinite")]
    pub backward: f64,
    /// The backward error over the method's tolerance.
    #[serde(deserialize_with = "or_infinite")]
    pub excess: f64,
    /// Number of the scene's rays with an error beyond the tolerance.
    pub rays_beyond: usize,
    /// Number of those rays whose error nothing explains.
    pub rays_unexplained: usize,
    /// The hole's spin.
    pub spin: f64,
    /// The camera's radius, in r_s.
    pub r: f64,
    /// The vertical field of view, in degrees.
    pub fov_deg: f64,
    /// The observer's speed against the kind of observer that the scene names, in units of c.
    pub speed: f64,
    /// A sentence about the error.
    pub verdict: String,
    /// The command line that traces the ray again.
    pub command: String,
    /// Number of rays that meet the ring by the method or by the reference alone, where the ring is
    /// too narrow for f32 to tell.
    pub rays_unanswerable: usize,
}

/// The rows as lines for a shell: each traces a ray again, below a comment with its verdict.
pub fn hunt_text(circumstances: &Circumstances, rows: &[HuntRow]) -> String {
    let lines = rows
        .iter()
        .map(|row| format!("# {}\n{}\n", row.verdict, row.command));
    circumstances.marked('#') + &lines.collect::<String>()
}
