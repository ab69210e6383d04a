//! The resources of one scene's stars on the GPU: numbers, images and sums. A comparison has two.

use super::kernels::{StarPipelines, layout};
use super::list::{GpuStarList, StarLists};
use crate::detail_limits::DetailLimits;
use crate::geodesic::InputBuffers;
use crate::graphics::{Graphics, create_buffer};
use bevy::prelude::*;
use bevy::render::render_resource::encase::internal::WriteInto;
use bevy::render::render_resource::*;
use bevy::render::renderer::{RenderDevice, RenderQueue};
use lightfall_core::gpu::bindings::{
    CANDIDATE_COUNT, CANDIDATES, MESH_POINTS, SCENE, SPECTRUM, STAR_COUNT, STAR_IMAGES, STAR_INDEX,
    STAR_LIST, STAR_MESH, STAR_SUMS, STAR_TABLE, STARS, STRUCTURE, THICK_DISK, WAVE_HEIGHTS,
};
use lightfall_core::gpu::kernel::table_bytes;
use lightfall_core::gpu::stars::{
    CANDIDATE_COUNT_SIZE, COUNT_SIZE, EMPTY_COUNT, GpuStarMesh, GpuStars, StarKernel, StarSide,
    TABLE_SIZE, candidates_size, empty_candidate_count, images_size, mesh_layout, mesh_points_size,
    solve_workgroups, sums_size, table_rows,
};
use lightfall_core::gpu::{Drawable, GpuScene, GpuStarlight, Variant};
use lightfall_core::optics::stars::images::{Inversion, MeshLayout};
use lightfall_core::optics::stars::{Catalogue, Depth, hole_from_celestial};
use lightfall_core::scene::{Frame, Scene};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The stars of one scene.
pub(crate) struct SceneStars {
    /// The scene that was written last, without what changes no image, the limits of its details,
    /// and how often the kernels' shaders had been reloaded.
    written: Option<(Scene, DetailLimits, u32)>,
    numbers: UniformBuffer<GpuStars>,
    /// Written where images are found by a mesh, for each of its sides, or for the picture itself.
    meshes: Vec<UniformBuffer<GpuStarMesh>>,
    /// The scene on each side, if there are any.
    sides: Vec<UniformBuffer<GpuScene>>,
    starlight: UniformBuffer<GpuStarlight>,
    table: Buffer,
    /// The list of stars and the buffers that depend on its length or the picture's size.
    drawn: Option<Drawn>,
    pipelines: Option<StarPipelines>,
    /// Whether the sums belong to an earlier scene.
    changed: AtomicBool,
}

struct Drawn {
    list: Arc<GpuStarList>,
    size: UVec2,
    /// Unless images are found by inversion.
    mesh: Option<MeshLayout>,
    /// The buffers that the kernels write.
    buffers: Vec<(u32, Buffer)>,
    /// The bindings of the kernels, in the order of [`StarKernel::ALL`]: those of the mesh once for
    /// each of its sides.
    bind_groups: [Vec<BindGroup>; StarKernel::ALL.len()],
    /// How many pictures have a mesh.
    rounds: usize,
    /// Empty lists of candidates, for each round but the first.
    no_candidates: Buffer,
}

/// A scene's stars whose passes can run.
pub(super) struct ReadyStars<'a> {
    kernels: Vec<(StarKernel, &'a ComputePipeline)>,
    drawn: &'a Drawn,
    /// How many candidates rays follow at most.
    max_traced: u32,
}

impl SceneStars {
    pub(crate) fn new(device: &RenderDevice) -> Self {
        Self {
            written: None,
            numbers: UniformBuffer::from(GpuStars::default()),
            meshes: Vec::new(),
            sides: Vec::new(),
            starlight: UniformBuffer::from(GpuStarlight::default()),
            table: create_buffer(
                device,
                "table of images",
                TABLE_SIZE,
                BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            ),
            drawn: None,
            pipelines: None,
            changed: AtomicBool::new(false),
        }
    }
}

/// The resources for writing a scene's stars to the GPU.
pub(crate) struct StarWriter<'a> {
    pub(crate) lists: &'a mut StarLists,
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) limits: DetailLimits,
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
            return false;
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
        let by_mesh = Variant::uses_star_mesh(scene);
        let sides = if by_mesh {
            StarSide::all_of(scene)
        } else {
            Vec::new()
        };
        // All sides have the same size.
        let searched: &Scene = sides.first().map_or(scene, |side| &side.scene);
        let mesh = by_mesh.then(|| mesh_layout(searched, MeshLayout::CELLS));
        let rounds = sides.len().max(1);
        self.sides.truncate(sides.len());
        if let Some(layout) = &mesh {
            self.numbers
                .set(GpuStars::for_mesh(scene, &list.stars, depth));
            let own = GpuStarMesh::new(searched, layout, &list.stars, turn);
            let on_sides = sides.iter().map(|side| own.clone().on_side(side));
            let meshes: Vec<_> = on_sides.chain([own.clone()]).take(rounds).collect();
            write_all(&mut self.meshes, meshes, writer.graphics);
            let numbers = sides
                .iter()
                .map(|side| GpuScene::new(&side.scene, &Frame::of(&side.scene)).ok());
            let Some(numbers) = numbers.collect::<Option<Vec<_>>>() else {
                return self.draw_nothing(scene, Depth::NO_POINTS, writer.graphics);
            };
            write_all(&mut self.sides, numbers, writer.graphics);
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
        self.numbers.write_buffer(device, queue);
        self.starlight.set(GpuStarlight::new(scene, depth));
        self.starlight.write_buffer(device, queue);
        self.written = Some(wanted);
        self.changed.store(true, Ordering::Relaxed);
        let size = scene.picture.size();
        let fits = |drawn: &Drawn| {
            drawn.size == size
                && (drawn.mesh, drawn.rounds) == (mesh, rounds)
                && Arc::ptr_eq(&drawn.list, &list)
        };
        if self.drawn.as_ref().is_some_and(fits) {
            return false;
        }
        self.drawn = Some(self.create(list, size, (mesh, rounds), numbers, &writer));
        true
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

    /// The buffers and bindings for a list and a size.
    fn create(
        &self,
        list: Arc<GpuStarList>,
        size: UVec2,
        (mesh, rounds): (Option<MeshLayout>, usize),
        numbers: &UniformBuffer<GpuScene>,
        writer: &StarWriter,
    ) -> Drawn {
        let Graphics { device, cache, .. } = writer.graphics;
        let mut sizes = vec![
            (STAR_IMAGES, images_size(&list.stars)),
            (STAR_COUNT, COUNT_SIZE),
            (STAR_SUMS, sums_size(size)),
        ];
        if let Some(layout) = &mesh {
            sizes.extend([
                (MESH_POINTS, mesh_points_size(layout)),
                (CANDIDATES, candidates_size(&list.stars)),
                (CANDIDATE_COUNT, CANDIDATE_COUNT_SIZE),
            ]);
        }
        let buffers = sizes.into_iter().map(|(binding, size)| {
            let usage = BufferUsages::STORAGE | BufferUsages::INDIRECT | BufferUsages::COPY_DST;
            (binding, create_buffer(device, "stars", size, usage))
        });
        let mut drawn = Drawn {
            list,
            size,
            mesh,
            buffers: buffers.collect(),
            bind_groups: [const { Vec::new() }; StarKernel::ALL.len()],
            rounds,
            no_candidates: create_buffer(
                device,
                "no candidates",
                CANDIDATE_COUNT_SIZE,
                BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
            ),
        };
        let rounds_of = |kernel: StarKernel| if kernel.is_of_mesh() { rounds } else { 1 };
        let all = StarKernel::ALL
            .into_iter()
            .flat_map(|kernel| (0..rounds_of(kernel)).map(move |round| (kernel, round)));
        for (kernel, round) in all {
            let side = self.sides.get(round).filter(|_| kernel.is_of_mesh());
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
                        STAR_MESH => drawn.mesh.and(self.meshes.get(round)?.binding())?,
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
        drawn
    }

    /// The numbers of the sky, once a scene has been written.
    pub(crate) fn starlight(&self) -> Option<BindingResource<'_>> {
        self.starlight.binding()
    }

    /// The light of the points in each pixel, once a scene has been written.
    pub(crate) fn sums(&self) -> Option<&Buffer> {
        self.drawn.as_ref()?.buffer(STAR_SUMS)
    }

    /// Whether the sums belong to an earlier scene. They count as those of this one from now on.
    pub(super) fn take_changed(&self) -> bool {
        self.changed.swap(false, Ordering::Relaxed)
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

/// Writes values to uniforms, which stay the same buffers as long as their number does.
fn write_all<T: ShaderType + WriteInto + Default>(
    uniforms: &mut Vec<UniformBuffer<T>>,
    values: Vec<T>,
    graphics: &Graphics,
) {
    uniforms.resize_with(values.len(), || UniformBuffer::from(T::default()));
    for (uniform, value) in uniforms.iter_mut().zip(values) {
        uniform.set(value);
        uniform.write_buffer(&graphics.device, &graphics.queue);
    }
}

impl Drawn {
    /// A buffer that the kernels write.
    fn buffer(&self, binding: u32) -> Option<&Buffer> {
        let found = self.buffers.iter().find(|(at, _)| *at == binding);
        found.map(|(_, buffer)| buffer)
    }
}

impl ReadyStars<'_> {
    /// How many times [`dispatch`](Self::dispatch) has to run: once for each picture that has a mesh.
    pub(super) fn rounds(&self) -> usize {
        self.drawn.rounds
    }

    /// Empties the lists of candidates for another round.
    pub(super) fn clear_candidates(&self, encoder: &mut CommandEncoder) {
        if let Some(count) = self.drawn.buffer(CANDIDATE_COUNT) {
            let none = &self.drawn.no_candidates;
            encoder.copy_buffer_to_buffer(none, 0, count, 0, CANDIDATE_COUNT_SIZE);
        }
    }

    /// Empties the lists and the sums.
    pub(super) fn clear(&self, encoder: &mut CommandEncoder, queue: &RenderQueue) {
        let no_candidates = empty_candidate_count(self.max_traced);
        queue.write_buffer(&self.drawn.no_candidates, 0, &no_candidates);
        let none: Vec<u8> = EMPTY_COUNT.iter().flat_map(|n| n.to_le_bytes()).collect();
        for (binding, buffer) in &self.drawn.buffers {
            match *binding {
                STAR_COUNT => queue.write_buffer(buffer, 0, &none),
                CANDIDATE_COUNT => {
                    queue.write_buffer(buffer, 0, &no_candidates);
                }
                STAR_SUMS => encoder.clear_buffer(buffer, 0, None),
                _ => {}
            }
        }
    }

    /// Finds the images of a round and, in the last one, dims those behind the disk and draws them.
    pub(super) fn dispatch(&self, round: usize, pass: &mut ComputePass) {
        let is_last = round + 1 == self.drawn.rounds;
        for (kernel, pipeline) in &self.kernels {
            if !kernel.is_of_mesh() && !is_last {
                continue;
            }
            let groups = &self.drawn.bind_groups[*kernel as usize];
            let Some(bind_group) = groups.get(if kernel.is_of_mesh() { round } else { 0 }) else {
                continue;
            };
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, bind_group, &[]);
            let indirect = kernel
                .indirect()
                .and_then(|(at, start)| Some((self.drawn.buffer(at)?, start)));
            match (indirect, kernel, &self.drawn.mesh) {
                (Some((count, start)), ..) => pass.dispatch_workgroups_indirect(count, start),
                (None, kernel, Some(layout)) => {
                    pass.dispatch_workgroups(kernel.mesh_workgroups(layout), 1, 1);
                }
                (None, _, None) => {
                    let [x, y] = solve_workgroups(self.drawn.list.stars.len());
                    pass.dispatch_workgroups(x, y, 1);
                }
            }
        }
    }
}
