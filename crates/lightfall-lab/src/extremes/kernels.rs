//! Compiled shaders that many scenes share.

use lightfall_accuracy::Ray;
use lightfall_gpu::rays::RayKernel;
use lightfall_gpu::{Gpu, GpuError, Variant};
use lightfall_model::scene::Scene;
use lightfall_optics::trace::Trace;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Compiled shaders, by variant. Most cells share a few variants.
#[derive(Default)]
pub(super) struct Kernels(HashMap<Variant, RayKernel>);

impl Kernels {
    /// The answers of the scene's method to these rays.
    pub(super) fn traces(
        &mut self,
        gpu: &Gpu,
        scene: &Scene,
        rays: &[Ray],
    ) -> Result<Vec<Trace>, GpuError> {
        let given: Vec<_> = rays.iter().map(Ray::given).collect();
        let kernel = match self.0.entry(Variant::rays(scene)) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => new.insert(RayKernel::new(gpu, scene)?),
        };
        kernel.trace_camera_rays(gpu, scene, &given)
    }
}
