//! The resources of the search for edges and of their refinement (refine.rs) on the GPU: the pipelines, the
//! second target of the geodesic pass, and the lists of marked pixels.

use crate::chain::Chain;
use crate::comparison::ComparedScene;
use crate::drawn_scene::{DrawnPart, DrawnScene};
use crate::graphics::{ComputePipelines, create_buffer, create_target, picture_size};
use crate::live_shaders::add_shader;
use bevy::asset::uuid_handle;
use bevy::prelude::*;
use bevy::render::render_resource::binding_types::*;
use bevy::render::render_resource::*;
use bevy::render::renderer::RenderDevice;
use bevy::render::view::ViewTarget;
use bevy::render::{GpuResourceAppExt, RenderApp};
use lightfall_core::gpu::bindings::{LIST, PICTURE, SEARCH, TRAITS, WORK};
use lightfall_core::gpu::{EdgeTraits, Edges};

/// The format of what the search for edges compares: two small whole numbers.
pub(super) const TRAITS_FORMAT: TextureFormat = TextureFormat::Rg8Uint;

/// The shaders of the search, for one sample a pixel and for four.
const SHADERS: [(u32, Handle<Shader>); 2] = [
    (1, uuid_handle!("5d0e1c7c-54f5-4d43-9a51-0a2c0b5f4c11")),
    (4, uuid_handle!("c1b6a2f7-1c3e-4c58-8f0e-7d8f5d1a9b64")),
];

/// Size of the uniform `Search` of shaders/antialias/edges.wgsl, in bytes.
const SEARCH_SIZE: u64 = 16;

/// The passes' resources on the GPU. `None` while no edges are looked for.
#[derive(Resource, Default)]
pub(super) struct AntialiasPass(pub(super) Option<Targets>);

/// What exists while edges are looked for in pictures of one size.
pub(super) struct Targets {
    pub(super) size: UVec2,
    pub(super) samples: u32,
    pub(super) traits: TextureView,
    /// One for each scene of the picture.
    pub(super) marks: Vec<Marks>,
    /// The pipeline of the search.
    edges: CachedComputePipelineId,
}

/// The pixels of a scene that EDGES has marked.
pub(super) struct Marks {
    pub(super) search: Buffer,
    pub(super) work: Buffer,
    pub(super) list: Buffer,
}

impl AntialiasPass {
    /// Whether the pipeline of the search exists.
    pub(super) fn finds_edges(&self, cache: &PipelineCache) -> bool {
        let targets = self.0.as_ref();
        targets.is_some_and(|targets| targets.edges_pipeline(cache).is_some())
    }

    /// The second target of a geodesic pass that draws to `target`, if it has the same size and
    /// samples.
    pub(super) fn attachment(&self, target: &ViewTarget) -> Option<RenderPassColorAttachment<'_>> {
        let targets = self.0.as_ref().filter(|targets| targets.fits(target))?;
        Some(RenderPassColorAttachment {
            view: &targets.traits,
            depth_slice: None,
            resolve_target: None,
            ops: Operations {
                // No class: what the foreground covers stays so.
                load: LoadOp::Clear(default()),
                store: StoreOp::Store,
            },
        })
    }
}

impl Targets {
    fn new(
        device: &RenderDevice,
        edges: CachedComputePipelineId,
        (size, samples, scenes): (UVec2, u32, usize),
    ) -> Self {
        let marks = || Marks {
            search: create_buffer(
                device,
                "search for edges",
                SEARCH_SIZE,
                BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            ),
            work: create_buffer(
                device,
                "work of the refinement",
                Edges::WORK_SIZE,
                BufferUsages::STORAGE | BufferUsages::INDIRECT | BufferUsages::COPY_DST,
            ),
            list: create_buffer(
                device,
                "marked pixels",
                Edges { size }.list_size(),
                BufferUsages::STORAGE,
            ),
        };
        Self {
            size,
            samples,
            traits: create_target(device, "classes", size, TRAITS_FORMAT, samples),
            marks: std::iter::repeat_with(marks).take(scenes).collect(),
            edges,
        }
    }

    /// The pipeline of the search, once it exists.
    pub(super) fn edges_pipeline<'a>(
        &self,
        cache: &'a PipelineCache,
    ) -> Option<&'a ComputePipeline> {
        cache.get_compute_pipeline(self.edges)
    }

    /// Whether these are the targets of a picture that is drawn to `target`.
    pub(super) fn fits(&self, target: &ViewTarget) -> bool {
        let several = target.sampled_main_texture().is_some();
        self.size == picture_size(target) && (self.samples > 1) == several
    }
}

pub(super) fn plugin(app: &mut App) {
    for (samples, handle) in SHADERS {
        let text = EdgeTraits { samples }.shader();
        add_shader(app, &handle, text, "lightfall/edges.wgsl");
    }
    app.sub_app_mut(RenderApp)
        .init_gpu_resource::<AntialiasPass>();
}

/// What REFINE binds in addition to what the picture's shader binds.
pub(super) fn refinement_layout() -> BindGroupLayoutDescriptor {
    BindGroupLayoutDescriptor::new(
        "refinement layout",
        &BindGroupLayoutEntries::with_indices(
            ShaderStages::COMPUTE,
            (
                (WORK, storage_buffer_read_only_sized(false, None)),
                (LIST, storage_buffer_read_only_sized(false, None)),
                (
                    PICTURE,
                    texture_storage_2d(TextureFormat::Rgba16Float, StorageTextureAccess::WriteOnly),
                ),
            ),
        ),
    )
}

/// What EDGES binds.
pub(super) fn edges_layout(samples: u32) -> BindGroupLayoutDescriptor {
    let traits = if samples > 1 {
        texture_2d_multisampled(TextureSampleType::Uint)
    } else {
        texture_2d(TextureSampleType::Uint)
    };
    BindGroupLayoutDescriptor::new(
        "edges layout",
        &BindGroupLayoutEntries::with_indices(
            ShaderStages::COMPUTE,
            (
                (TRAITS, traits),
                (
                    SEARCH,
                    uniform_buffer_sized(false, BufferSize::new(SEARCH_SIZE)),
                ),
                (WORK, storage_buffer_sized(false, None)),
                (LIST, storage_buffer_sized(false, None)),
            ),
        ),
    )
}

/// Creates what the search for edges needs, and drops it where edges are not refined.
pub(super) fn prepare_antialias(
    (scene, part): (Res<DrawnScene>, Res<DrawnPart>),
    compared: Res<ComparedScene>,
    If(mut pass): If<ResMut<AntialiasPass>>,
    If(mut pipelines): If<ResMut<ComputePipelines>>,
    cache: Res<PipelineCache>,
    device: Res<RenderDevice>,
) {
    let chain = Chain::of(&scene).of_part(part.drawn()).comparing(&compared);
    if !chain.antialias {
        pass.0 = None;
        return;
    }
    let scenes = 1 + usize::from(compared.drawn().is_some());
    let wanted = (chain.picture, chain.samples, scenes);
    let fits = |targets: &Targets| (targets.size, targets.samples, targets.marks.len()) == wanted;
    if !pass.0.as_ref().is_some_and(fits) {
        let shader = &SHADERS[usize::from(chain.samples > 1)].1;
        let layout = edges_layout(chain.samples);
        let edges = pipelines.queue(&cache, "edges", &[&layout], shader);
        pass.0 = Some(Targets::new(&device, edges, wanted));
    }
}
