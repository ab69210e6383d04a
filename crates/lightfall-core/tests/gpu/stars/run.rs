//! The kernels of stars without a picture.

use encase::{ShaderSize, StorageBuffer};
use glam::DMat3;
use lightfall_core::gpu::kernel::{table_bytes, uniform};
use lightfall_core::gpu::stars::{
    CANDIDATE_COUNT_SIZE, COUNT_SIZE, EMPTY_COUNT, GpuStarImage, GpuStarMesh, GpuStars, MAX_TRACED,
    PackedStars, StarKernel, StarSide, candidates_size, empty_candidate_count, images_size,
    index_bytes, mesh_layout, mesh_points_size, solve_workgroups, sums_size, table_rows,
};
use lightfall_core::gpu::{Gpu, GpuScene, Variant, bindings, read_back};
use lightfall_core::optics::spectrum;
use lightfall_core::optics::stars::Depth;
use lightfall_core::optics::stars::images::{Inversion, MeshLayout};
use lightfall_core::scene::{Frame, Scene};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    BindGroup, BindGroupEntry, Buffer, BufferDescriptor, BufferUsages, CommandEncoder,
    ComputePipeline, ComputePipelineDescriptor,
};

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
pub struct StarRun<'a> {
    gpu: &'a Gpu,
    /// In the order in which they run.
    kernels: Vec<(StarKernel, ComputePipeline)>,
    buffers: Vec<(u32, Buffer)>,
    numbers: GpuStars,
    stars: u32,
    /// Unless images are found by inversion.
    mesh: Option<MeshLayout>,
    /// The numbers of the scene and of the mesh on each side, unless a mesh covers the picture itself.
    sides: Vec<[Buffer; 2]>,
}

impl<'a> StarRun<'a> {
    /// Compiles the kernels for `scene`, and writes its numbers and the list. The rest is as in
    /// [`GpuStars::new`].
    pub fn new(
        gpu: &'a Gpu,
        scene: &'a Scene,
        list: &PackedStars,
        hole_from_list: DMat3,
        depth: Depth,
    ) -> Self {
        if Variant::uses_star_mesh(scene) {
            let sides = StarSide::all_of(scene);
            let searched = sides.first().map_or(scene, |side| &side.scene);
            let layout = mesh_layout(searched, MeshLayout::CELLS);
            let mut run = Self::with_mesh(gpu, scene, list, hole_from_list, depth, layout);
            for side in &sides {
                let numbers = GpuScene::new(&side.scene, &Frame::of(&side.scene)).unwrap();
                let mesh = GpuStarMesh::new(&side.scene, &layout, list, hole_from_list);
                let mesh = uniform(&mesh.on_side(side));
                let buffers =
                    [uniform(&numbers), mesh].map(|contents| run.buffer_of(&contents, UNIFORM));
                run.sides.push(buffers);
            }
            return run;
        }
        let inversion = Inversion::new(scene).unwrap();
        let numbers = GpuStars::new(scene, &inversion, list, hole_from_list, depth);
        let mut run = Self::create(gpu, scene, list, numbers, StarKernel::of(scene));
        if let Some(rows) = table_rows(&inversion) {
            run.add_bytes(bindings::STAR_TABLE, &table_bytes(&rows), UNIFORM);
        }
        run
    }

    /// As [`new`](Self::new), with images that are found by this mesh, whatever the tracer.
    pub fn with_mesh(
        gpu: &'a Gpu,
        scene: &'a Scene,
        list: &PackedStars,
        hole_from_list: DMat3,
        depth: Depth,
        layout: MeshLayout,
    ) -> Self {
        let numbers = GpuStars::for_mesh(scene, list, depth);
        let mesh = GpuStarMesh::new(scene, &layout, list, hole_from_list);
        let kernels = StarKernel::finding_images(scene, true);
        let mut run = Self::create(gpu, scene, list, numbers, kernels);
        run.mesh = Some(layout);
        run.add_bytes(bindings::STAR_MESH, &uniform(&mesh), UNIFORM);
        run.add_bytes(bindings::STAR_INDEX, &index_bytes(list), STORAGE);
        run.add_empty(bindings::MESH_POINTS, mesh_points_size(&layout));
        run.add_empty(bindings::CANDIDATES, candidates_size(list));
        run.add_empty(bindings::CANDIDATE_COUNT, CANDIDATE_COUNT_SIZE);
        run
    }

    /// The kernels and buffers that do not depend on how images are found.
    fn create(
        gpu: &'a Gpu,
        scene: &'a Scene,
        list: &PackedStars,
        numbers: GpuStars,
        kernels: impl Iterator<Item = StarKernel>,
    ) -> Self {
        let scene_numbers = GpuScene::new(scene, &Frame::of(scene)).unwrap();
        let kernels = kernels.map(|kernel| (kernel, pipeline(gpu, kernel, &kernel.source(scene))));
        let mut run = Self {
            gpu,
            kernels: kernels.collect(),
            buffers: Vec::new(),
            stars: list.len(),
            mesh: None,
            sides: Vec::new(),
            numbers,
        };
        let stars = uniform(&run.numbers);
        run.add_bytes(bindings::SCENE, &uniform(&scene_numbers), UNIFORM);
        run.add_bytes(
            bindings::SPECTRUM,
            &table_bytes(&spectrum::table()),
            UNIFORM,
        );
        run.add_bytes(bindings::STARS, &stars, UNIFORM);
        run.add_bytes(bindings::STAR_LIST, list.bytes(), STORAGE);
        run.add_empty(bindings::STAR_IMAGES, images_size(list));
        run.add_empty(bindings::STAR_COUNT, COUNT_SIZE);
        run.add_empty(bindings::STAR_SUMS, sums_size(scene.picture.size()));
        run
    }

    fn add_bytes(&mut self, binding: u32, contents: &[u8], usage: BufferUsages) {
        let buffer = self.buffer_of(contents, usage);
        self.buffers.push((binding, buffer));
    }

    fn buffer_of(&self, contents: &[u8], usage: BufferUsages) -> Buffer {
        let descriptor = BufferInitDescriptor {
            label: None,
            contents,
            usage,
        };
        self.gpu.device.create_buffer_init(&descriptor)
    }

    fn add_empty(&mut self, binding: u32, size: u64) {
        let usage =
            STORAGE | BufferUsages::INDIRECT | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        let buffer = empty_buffer(self.gpu, size, usage);
        self.buffers.push((binding, buffer));
    }

    /// Finds the images and draws them, and reads both.
    pub fn run(&self) -> StarLight {
        let device = &self.gpu.device;
        let mut encoder = device.create_command_encoder(&Default::default());
        self.encode(&mut encoder);
        let arrays = [
            bindings::STAR_COUNT,
            bindings::STAR_IMAGES,
            bindings::STAR_SUMS,
        ];
        let readable = arrays.map(|binding| {
            let buffer = self.buffer(binding);
            let usage = BufferUsages::COPY_DST | BufferUsages::MAP_READ;
            let readable = empty_buffer(self.gpu, buffer.size(), usage);
            encoder.copy_buffer_to_buffer(buffer, 0, &readable, 0, buffer.size());
            readable
        });
        self.gpu.queue.submit([encoder.finish()]);
        let [count, mut images, sums] =
            readable.map(|readable| read_back(device, &readable).unwrap());
        let count = words(&count)[3].min(self.numbers.capacity) as usize;
        let mut records = vec![GpuStarImage::default(); count];
        images.truncate(count * GpuStarImage::SHADER_SIZE.get() as usize);
        // An empty array cannot be read.
        if count > 0 {
            StorageBuffer::new(images).read(&mut records).unwrap();
        }
        StarLight {
            images: records,
            sums: words(&sums),
            unit: self.numbers.unit.into(),
        }
    }

    fn encode(&self, encoder: &mut CommandEncoder) {
        let queue = &self.gpu.queue;
        for (binding, buffer) in &self.buffers {
            match *binding {
                bindings::STAR_COUNT => {
                    queue.write_buffer(buffer, 0, &EMPTY_COUNT.map(u32::to_le_bytes).concat());
                }
                bindings::CANDIDATE_COUNT => {
                    queue.write_buffer(buffer, 0, &empty_candidate_count(MAX_TRACED));
                }
                bindings::STAR_SUMS => encoder.clear_buffer(buffer, 0, None),
                _ => {}
            }
        }
        let rounds = self.sides.len().max(1);
        for round in 0..rounds {
            if round > 0 {
                let counts = self.buffer(bindings::CANDIDATE_COUNT);
                let empty =
                    self.buffer_of(&empty_candidate_count(MAX_TRACED), BufferUsages::COPY_SRC);
                encoder.copy_buffer_to_buffer(&empty, 0, counts, 0, counts.size());
            }
            self.encode_round(encoder, round, round + 1 == rounds);
        }
    }

    fn encode_round(&self, encoder: &mut CommandEncoder, round: usize, is_last: bool) {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        let runs = |kernel: StarKernel| kernel.is_of_mesh() || is_last;
        for (kernel, pipeline) in self.kernels.iter().filter(|(kernel, _)| runs(*kernel)) {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &self.bind(*kernel, pipeline, round), &[]);
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

    fn bind(&self, kernel: StarKernel, pipeline: &ComputePipeline, round: usize) -> BindGroup {
        let side = self.sides.get(round).filter(|_| kernel.is_of_mesh());
        let bindings: Vec<&u32> = kernel.reads().iter().chain(kernel.writes()).collect();
        // Only with lensing there is a table.
        let buffers = self.buffers.iter().filter(|(at, _)| bindings.contains(&at));
        let entries = buffers.map(|(binding, buffer)| BindGroupEntry {
            binding: *binding,
            resource: match (*binding, side) {
                (bindings::SCENE, Some([numbers, _])) => numbers.as_entire_binding(),
                (bindings::STAR_MESH, Some([_, mesh])) => mesh.as_entire_binding(),
                _ => buffer.as_entire_binding(),
            },
        });
        self.gpu
            .device
            .create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(0),
                entries: &entries.collect::<Vec<_>>(),
            })
    }
}

fn pipeline(gpu: &Gpu, kernel: StarKernel, source: &str) -> ComputePipeline {
    let entry = kernel.word();
    let module = gpu.shader(entry, source).unwrap();
    let descriptor = ComputePipelineDescriptor {
        label: Some(entry),
        layout: None,
        module: &module,
        entry_point: Some(entry),
        compilation_options: Default::default(),
        cache: None,
    };
    gpu.device.create_compute_pipeline(&descriptor)
}

fn empty_buffer(gpu: &Gpu, size: u64, usage: BufferUsages) -> Buffer {
    gpu.device.create_buffer(&BufferDescriptor {
        label: None,
        size,
        usage,
        mapped_at_creation: false,
    })
}

fn words(bytes: &[u8]) -> Vec<u32> {
    let words = bytes.as_chunks().0.iter();
    words.map(|word| u32::from_le_bytes(*word)).collect()
}
