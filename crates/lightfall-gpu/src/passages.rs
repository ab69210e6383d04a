//! What reaches the camera through matter with depth along single rays, by the WGSL that draws the
//! picture.

use super::bindings;
use super::device::Gpu;
use super::error::GpuError;
use super::inputs::Inputs;
use super::kernel::{ArrayKernel, uniform};
use super::rays::{GpuTrace, MAX_RAYS};
use super::scene::GpuScene;
use super::shader::Variant;
use encase::ShaderType;
use glam::{Vec3, Vec4};
use lightfall_model::scene::{Frame, Scene};

/// What reaches the camera along a ray, as shaders/medium/passage.wgsl lays it out.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuPassage {
    pub light: Vec3,
    pub transmission: f32,
    pub ray: GpuTrace,
    pub samples: u32,
}

impl GpuPassage {
    /// Whether its light and its transmission are numbers that light can have.
    pub fn is_finite(&self) -> bool {
        let light = self.light.is_finite() && self.light.min_element() >= 0.0;
        light && (0.0..=1.0).contains(&self.transmission)
    }

    /// Whether the ray was given up before its end.
    pub fn is_unfinished(&self) -> bool {
        self.ray.outcome == OUTCOME_UNFINISHED
    }
}

/// Mirror of `OUTCOME_UNFINISHED` in shaders/trace.wgsl.
const OUTCOME_UNFINISHED: u32 = 2;

/// The compiled variant of scenes with matter with depth, for single rays of their cameras.
#[derive(Debug)]
pub struct PassageKernel {
    kernel: ArrayKernel,
    source: String,
}

impl PassageKernel {
    /// Compiles the variant of a scene with matter with depth.
    ///
    /// # Errors
    /// The GPU cannot trace the scene.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        let source = Variant::passages(scene).source();
        let mut uniforms = Inputs::new(scene).declared_in(&source);
        uniforms.push((bindings::SCENE, uniform(&GpuScene::for_rays(scene)?)));
        let kernel = ArrayKernel::new(gpu, &source, "passages", &uniforms)?;
        Ok(Self { kernel, source })
    }

    /// Follows rays through a scene of this variant. Directions are unit vectors (right, up,
    /// forward) of its camera. Returns one passage per ray, in order.
    ///
    /// # Errors
    /// The GPU cannot trace the scene, or the device failed.
    pub fn passages(
        &self,
        gpu: &Gpu,
        scene: &Scene,
        directions: &[Vec3],
    ) -> Result<Vec<GpuPassage>, GpuError> {
        let numbers = GpuScene::new(scene, &Frame::of(scene))?;
        let tables = Inputs::new(scene).declared_in(&self.source);
        for (binding, bytes) in tables.iter().chain([&(bindings::SCENE, uniform(&numbers))]) {
            self.kernel.write_uniform(gpu, *binding, bytes);
        }
        let mut passages = Vec::with_capacity(directions.len());
        for batch in directions.chunks(MAX_RAYS) {
            let batch = batch.iter().map(|direction| direction.extend(0.0));
            let batch: Vec<Vec4> = batch.collect();
            passages.extend(self.kernel.run::<Vec4, GpuPassage>(gpu, &batch)?);
        }
        Ok(passages)
    }
}
