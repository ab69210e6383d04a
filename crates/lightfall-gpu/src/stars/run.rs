//! The kernels of stars without a picture, for tests and measurements.

use super::kernel::StarKernel;
use super::list::PackedStars;
use super::numbers::{GpuStarImage, GpuStars, table_rows};
use super::{
    CANDIDATE_COUNT_SIZE, COUNT_SIZE, EMPTY_COUNT, GpuStarMesh, MAX_TRACED, candidates_size,
    empty_candidate_count, images_size, index_bytes, mesh_layout, mesh_points_size,
    solve_workgroups, sums_size,
};
use crate::bindings;
use crate::buffer::{bind_group, buffer_from_bytes, compute_pipeline, empty_buffer};
use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernel::{table_bytes, uniform};
use crate::read_back::read_back;
use crate::scene::GpuScene;
use crate::shader::{ShaderFiles, Variant};
use encase::{ShaderSize, StorageBuffer};
use glam::DMat3;
use lightfall_model::scene::{Frame, Scene};
use lightfall_optics::spectrum;
use lightfall_optics::stars::Depth;
use lightfall_optics::stars::images::{Inversion, MeshLayout};
use wgpu::{Buffer, BufferUsages, CommandEncoder, ComputePipeline, PollType};

const UNIFORM: BufferUsages = BufferUsages::UNIFORM;
const STORAGE: BufferUsages = BufferUsages::STORAGE;

/// The images of a list of stars in a scene, and the light that they add to its picture.
#[derive(Clone, Debug, PartialEq)]
pub struct StarLight {
    /// The images, in any order.
    pub images: Vec<GpuStarImage>,
    /// Red, green and blue of each pixel, row by row, in units.
    pub sums: Vec<u32>,
    /// Units per linear light.
    pub unit: f64,
}

/// The buffers and pipelines of one scene.
#[derive(Debug)]
pub struct StarRun {
    /// In the order in which they run.
    kernels: Vec<(StarKernel, ComputePipeline)>,
    buffers: Vec<(u32, Buffer)>,
    numbers: GpuStars,
    stars: u32,
    /// Unless images are found by inversion.
    mesh: Option<MeshLayout>,
}

impl StarRun {
    /// Compiles the kernels for `scene`, and writes its numbers and the list. The rest is as in
    /// [`GpuStars::new`].
    ///
    /// # Errors
    /// The camera's observer does not exist, or the device failed.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        list: &PackedStars,
        hole_from_list: DMat3,
        depth: Depth,
    ) -> Result<Self, GpuError> {
        if Variant::uses_star_mesh(scene) {
            let layout = mesh_layout(scene, MeshLayout::CELLS);
            return Self::with_mesh(gpu, scene, list, hole_from_list, depth, layout);
        }
        let inversion = Inversion::new(scene)?;
        let numbers = GpuStars::new(scene, &inversion, list, hole_from_list, depth);
        let mut run = Self::create(gpu, scene, list, numbers, StarKernel::of(scene))?;
        if let Some(rows) = table_rows(&inversion) {
            let bytes = table_bytes(&rows);
            gpu.validated(|| run.add_bytes(gpu, bindings::STAR_TABLE, &bytes, UNIFORM))?;
        }
        Ok(run)
    }

    /// As [`new`](Self::new), with images that are found by this mesh, whatever the tracer.
    ///
    /// # Errors
    /// As those of `new`.
    pub fn with_mesh(
        gpu: &Gpu,
        scene: &Scene,
        list: &PackedStars,
        hole_from_list: DMat3,
        depth: Depth,
        layout: MeshLayout,
    ) -> Result<Self, GpuError> {
        let numbers = GpuStars::for_mesh(scene, list, depth);
        let mesh = GpuStarMesh::new(scene, &layout, list, hole_from_list);
        let kernels = StarKernel::finding_images(scene, true);
        let mut run = Self::create(gpu, scene, list, numbers, kernels)?;
        run.mesh = Some(layout);
        gpu.validated(|| {
            run.add_bytes(gpu, bindings::STAR_MESH, &uniform(&mesh), UNIFORM);
            run.add_bytes(gpu, bindings::STAR_INDEX, &index_bytes(list), STORAGE);
            run.add_empty(gpu, bindings::MESH_POINTS, mesh_points_size(&layout));
            run.add_empty(gpu, bindings::CANDIDATES, candidates_size(list));
            run.add_empty(gpu, bindings::CANDIDATE_COUNT, CANDIDATE_COUNT_SIZE);
        })?;
        Ok(run)
    }

    /// The kernels and buffers that do not depend on how images are found.
    fn create(
        gpu: &Gpu,
        scene: &Scene,
        list: &PackedStars,
        numbers: GpuStars,
        kernels: impl Iterator<Item = StarKernel>,
    ) -> Result<Self, GpuError> {
        let size = scene.picture.size();
        let scene_numbers = GpuScene::new(scene, &Frame::of(scene))?;
        let modules = kernels.map(|kernel| {
            let module = gpu.shader(kernel.entry_point(), &kernel.source(scene))?;
            Ok((kernel, module))
        });
        let modules = modules.collect::<Result<Vec<_>, GpuError>>()?;
        gpu.validated(|| {
            let pipelines = modules.iter().map(|(kernel, module)| {
                (*kernel, compute_pipeline(gpu, module, kernel.entry_point()))
            });
            let mut run = Self {
                kernels: pipelines.collect(),
                buffers: Vec::new(),
                numbers,
                stars: list.len(),
                mesh: None,
            };
            let stars = uniform(&run.numbers);
            let spectrum = table_bytes(&spectrum::table());
            run.add_bytes(gpu, bindings::SCENE, &uniform(&scene_numbers), UNIFORM);
            run.add_bytes(gpu, bindings::SPECTRUM, &spectrum, UNIFORM);
            run.add_bytes(gpu, bindings::STARS, &stars, UNIFORM);
            run.add_bytes(gpu, bindings::STAR_LIST, list.bytes(), STORAGE);
            run.add_empty(gpu, bindings::STAR_IMAGES, images_size(list));
            run.add_empty(gpu, bindings::STAR_COUNT, COUNT_SIZE);
            run.add_empty(gpu, bindings::STAR_SUMS, sums_size(size));
            run
        })
    }

    /// The same kernels, linked from other files.
    ///
    /// # Errors
    /// They do not compile, or the device failed.
    pub fn linked_from(
        mut self,
        gpu: &Gpu,
        scene: &Scene,
        files: &ShaderFiles,
    ) -> Result<Self, GpuError> {
        for (kernel, compiled) in &mut self.kernels {
            let entry = kernel.entry_point();
            let text = kernel.text(scene).linked_from(files);
            let module = gpu.shader(entry, &text.source())?;
            *compiled = gpu.validated(|| compute_pipeline(gpu, &module, entry))?;
        }
        Ok(self)
    }

    fn add_bytes(&mut self, gpu: &Gpu, binding: u32, bytes: &[u8], usage: BufferUsages) {
        let buffer = buffer_from_bytes(gpu, "stars", bytes, usage);
        self.buffers.push((binding, buffer));
    }

    fn add_empty(&mut self, gpu: &Gpu, binding: u32, size: u64) {
        let usage =
            STORAGE | BufferUsages::INDIRECT | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        let buffer = empty_buffer(gpu, "stars", size, usage);
        self.buffers.push((binding, buffer));
    }

    /// Finds the images and draws them, and waits until that is done.
    ///
    /// # Errors
    /// The device failed.
    pub fn draw(&self, gpu: &Gpu) -> Result<(), GpuError> {
        gpu.validated(|| {
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            self.encode(gpu, &mut encoder);
            gpu.queue.submit([encoder.finish()]);
        })?;
        let waited = gpu.device.poll(PollType::wait_indefinitely());
        waited.map(drop).map_err(GpuError::device_failed)
    }

    /// Finds the images and draws them, and reads both.
    ///
    /// # Errors
    /// The device failed.
    pub fn run(&self, gpu: &Gpu) -> Result<StarLight, GpuError> {
        let readable = gpu.validated(|| {
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            self.encode(gpu, &mut encoder);
            let arrays = [
                bindings::STAR_COUNT,
                bindings::STAR_IMAGES,
                bindings::STAR_SUMS,
            ];
            let readable = arrays.map(|binding| {
                let buffer = self.buffer(binding);
                let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
                let readable = empty_buffer(gpu, "readable", buffer.size(), usage);
                encoder.copy_buffer_to_buffer(buffer, 0, &readable, 0, buffer.size());
                readable
            });
            gpu.queue.submit([encoder.finish()]);
            readable
        })?;
        let [count, images, sums] = readable;
        let count = words(&read_back(&gpu.device, &count)?)[3];
        let count = count.min(self.numbers.capacity) as usize;
        let mut records = vec![GpuStarImage::default(); count];
        let mut bytes = read_back(&gpu.device, &images)?;
        bytes.truncate(count * GpuStarImage::SHADER_SIZE.get() as usize);
        // An empty array cannot be read.
        if count > 0 {
            StorageBuffer::new(bytes)
                .read(&mut records)
                .map_err(GpuError::device_failed)?;
        }
        Ok(StarLight {
            images: records,
            sums: words(&read_back(&gpu.device, &sums)?),
            unit: self.numbers.unit.into(),
        })
    }

    fn encode(&self, gpu: &Gpu, encoder: &mut CommandEncoder) {
        let empty = EMPTY_COUNT.map(u32::to_le_bytes).concat();
        for (binding, buffer) in &self.buffers {
            match *binding {
                bindings::STAR_COUNT => gpu.queue.write_buffer(buffer, 0, &empty),
                bindings::CANDIDATE_COUNT => {
                    gpu.queue
                        .write_buffer(buffer, 0, &empty_candidate_count(MAX_TRACED));
                }
                bindings::STAR_SUMS => encoder.clear_buffer(buffer, 0, None),
                _ => {}
            }
        }
        let mut pass = encoder.begin_compute_pass(&Default::default());
        for (kernel, pipeline) in &self.kernels {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &self.bind(gpu, *kernel, pipeline), &[]);
            match (kernel.indirect(), &self.mesh) {
                (Some((binding, start)), _) => {
                    pass.dispatch_workgroups_indirect(self.buffer(binding), start);
                }
                (None, Some(layout)) => {
                    pass.dispatch_workgroups(kernel.mesh_workgroups(layout), 1, 1);
                }
                (None, None) => {
                    let [x, y] = solve_workgroups(self.stars);
                    pass.dispatch_workgroups(x, y, 1);
                }
            }
        }
    }

    fn buffer(&self, binding: u32) -> &Buffer {
        let found = self.buffers.iter().find(|(at, _)| *at == binding);
        &found.expect("every binding of a kernel has a buffer").1
    }

    fn bind(&self, gpu: &Gpu, kernel: StarKernel, pipeline: &ComputePipeline) -> wgpu::BindGroup {
        let bindings = kernel.reads().iter().chain(kernel.writes());
        // Only with lensing there is a table.
        let has_buffer = |binding: &u32| self.buffers.iter().any(|(at, _)| at == binding);
        let buffers = bindings
            .filter(|binding| has_buffer(binding))
            .map(|binding| (*binding, self.buffer(*binding)));
        bind_group(gpu, &pipeline.get_bind_group_layout(0), buffers)
    }
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytes
        .as_chunks()
        .0
        .iter()
        .map(|word| u32::from_le_bytes(*word))
        .collect()
}
