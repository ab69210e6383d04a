//! What one scene has on the GPU: its uniform, its table and its bindings. A comparison has two.

use super::sky::{NoStars, sky_texture};
use crate::render::star_catalogue::StarCatalogue;
use crate::render::star_limit::StarLimit;
use crate::render::stars::{SceneStars, StarPass, StarPipelines, StarWriter};
use crate::render::wave_limit::WaveLimit;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use lightfall_core::gpu::kernel::{table_bytes, uniform};
use lightfall_core::gpu::{
    Drawable, GpuHotSpot, GpuScene, GpuStructure, GpuTilt, bindings, max_pixels_of_call,
};
use lightfall_core::optics::disk;
use lightfall_core::scene::SkyMode;

/// The numbers of a scene, and the pipeline that draws them.
pub(super) struct Side {
    uniform: UniformBuffer<GpuScene>,
    /// The relativistic disk's flux. Always bound; only the variants that need it read it.
    page_thorne: Buffer,
    /// The disk's structure. Always bound; only the variants that need it read it.
    structure: Buffer,
    /// The hot spot. Always bound; only the variants that need it read it.
    hot_spot: UniformBuffer<GpuHotSpot>,
    /// How the disk is tilted. Always bound; only the variants that need it read it.
    tilt: UniformBuffer<GpuTilt>,
    /// The stars; `None` where the sky has no real ones.
    stars: Option<SceneStars>,
    bind_group: Option<BindGroup>,
    pipelines: Option<SidePipelines>,
    /// Most pixels that one call draws.
    max_pixels_of_call: u32,
}

/// The pipelines of a scene.
#[derive(Clone, Copy)]
pub(super) struct SidePipelines {
    pub(super) picture: CachedRenderPipelineId,
    /// What refines its edges, where there is anything to refine.
    pub(super) refine: Option<CachedComputePipelineId>,
    /// What draws its stars, where it has any.
    pub(super) stars: Option<StarPipelines>,
}

/// What writing a scene takes.
pub(super) struct SideWriter<'a> {
    pub(super) shared: &'a mut Shared,
    pub(super) stars: &'a mut StarPass,
    pub(super) catalogue: StarCatalogue,
    /// The faintest stars that are drawn as points, in V.
    pub(super) star_limit: StarLimit,
    /// The number of the frame, and of all frames that are averaged.
    pub(super) frame: (u32, u32),
    pub(super) cache: &'a PipelineCache,
    pub(super) device: &'a RenderDevice,
    pub(super) queue: &'a RenderQueue,
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
    /// What is bound where the sky has no real stars.
    pub(super) no_stars: NoStars,
    /// The Milky Way, from the first scene on that shows it.
    pub(super) milky_way: Option<TextureView>,
    pub(super) sampler: Sampler,
}

impl Side {
    pub(super) fn new(device: &RenderDevice) -> Self {
        Self {
            uniform: UniformBuffer::from(GpuScene::default()),
            page_thorne: written_buffer(device, "Page-Thorne table", PAGE_THORNE_SIZE),
            structure: written_buffer(device, "disk structure", GpuStructure::SIZE),
            hot_spot: UniformBuffer::from(GpuHotSpot::default()),
            tilt: UniformBuffer::from(GpuTilt::default()),
            stars: None,
            bind_group: None,
            pipelines: None,
            max_pixels_of_call: 0,
        }
    }

    /// Writes a scene, which these pipelines draw, as one of several frames
    /// that are averaged.
    pub(super) fn write(
        &mut self,
        scene: &Drawable,
        pipelines: SidePipelines,
        writer: &mut SideWriter,
    ) {
        let (device, queue) = (writer.device, writer.queue);
        let (frame, frames) = writer.frame;
        let mut numbers = scene.numbers().clone();
        numbers.picture = numbers.picture.of_frame(frame, frames);
        self.uniform.set(numbers);
        self.uniform.write_buffer(device, queue);
        self.hot_spot.set(GpuHotSpot::new(scene));
        self.hot_spot.write_buffer(device, queue);
        self.tilt.set(GpuTilt::new(scene));
        self.tilt.write_buffer(device, queue);
        if let disk::Profile::PageThorne(disk) = disk::Profile::new(scene) {
            queue.write_buffer(&self.page_thorne, 0, &table_bytes(&disk.table()));
        }
        if let Some(structure) = GpuStructure::new(scene, writer.shared.waves.0) {
            queue.write_buffer(&self.structure, 0, &uniform(&structure));
        }
        self.pipelines = Some(pipelines);
        self.max_pixels_of_call = max_pixels_of_call(scene);
        if self.write_stars(scene, pipelines, writer) {
            self.bind_group = None;
        }
        if self.bind_group.is_none() {
            self.bind_group = self.bind(writer);
        }
    }

    /// Writes the scene's stars. Returns whether other buffers than before are to be bound.
    fn write_stars(
        &mut self,
        scene: &Drawable,
        pipelines: SidePipelines,
        writer: &mut SideWriter,
    ) -> bool {
        if scene.sky.mode != SkyMode::Stars || !scene.view.shows_light() {
            return self.stars.take().is_some();
        }
        let SideWriter {
            shared,
            stars: pass,
            catalogue,
            star_limit,
            cache,
            device,
            queue,
            ..
        } = writer;
        let new_texture = shared.milky_way.is_none();
        shared
            .milky_way
            .get_or_insert_with(|| sky_texture(device, queue, true));
        let new_stars = self.stars.is_none();
        let stars = self.stars.get_or_insert_with(|| SceneStars::new(device));
        let new_buffers = stars.write(
            scene,
            &self.uniform,
            pipelines.stars,
            StarWriter {
                pass,
                catalogue,
                star_limit: *star_limit,
                spectrum: &shared.spectrum,
                cache,
                device,
                queue,
            },
        );
        new_texture || new_stars || new_buffers
    }

    fn bind(&self, writer: &SideWriter) -> Option<BindGroup> {
        let shared = &*writer.shared;
        let none = &shared.no_stars;
        let stars = self.stars.as_ref();
        let starlight = match stars {
            Some(stars) => stars.starlight()?,
            None => none.starlight.binding()?,
        };
        let sums = stars.and_then(SceneStars::sums).unwrap_or(&none.sums);
        let milky_way = shared.milky_way.as_ref().filter(|_| stars.is_some());
        Some(writer.device.create_bind_group(
            "geodesic bindings",
            &writer.cache.get_bind_group_layout(&shared.layout),
            &BindGroupEntries::with_indices((
                (bindings::SCENE, self.uniform.binding()?),
                (bindings::SPECTRUM, shared.spectrum.as_entire_binding()),
                (bindings::PAGE_THORNE, self.page_thorne.as_entire_binding()),
                (bindings::ERROR_MAP, shared.error_map.as_entire_binding()),
                (bindings::STRUCTURE, self.structure.as_entire_binding()),
                (bindings::HOT_SPOT, self.hot_spot.binding()?),
                (bindings::TILT, self.tilt.binding()?),
                (bindings::STARLIGHT, starlight),
                (bindings::MILKY_WAY, milky_way.unwrap_or(&none.milky_way)),
                (bindings::MILKY_WAY_SAMPLER, &shared.sampler),
                (bindings::STAR_SUMS, sums.as_entire_binding()),
            )),
        ))
    }

    /// The scene's stars.
    pub(super) fn stars(&self) -> Option<&SceneStars> {
        self.stars.as_ref()
    }

    /// Goes on to another one of the frames that are averaged.
    pub(super) fn set_frame(
        &mut self,
        (frame, frames): (u32, u32),
        device: &RenderDevice,
        queue: &RenderQueue,
    ) {
        let picture = self.uniform.get().picture.of_frame(frame, frames);
        if self.uniform.get().picture != picture {
            self.uniform.get_mut().picture = picture;
            self.uniform.write_buffer(device, queue);
        }
    }

    /// The pipeline and the bindings to draw with, and the most pixels of one call, once a scene has
    /// been written.
    pub(super) fn ready<'a>(
        &'a self,
        cache: &'a PipelineCache,
    ) -> Option<(&'a RenderPipeline, &'a BindGroup, u32)> {
        let pipeline = cache.get_render_pipeline(self.pipelines?.picture)?;
        Some((pipeline, self.bind_group.as_ref()?, self.max_pixels_of_call))
    }

    /// The pipeline and the bindings that refine its edges, where there is anything to refine.
    pub(super) fn refinement<'a>(
        &'a self,
        cache: &'a PipelineCache,
    ) -> Option<(&'a ComputePipeline, &'a BindGroup)> {
        let pipeline = cache.get_compute_pipeline(self.pipelines?.refine?)?;
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
