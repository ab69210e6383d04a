//! One scene's resources on the GPU: its numbers, inputs and bindings. A comparison has two sides.

use super::inputs::InputBuffers;
use super::queue::SidePipelines;
use super::sky::{SkyOnGpu, SkyPictures};
use crate::detail_limits::DetailLimits;
use crate::draw_request::DrawRequest;
use crate::graphics::{Graphics, create_buffer};
use crate::stars::{SceneStars, StarCatalogue, StarLists, StarWriter};
use bevy::math::UVec2;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use lightfall_core::gpu::bindings::{
    self, MILKY_WAY, MILKY_WAY_SAMPLER, SCENE, STAR_SUMS, STARLIGHT,
};
use lightfall_core::gpu::{
    Drawable, ErrorMap, GpuPicture, GpuScene, Inputs, SkyTexture, max_pixels_of_call,
};
use lightfall_core::optics::sky_picture::SkyPicture;
use lightfall_core::scene::{Frame, Part, SkyMode};

/// The numbers of a scene, and the pipelines that draw them.
#[derive(Default)]
pub(super) struct Side {
    uniform: UniformBuffer<GpuScene>,
    inputs: InputBuffers,
    /// The stars; `None` where the sky has no real ones.
    stars: Option<SceneStars>,
    /// The picture of the sky; `None` in other modes of the sky.
    sky: Option<SkyOnGpu>,
    bind_group: Option<BindGroup>,
    pipelines: Option<SidePipelines>,
    /// Where the scene's own picture begins in the target, in pixels.
    corner: UVec2,
    /// The part of the picture that is drawn; `None` for all of it.
    part: Option<Part>,
    /// Most pixels that one call draws.
    max_pixels_of_call: u32,
}

/// The resources for writing a scene to the GPU.
pub(super) struct SideWriter<'a> {
    pub(super) shared: &'a mut Shared,
    pub(super) layout: &'a BindGroupLayoutDescriptor,
    pub(super) errors: &'a ErrorMap,
    pub(super) limits: DetailLimits,
    pub(super) part: Option<Part>,
    pub(super) lists: &'a mut StarLists,
    pub(super) catalogue: StarCatalogue,
    /// What says which of the averaged frames comes next.
    pub(super) request: Option<&'a DrawRequest>,
    pub(super) graphics: &'a Graphics<'a>,
}

/// Inputs that both sides share, and placeholders for inputs that a scene does not need.
pub(super) struct Shared {
    /// The Milky Way, from the first scene on that shows it.
    milky_way: Option<TextureView>,
    sampler: Sampler,
    no_milky_way: TextureView,
    pictures: SkyPictures,
    /// A uniform or a storage array that no shader reads.
    no_input: Buffer,
}

impl Shared {
    pub(super) fn new(device: &RenderDevice, queue: &RenderQueue) -> Self {
        Self {
            milky_way: None,
            sampler: device.create_sampler(&SkyTexture::sampler()),
            no_milky_way: sky_texture(device, queue, false),
            pictures: SkyPictures::default(),
            no_input: create_buffer(
                device,
                "no input",
                size_of::<[u32; 4]>() as u64,
                BufferUsages::UNIFORM | BufferUsages::STORAGE,
            ),
        }
    }
}

/// The Milky Way as the shaders read it, or one texel a face in its place.
fn sky_texture(device: &RenderDevice, queue: &RenderQueue, shown: bool) -> TextureView {
    let texture = device.create_texture_with_data(
        queue,
        &SkyTexture::descriptor(shown),
        TextureDataOrder::LayerMajor,
        &SkyTexture::bytes(shown),
    );
    texture.create_view(&SkyTexture::view())
}

impl Side {
    /// Writes a scene, which these pipelines draw. Its own picture begins at `corner` of the target.
    pub(super) fn write(
        &mut self,
        (scene, corner): (&Drawable, UVec2),
        pipelines: SidePipelines,
        writer: &mut SideWriter,
    ) {
        let Graphics { device, queue, .. } = writer.graphics;
        let mut numbers = scene.numbers().clone();
        (self.corner, self.part) = (corner, writer.part);
        numbers.picture = self.picture(scene, writer.request);
        self.uniform.set(numbers);
        self.uniform.write_buffer(device, queue);
        let inputs = Inputs {
            scene,
            max_waves: writer.limits.waves,
            errors: Some(writer.errors),
        };
        let new_inputs = self.inputs.write(inputs.of_picture(), device, queue);
        self.pipelines = Some(pipelines);
        self.max_pixels_of_call = max_pixels_of_call(scene);
        let new_stars = self.write_stars(scene, pipelines, new_inputs, writer);
        let new_sky = self.write_sky(scene, writer);
        if new_inputs || new_stars || new_sky || self.bind_group.is_none() {
            self.bind_group = self.bind(writer);
        }
    }

    /// Writes the picture of the scene's sky. Returns whether another one than before is to be bound.
    fn write_sky(&mut self, scene: &Drawable, writer: &mut SideWriter) -> bool {
        let shown = scene.view.shows_light();
        // A scene that can be drawn has its picture.
        let picture = SkyPicture::of(scene).ok().flatten().filter(|_| shown);
        let before = self.sky.take();
        let is_new = match (&before, &picture) {
            (Some(before), Some(picture)) => !before.shows(picture),
            (before, picture) => before.is_some() != picture.is_some(),
        };
        self.sky = match picture {
            Some(picture) if is_new => Some(writer.shared.pictures.get(&picture, writer.graphics)),
            Some(_) => before,
            None => None,
        };
        is_new
    }

    /// Writes the scene's stars. Returns whether other buffers than before are to be bound.
    fn write_stars(
        &mut self,
        scene: &Drawable,
        pipelines: SidePipelines,
        new_inputs: bool,
        writer: &mut SideWriter,
    ) -> bool {
        let shows_stars = scene.sky.has_star_points() && scene.view.shows_light();
        if !shows_stars {
            return self.stars.take().is_some();
        }
        let SideWriter {
            shared,
            lists,
            catalogue,
            limits,
            part,
            graphics,
            ..
        } = writer;
        let is_milky_way = scene.sky.mode == SkyMode::Stars;
        let new_texture = is_milky_way && shared.milky_way.is_none();
        if is_milky_way {
            shared
                .milky_way
                .get_or_insert_with(|| sky_texture(&graphics.device, &graphics.queue, true));
        }
        let new_stars = self.stars.is_none();
        let stars = self
            .stars
            .get_or_insert_with(|| SceneStars::new(&graphics.device));
        let new_buffers = stars.write(
            scene,
            &self.uniform,
            pipelines.stars,
            StarWriter {
                lists,
                catalogue,
                limits: *limits,
                part: *part,
                inputs: &self.inputs,
                no_input: &shared.no_input,
                new_inputs,
                graphics,
            },
        );
        new_texture || new_stars || new_buffers
    }

    fn bind(&self, writer: &SideWriter) -> Option<BindGroup> {
        let shared = &*writer.shared;
        let stars = self.stars.as_ref();
        let milky_way = shared.milky_way.as_ref().filter(|_| stars.is_some());
        let map = self.sky.as_ref().map(SkyOnGpu::view).or(milky_way);
        let no_input = &shared.no_input;
        let sums = stars.and_then(SceneStars::sums).unwrap_or(no_input);
        let rows = bindings::ALL.iter().filter(|row| row.in_picture);
        let entries = rows.map(|row| {
            let resource = match row.number {
                SCENE => self.uniform.binding()?,
                STARLIGHT => match stars {
                    Some(stars) => stars.starlight()?,
                    None => {
                        let of_picture = self.inputs.buffer(STARLIGHT).unwrap_or(no_input);
                        of_picture.as_entire_binding()
                    }
                },
                MILKY_WAY => map.unwrap_or(&shared.no_milky_way).into_binding(),
                MILKY_WAY_SAMPLER => shared.sampler.into_binding(),
                STAR_SUMS => sums.as_entire_binding(),
                input => {
                    let buffer = self.inputs.buffer(input).unwrap_or(no_input);
                    buffer.as_entire_binding()
                }
            };
            let binding = row.number;
            Some(BindGroupEntry { binding, resource })
        });
        let Graphics { device, cache, .. } = writer.graphics;
        Some(device.create_bind_group(
            "geodesic bindings",
            &cache.get_bind_group_layout(writer.layout),
            &entries.collect::<Option<Vec<_>>>()?,
        ))
    }

    /// The scene's stars.
    pub(super) fn stars(&self) -> Option<&SceneStars> {
        self.stars.as_ref()
    }

    /// Goes on to another one of the frames that are averaged.
    pub(super) fn set_frame(
        &mut self,
        scene: &Drawable,
        request: Option<&DrawRequest>,
        graphics: &Graphics,
    ) {
        let picture = self.picture(scene, request);
        if self.uniform.get().picture != picture {
            self.uniform.get_mut().picture = picture;
            self.uniform.write_buffer(&graphics.device, &graphics.queue);
        }
    }

    /// The numbers of the next frame.
    fn picture(&self, scene: &Drawable, request: Option<&DrawRequest>) -> GpuPicture {
        let frame = Frame::of(scene).with_part(self.part).at_corner(self.corner);
        let frame = request.map_or(frame, |request| request.next_sample(frame));
        GpuPicture::new(scene, &frame)
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
