//! Traces arrays of rays by a compute entry that runs the same WGSL as the picture.

use super::bindings;
use super::device::Gpu;
use super::error::GpuError;
use super::inputs::Inputs;
use super::kernel::{ArrayKernel, uniform};
use super::scene::{GpuScene, time_lead};
use super::shader::Variant;
use encase::ShaderType;
use glam::{DVec3, Vec3, Vec4};
use lightfall_model::scene::{Frame, Scene};
use lightfall_optics::trace::{Hit, Outcome, Trace};
use std::f64::consts::{PI, TAU};

/// Maximum number of rays of one dispatch. More could take a slow device so long that its driver
/// resets it.
pub(super) const MAX_RAYS: usize = 1 << 15;

/// One crossing of the annulus, as shaders/trace.wgsl lays it out.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuHit {
    pub position: Vec3,
    pub g: f32,
    pub delay: f32,
}

/// The trace of a ray, as shaders/trace.wgsl lays it out.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuTrace {
    pub sky: Vec3,
    pub outcome: u32,
    pub hits: [GpuHit; 2],
    pub hit_count: u32,
    pub steps: u32,
    pub residual: f32,
    pub angular_momentum_drift: f32,
    pub turn: f32,
}

/// Traces the rays that leave the scene's camera in these directions, on the observer's axes
/// (outward, toward increasing theta, toward increasing phi), of any nonzero length. Returns one
/// trace per ray, in order.
///
/// # Errors
/// The GPU cannot trace the scene, or the device failed.
pub fn trace(gpu: &Gpu, scene: &Scene, directions: &[DVec3]) -> Result<Vec<Trace>, GpuError> {
    Ok(traces(scene, &records(gpu, scene, directions)?))
}

/// As [`trace`], but returns the GPU's own records, which also hold the drift of the angular
/// momentum. Their directions on the sky are in the disk's frame.
///
/// # Errors
/// As [`trace`].
pub fn records(gpu: &Gpu, scene: &Scene, directions: &[DVec3]) -> Result<Vec<GpuTrace>, GpuError> {
    let directions: Vec<Vec3> = directions
        .iter()
        .map(|direction| unit(*direction).as_vec3())
        .collect();
    RayKernel::new(gpu, scene)?.run(gpu, &GpuScene::for_rays(scene)?, &directions)
}

/// The compiled variant of a scene, for rays in the directions of its camera.
#[derive(Debug)]
pub struct RayKernel(ArrayKernel);

impl RayKernel {
    /// Compiles the scene's variant.
    ///
    /// # Errors
    /// The GPU cannot trace the scene.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        Self::of_variant(gpu, Variant::rays(scene), scene)
    }

    /// Compiles another variant than the scene's own.
    ///
    /// # Errors
    /// As [`RayKernel::new`].
    pub fn of_variant(gpu: &Gpu, variant: Variant, scene: &Scene) -> Result<Self, GpuError> {
        let source = variant.source();
        let mut uniforms = Inputs::new(scene).declared_in(&source);
        uniforms.push((bindings::SCENE, uniform(&GpuScene::for_rays(scene)?)));
        Ok(Self(ArrayKernel::new(gpu, &source, "rays", &uniforms)?))
    }

    /// Traces rays through a scene of this variant. Directions are unit vectors (right, up,
    /// forward) of its camera. Returns one trace per ray, in order.
    ///
    /// # Errors
    /// As [`trace`].
    pub fn trace_camera_rays(
        &self,
        gpu: &Gpu,
        scene: &Scene,
        directions: &[Vec3],
    ) -> Result<Vec<Trace>, GpuError> {
        let numbers = GpuScene::new(scene, &Frame::of(scene))?;
        Ok(traces(scene, &self.run(gpu, &numbers, directions)?))
    }

    fn run(
        &self,
        gpu: &Gpu,
        numbers: &GpuScene,
        directions: &[Vec3],
    ) -> Result<Vec<GpuTrace>, GpuError> {
        self.0
            .write_uniform(gpu, bindings::SCENE, &uniform(numbers));
        let mut records = Vec::with_capacity(directions.len());
        for batch in directions.chunks(MAX_RAYS) {
            let batch: Vec<Vec4> = batch
                .iter()
                .map(|direction| direction.extend(0.0))
                .collect();
            records.extend(self.0.run::<Vec4, GpuTrace>(gpu, &batch)?);
        }
        Ok(records)
    }
}

/// The unit vector in a direction of any length. Dividing by the largest component first avoids
/// overflow and underflow. Zero stays zero.
fn unit(direction: DVec3) -> DVec3 {
    let largest = direction.abs().max_element();
    if largest > 0.0 {
        (direction / largest).normalize()
    } else {
        DVec3::ZERO
    }
}

/// The GPU's records in f64, with the delays that a camera outside the horizon can state, and the
/// sky in the hole's frame.
fn traces(scene: &Scene, records: &[GpuTrace]) -> Vec<Trace> {
    let (lead, hole_from_disk) = (time_lead(scene), scene.disk.hole_from_disk());
    let in_hole_frame = |trace: Trace| Trace {
        sky: trace.sky.map(|sky| hole_from_disk * sky),
        ..trace
    };
    records
        .iter()
        .map(|record| in_hole_frame(record.trace(lead)))
        .collect()
}

impl GpuTrace {
    /// The record in f64, in the disk's frame. `time_lead` is the part of the delays that the GPU
    /// leaves out; `None` for a camera that has no delays to state.
    pub fn trace(&self, time_lead: Option<f64>) -> Trace {
        let outcome = match self.outcome {
            0 => Outcome::Sky,
            1 => Outcome::Captured,
            _ => Outcome::Unfinished,
        };
        let hit = |i: usize| {
            ((i as u32) < self.hit_count).then(|| {
                let GpuHit { position, g, delay } = self.hits[i];
                let position = position.as_dvec3();
                let phi = position.y.atan2(position.x);
                let phi = if phi <= -PI { phi + TAU } else { phi };
                Hit {
                    r: position.length(),
                    phi,
                    g: f64::from(g),
                    delay: time_lead.map(|lead| lead + f64::from(delay)),
                }
            })
        };
        Trace {
            outcome,
            sky: (outcome == Outcome::Sky).then(|| self.sky.as_dvec3().normalize()),
            hits: [hit(0), hit(1)],
            steps: self.steps,
            residual: f64::from(self.residual),
        }
    }
}
