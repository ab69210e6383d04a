//! The resources of one scene's stars on the GPU: numbers, images and sums. A comparison has two.

use super::buffers::Drawn;
use super::kernels::{StarPipelines, layout};
use super::list::StarLists;
use super::ready::{ReadyStars, Stale};
use super::sides::MeshNumbers;
use crate::detail_limits::DetailLimits;
use crate::geodesic::InputBuffers;
use crate::graphics::{Graphics, create_buffer};
use bevy::prelude::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::RenderDevice;
use lightfall_core::gpu::bindings::{
    SCENE, SPECTRUM, STAR_INDEX, STAR_LIST, STAR_MESH, STAR_SUMS, STAR_TABLE, STARS, STRUCTURE,
    THICK_DISK, WAVE_HEIGHTS,
};
use lightfall_core::gpu::kernel::table_bytes;
use lightfall_core::gpu::stars::{GpuStars, StarKernel, TABLE_SIZE, table_rows};
use lightfall_core::gpu::{Drawable, GpuScene, GpuStarlight, Variant};
use lightfall_core::optics::stars::images::Inversion;
use lightfall_core::optics::stars::{Catalogue, Depth, hole_from_celestial};
use lightfall_core::scene::{Part, Scene};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The stars of one scene.
pub(crate) struct SceneStars {
    /// The scene that was written last, without what changes no image, the limits of its details,
    /// and how often the kernels' shaders had been reloaded.
    written: Option<(Scene, DetailLimits, u32)>,
    numbers: UniformBuffer<GpuStars>,
    /// Written where images are found by a mesh.
    meshes: MeshNumbers,
    starlight: UniformBuffer<GpuStarlight>,
    table: Buffer,
    /// The list of stars and the buffers that depend on its length or the picture's size.
    drawn: Option<Drawn>,
    pipelines: Option<StarPipelines>,
    /// Whether the list of images belongs to an earlier scene, and whether the sums belong to an
    /// earlier scene or another part of the picture.
    images_changed: AtomicBool,
    sums_changed: AtomicBool,
}

impl SceneStars {
    pub(crate) fn new(device: &RenderDevice) -> Self {
        Self {
            written: None,
            numbers: UniformBuffer::from(GpuStars::default()),
            meshes: MeshNumbers::default(),
            starlight: UniformBuffer::from(GpuStarlight::default()),
            table: create_buffer(
                device,
                "table of images",
                TABLE_SIZE,
                BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            ),
            drawn: None,
            pipelines: None,
            images_changed: AtomicBool::new(false),
            sums_changed: AtomicBool::new(false),
        }
    }
}

/// The resources for writing a scene's stars to the GPU.
pub(crate) struct StarWriter<'a> {
    pub(crate) lists: &'a mut StarLists,
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) limits: DetailLimits,
    /// The part of the picture that is drawn; `None` for all of it.
    pub(crate) part: Option<Part>,
    /// The uniforms of the scene, the one in place of those that it has no use for, and whether any
    /// of them is new.
    pub(crate) inputs: &'a InputBuffers,
    pub(crate) no_input: &'a Buffer,
    pub(crate) new_inputs: bool,
    pub(crate) graphics: &'a Graphics<'a>,
}

impl SceneStars {
    /// Writes a scene, whose numbers are in the uniform `numbers`. Returns whether a buffer that the
    /// picture's shader binds is new.
    pub(crate) fn write(
        &mut self,
        scene: &Drawable,
        numbers: &UniformBuffer<GpuScene>,
        pipelines: Option<StarPipelines>,
        writer: StarWriter,
    ) -> bool {
        let Graphics { device, queue, .. } = writer.graphics;
        self.pipelines = pipelines;
        if writer.new_inputs {
            (self.written, self.drawn) = (None, None);
        }
        let reloads = pipelines.map_or(0, |pipelines| pipelines.reloads);
        let wanted = (scene.for_stars(), writer.limits, reloads);
        if self.written.as_ref() == Some(&wanted) {
            return self.go_to_part(scene, numbers, &writer);
        }
        // A scene that can be drawn has an observer, and so has a depth.
        let Ok(depth) = Depth::new(scene, writer.limits.faintest_star) else {
            return self.draw_nothing(scene, Depth::NO_POINTS, writer.graphics);
        };
        let list = writer
            .lists
            .get(writer.catalogue, scene.sky.seed, depth.last, device);
        // Pixels may be so large that no star stands out, and a catalogue may have none. No binding
        // may be empty.
        if list.stars.is_empty() {
            return self.draw_nothing(scene, depth, writer.graphics);
        }
        let sky = &scene.sky;
        let turn = hole_from_celestial(sky.ra_deg, sky.dec_deg, sky.roll_deg);
        let (mut mesh, mut rounds) = (None, 1);
        if Variant::uses_star_mesh(scene) {
            let Some((layout, meshes)) =
                self.meshes
                    .write(scene, (&list.stars, turn), writer.graphics)
            else {
                return self.draw_nothing(scene, Depth::NO_POINTS, writer.graphics);
            };
            (mesh, rounds) = (Some(layout), meshes);
            self.numbers
                .set(GpuStars::for_mesh(scene, &list.stars, depth));
        } else {
            let Ok(inversion) = Inversion::new(scene) else {
                return self.draw_nothing(scene, Depth::NO_POINTS, writer.graphics);
            };
            self.numbers
                .set(GpuStars::new(scene, &inversion, &list.stars, turn, depth));
            if let Some(rows) = table_rows(&inversion) {
                queue.write_buffer(&self.table, 0, &table_bytes(&rows));
            }
        }
        self.starlight.set(GpuStarlight::new(scene, depth));
        self.written = Some(wanted);
        self.images_changed.store(true, Ordering::Relaxed);
        let size = scene.picture.size();
        let fits = |drawn: &Drawn| {
            drawn.size == size
                && (drawn.mesh, drawn.rounds) == (mesh, rounds)
                && Arc::ptr_eq(&drawn.list, &list)
        };
        let kept = self.drawn.take().filter(fits);
        let is_new = kept.is_none();
        let mut drawn = kept.unwrap_or_else(|| Drawn::new(list, size, (mesh, rounds), device));
        drawn.part = writer.part;
        self.drawn = Some(drawn);
        self.write_part(scene, writer.graphics);
        let new_sums = self.make_room_for_sums(numbers, is_new, &writer);
        is_new || new_sums
    }

    /// Goes on to another part of the picture, whose images are the same. Returns whether the sums
    /// have a new buffer.
    fn go_to_part(
        &mut self,
        scene: &Drawable,
        numbers: &UniformBuffer<GpuScene>,
        writer: &StarWriter,
    ) -> bool {
        match &mut self.drawn {
            Some(drawn) if drawn.part != writer.part => drawn.part = writer.part,
            _ => return false,
        }
        self.write_part(scene, writer.graphics);
        self.make_room_for_sums(numbers, false, writer)
    }

    /// Writes the numbers that depend on the part of the picture that is drawn.
    fn write_part(&mut self, scene: &Drawable, graphics: &Graphics) {
        let Graphics { device, queue, .. } = graphics;
        let part = self.drawn.as_ref().and_then(|drawn| drawn.part);
        let size = part.map_or(scene.picture.size(), |part| part.size);
        self.numbers.set(self.numbers.get().clone().of_part(size));
        self.numbers.write_buffer(device, queue);
        self.starlight.set(self.starlight.get().of_part(size));
        self.starlight.write_buffer(device, queue);
        self.sums_changed.store(true, Ordering::Relaxed);
    }

    /// Draws no points; the diffuse sky has the light of stars beyond `depth`. Returns whether sums
    /// were bound before.
    fn draw_nothing(&mut self, scene: &Drawable, depth: Depth, graphics: &Graphics) -> bool {
        self.starlight.set(GpuStarlight::new(scene, depth));
        self.starlight
            .write_buffer(&graphics.device, &graphics.queue);
        // The scene that was written last has lost its sums.
        self.written = None;
        self.drawn.take().is_some()
    }

    /// Makes the sums as large as the part of the picture needs, and binds all buffers if any of them
    /// is new. Returns whether the sums are.
    fn make_room_for_sums(
        &mut self,
        numbers: &UniformBuffer<GpuScene>,
        is_new: bool,
        writer: &StarWriter,
    ) -> bool {
        let Graphics { device, cache, .. } = writer.graphics;
        let Some(drawn) = &mut self.drawn else {
            return false;
        };
        let new_sums = drawn.make_room_for_sums(device);
        if !new_sums && !is_new {
            return false;
        }
        drawn.bind_groups = [const { Vec::new() }; StarKernel::ALL.len()];
        let of_mesh = drawn.rounds;
        let all = StarKernel::ALL.into_iter().flat_map(|kernel| {
            let rounds = if kernel.is_of_mesh() { of_mesh } else { 1 };
            (0..rounds).map(move |round| (kernel, round))
        });
        for (kernel, round) in all {
            let side = self.meshes.scene(round).filter(|_| kernel.is_of_mesh());
            let numbers = side.unwrap_or(numbers);
            // Kernels that the scene does not run have no buffers.
            let bindings = kernel.reads().iter().chain(kernel.writes());
            let entries: Option<Vec<_>> = bindings
                .map(|binding| {
                    let resource = match *binding {
                        SCENE => numbers.binding()?,
                        SPECTRUM | STRUCTURE | WAVE_HEIGHTS | THICK_DISK => {
                            let buffer = writer.inputs.buffer(*binding);
                            buffer.unwrap_or(writer.no_input).as_entire_binding()
                        }
                        STARS => self.numbers.binding()?,
                        STAR_TABLE => self.table.as_entire_binding(),
                        STAR_MESH => drawn.mesh.and(self.meshes.mesh(round))?,
                        STAR_LIST => drawn.list.buffer.as_entire_binding(),
                        STAR_INDEX => drawn.list.index(device).as_entire_binding(),
                        _ => drawn.buffer(*binding)?.as_entire_binding(),
                    };
                    let binding = *binding;
                    Some(BindGroupEntry { binding, resource })
                })
                .collect();
            let layout = cache.get_bind_group_layout(&layout(kernel));
            let group =
                entries.map(|entries| device.create_bind_group(kernel.word(), &layout, &entries));
            drawn.bind_groups[kernel as usize].extend(group);
        }
        new_sums
    }

    /// The numbers of the sky, once a scene has been written.
    pub(crate) fn starlight(&self) -> Option<BindingResource<'_>> {
        self.starlight.binding()
    }

    /// The light of the points in each pixel, once a scene has been written.
    pub(crate) fn sums(&self) -> Option<&Buffer> {
        self.drawn.as_ref()?.buffer(STAR_SUMS)
    }

    /// What belongs to an earlier scene or another part of the picture, if anything does. It counts as
    /// that of this one from now on.
    pub(super) fn take_changed(&self) -> Option<Stale> {
        let images = self.images_changed.swap(false, Ordering::Relaxed);
        let sums = self.sums_changed.swap(false, Ordering::Relaxed);
        match (images, sums) {
            (true, _) => Some(Stale::All),
            (false, true) => Some(Stale::Sums),
            (false, false) => None,
        }
    }

    /// The passes, once they can run.
    pub(super) fn ready<'a>(&'a self, cache: &'a PipelineCache) -> Option<ReadyStars<'a>> {
        let kernels = self.pipelines?.kernels();
        Some(ReadyStars {
            kernels: kernels
                .map(|(kernel, id)| Some((kernel, cache.get_compute_pipeline(id)?)))
                .collect::<Option<_>>()?,
            drawn: self.drawn.as_ref()?,
            max_traced: self.written.as_ref()?.1.traced_stars,
        })
    }
}
