//! What one scene has on the GPU: its uniform, its table and its bindings. A comparison has two.

use crate::render::wave_limit::WaveLimit;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use lightfall_core::gpu::kernel::{table_bytes, uniform};
use lightfall_core::gpu::{Drawable, GpuHotSpot, GpuScene, GpuStructure, bindings};
use lightfall_core::optics::disk;

/// The numbers of a scene, and the pipeline that draws them.
pub(super) struct Side {
    uniform: UniformBuffer<GpuScene>,
    /// The relativistic disk's flux. Always bound; only the variants that need it read it.
    page_thorne: Buffer,
    /// The disk's structure. Always bound; only the variants that need it read it.
    structure: Buffer,
    /// The hot spot. Always bound; only the variants that need it read it.
    hot_spot: UniformBuffer<GpuHotSpot>,
    bind_group: Option<BindGroup>,
    pipeline: Option<CachedRenderPipelineId>,
}

/// What every side binds in addition to its own numbers.
pub(super) struct Shared {
    pub(super) layout: BindGroupLayoutDescriptor,
    pub(super) spectrum: Buffer,
    /// The map of the view `error`. Always bound; only that view reads it, and only the current
    /// scene can have that view.
    pub(super) error_map: Buffer,
    /// The most waves of the disk's structure that are drawn.
    pub(super) waves: WaveLimit,
}

impl Side {
    pub(super) fn new(device: &RenderDevice) -> Self {
        Self {
            uniform: UniformBuffer::from(GpuScene::default()),
            page_thorne: written_buffer(device, "Page-Thorne table", PAGE_THORNE_SIZE),
            structure: written_buffer(device, "disk structure", GpuStructure::SIZE),
            hot_spot: UniformBuffer::from(GpuHotSpot::default()),
            bind_group: None,
            pipeline: None,
        }
    }

    /// Writes a scene, which this pipeline draws.
    pub(super) fn write(
        &mut self,
        scene: &Drawable,
        pipeline: CachedRenderPipelineId,
        shared: &Shared,
        (cache, device, queue): (&PipelineCache, &RenderDevice, &RenderQueue),
    ) {
        self.uniform.set(scene.numbers().clone());
        self.uniform.write_buffer(device, queue);
        self.hot_spot.set(GpuHotSpot::new(scene));
        self.hot_spot.write_buffer(device, queue);
        if let disk::Profile::PageThorne(disk) = disk::Profile::new(scene) {
            queue.write_buffer(&self.page_thorne, 0, &table_bytes(&disk.table()));
        }
        if let Some(structure) = GpuStructure::new(scene, shared.waves.0) {
            queue.write_buffer(&self.structure, 0, &uniform(&structure));
        }
        self.pipeline = Some(pipeline);
        if self.bind_group.is_none()
            && let Some(uniform) = self.uniform.binding()
            && let Some(hot_spot) = self.hot_spot.binding()
        {
            self.bind_group = Some(device.create_bind_group(
                "geodesic bindings",
                &cache.get_bind_group_layout(&shared.layout),
                &BindGroupEntries::with_indices((
                    (bindings::SCENE, uniform),
                    (bindings::SPECTRUM, shared.spectrum.as_entire_binding()),
                    (bindings::PAGE_THORNE, self.page_thorne.as_entire_binding()),
                    (bindings::ERROR_MAP, shared.error_map.as_entire_binding()),
                    (bindings::STRUCTURE, self.structure.as_entire_binding()),
                    (bindings::HOT_SPOT, hot_spot),
                )),
            ));
        }
    }

    /// The pipeline and the bindings to draw with, once a scene has been written.
    pub(super) fn ready<'a>(
        &'a self,
        cache: &'a PipelineCache,
    ) -> Option<(&'a RenderPipeline, &'a BindGroup)> {
        let pipeline = self.pipeline.and_then(|id| cache.get_render_pipeline(id))?;
        Some((pipeline, self.bind_group.as_ref()?))
    }
}

/// A uniform that is written when the scene changes.
fn written_buffer(device: &RenderDevice, label: &'static str, size: u64) -> Buffer {
    device.create_buffer(&BufferDescriptor {
        label: Some(label),
        size,
        usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// Size of the table of the disk model `page-thorne`, in bytes.
pub(super) const PAGE_THORNE_SIZE: u64 = size_of::<[[f32; 4]; disk::TABLE_LEN]>() as u64;
