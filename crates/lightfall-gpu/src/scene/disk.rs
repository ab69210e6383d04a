//! The disk's part of the uniform.

use encase::ShaderType;
use lightfall_model::scene::Scene;
use lightfall_optics::disk::lit;
use lightfall_optics::photometry::DISK_HDR_SCALE;

/// Mirror of `Disk` in shaders/scene.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuDisk {
    pub inner: f32,
    pub outer: f32,
    pub inner_fade: f32,
    pub outer_fade: f32,
    pub temperature: f32,
    pub brightness: f32,
    pub transmission: f32,
}

impl GpuDisk {
    pub(super) fn new(scene: &Scene) -> Self {
        let (disk, inner) = (lit(scene), scene.inner_edge());
        Self {
            inner: inner as f32,
            outer: disk.outer as f32,
            inner_fade: (disk.edge_taper * inner) as f32,
            outer_fade: (disk.edge_taper * disk.outer) as f32,
            temperature: disk.temperature_k as f32,
            brightness: (DISK_HDR_SCALE * disk.brightness) as f32,
            transmission: disk.transmission as f32,
        }
    }
}
