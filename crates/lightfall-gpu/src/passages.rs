//! What reaches the camera through matter with depth along single rays, by the WGSL that draws the
//! picture.

use super::bindings;
use super::device::Gpu;
use super::error::GpuError;
use super::inputs::Inputs;
use super::kernel::{ArrayKernel, uniform};
use super::rays::{GpuTrace, MAX_RAYS};
use super::scene::{GpuScene, time_lead};
use super::shader::Variant;
use encase::ShaderType;
use glam::{Vec3, Vec4};
use lightfall_model::scene::{Frame, Scene};

/// What reaches the camera along a ray, as `PassageRecord` in
/// shaders/medium/passages.wgsl lays it out.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuPassage {
    pub light: Vec3,
    pub transmission: f32,
    pub ray: GpuTrace,
    pub samples: u32,
    pub error: f32,
    pub luminance: f32,
    /// Radius and height in r_s, observed over emitted frequency, and delay in r_s/c, which is NaN for a
    /// camera at or inside the horizon, and without meaning for rays without extent.
    pub means: Vec4,
}

impl GpuPassage {
    /// A ray that meets no matter with depth.
    pub fn without_matter() -> Self {
        Self {
            transmission: 1.0,
            ..Self::default()
        }
    }

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

/// A ray of a scene's camera, and those of the next pixels to the right and below: unit vectors (right, up,
/// forward). They matter for pixels only.
#[derive(ShaderType, Clone, Copy, Debug)]
pub struct GivenRay {
    /// The ray.
    pub direction: Vec3,
    /// The next one to the right.
    pub right: Vec3,
    /// The next one below.
    pub below: Vec3,
}

impl From<Vec3> for GivenRay {
    /// A single ray, without extent.
    fn from(direction: Vec3) -> Self {
        Self {
            direction,
            right: direction,
            below: direction,
        }
    }
}

/// The compiled variant of scenes with matter with depth, for single rays of their cameras.
#[derive(Debug)]
pub struct PassageKernel {
    kernel: ArrayKernel,
    source: String,
}

impl PassageKernel {
    /// Compiles the variant of a scene with matter with depth, for rays that see points of its
    /// structure, as the f64 twin's do.
    ///
    /// # Errors
    /// The GPU cannot trace the scene.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        Self::of(gpu, scene, false)
    }

    /// The same for rays of pixels, which see what the picture shows.
    ///
    /// # Errors
    /// The GPU cannot trace the scene.
    pub fn of_pixels(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        Self::of(gpu, scene, true)
    }

    fn of(gpu: &Gpu, scene: &Scene, filters: bool) -> Result<Self, GpuError> {
        let source = Variant::passages(scene, filters).source();
        let mut uniforms = Inputs::new(scene).declared_in(&source);
        uniforms.push((bindings::SCENE, uniform(&GpuScene::for_rays(scene)?)));
        let kernel = ArrayKernel::new(gpu, &source, "passages", &uniforms)?;
        Ok(Self { kernel, source })
    }

    /// Follows rays through a scene of this variant. Returns one passage per ray, in order.
    ///
    /// # Errors
    /// The GPU cannot trace the scene, or the device failed.
    pub fn passages(
        &self,
        gpu: &Gpu,
        scene: &Scene,
        rays: impl IntoIterator<Item = impl Into<GivenRay>>,
    ) -> Result<Vec<GpuPassage>, GpuError> {
        let rays: Vec<GivenRay> = rays.into_iter().map(Into::into).collect();
        let numbers = GpuScene::new(scene, &Frame::of(scene))?;
        let tables = Inputs::new(scene).declared_in(&self.source);
        for (binding, bytes) in tables.iter().chain([&(bindings::SCENE, uniform(&numbers))]) {
            self.kernel.write_uniform(gpu, *binding, bytes);
        }
        let mut passages = Vec::with_capacity(rays.len());
        for batch in rays.chunks(MAX_RAYS) {
            passages.extend(self.kernel.run::<GivenRay, GpuPassage>(gpu, batch)?);
        }
        // The part of the delays that the GPU leaves out.
        let lead = time_lead(scene).unwrap_or(f64::NAN);
        for passage in &mut passages {
            passage.means.w = (lead + f64::from(passage.means.w)) as f32;
        }
        Ok(passages)
    }
}
