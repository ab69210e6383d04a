//! The bindings of shaders. Every row of a list below is a constant whose value, the row's place in
//! the list, is the number of the binding. Texts that declare the binding begin with the same
//! constant, named with the prefix `BINDING_`.

use std::collections::HashSet;
use wgpu::{
    BindGroupLayoutEntry, BindingType, BufferBindingType, SamplerBindingType, ShaderStages,
    TextureSampleType, TextureViewDimension,
};

const UNIFORM: BindingType = buffer(BufferBindingType::Uniform);
const STORAGE: BindingType = buffer(BufferBindingType::Storage { read_only: true });
const CUBE_MAP: BindingType = BindingType::Texture {
    sample_type: TextureSampleType::Float { filterable: true },
    view_dimension: TextureViewDimension::Cube,
    multisampled: false,
};
const SAMPLER: BindingType = BindingType::Sampler(SamplerBindingType::Filtering);

/// Invocations of a compute shader's workgroup.
pub const WORKGROUP_SIZE: u32 = 64;
/// Maximum number of workgroups along one side of a dispatch: WebGPU's default limit.
pub const MAX_WORKGROUPS: u32 = 65_535;

/// The constants of a list, and the list of their names in shaders.
macro_rules! numbers {
    ($list:ident: $($(#[$doc:meta])* $name:ident),* $(,)?) => {
        numbers!(@from 0; $($(#[$doc])* $name)*);
        const $list: &[(&str, u32)] = &[$((concat!("BINDING_", stringify!($name)), $name)),*];
    };
    (@from $number:expr;) => {};
    (@from $number:expr; $(#[$doc:meta])* $name:ident $($rest:tt)*) => {
        $(#[$doc])*
        pub const $name: u32 = $number;
        numbers!(@from $number + 1; $($rest)*);
    };
}

/// A row of [`ALL`].
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// The name of the binding in shaders.
    pub name: &'static str,
    /// The number of the binding.
    pub number: u32,
    /// What is bound. A storage array may also be bound to a shader that writes it.
    pub kind: BindingType,
    /// Whether it is in the layout of the picture's shaders.
    pub in_picture: bool,
}

/// The constants of [`ALL`], and the list itself.
macro_rules! bindings {
    ($($(#[$doc:meta])* $name:ident: $kind:ident $(, $picture:ident)?;)*) => {
        numbers!(@from 0; $($(#[$doc])* $name)*);
        /// The bindings of the shaders that trace rays or draw the picture, all in group 0. Those
        /// marked `picture` are the layout of every picture's shader, whether it reads them or not.
        pub const ALL: &[Binding] = &[$(Binding {
            name: concat!("BINDING_", stringify!($name)),
            number: $name,
            kind: $kind,
            in_picture: !stringify!($($picture)?).is_empty(),
        }),*];
    };
}

// Uniforms with single numbers come before uniforms that are tables, because of a fault of Mesa's
// software renderer, version 22.3 (Debian 12). For each pipeline the renderer lists which numbers
// the shader's conditions read from each uniform. It counts uniforms from one, in the order of
// these bindings, and writes beyond the list from the fourth uniform of a layout on: for the fourth
// into the list's own counts, for the fifth to the seventh into parts of the pipeline that are not
// used, and for the eighth and later ones into the heap. Only reads at a fixed place enter the
// list. A table is read at computed places, so it can be the fourth or the eighth.
bindings! {
    /// The uniform `Scene`.
    SCENE: UNIFORM, picture;
    /// The uniform `Tilt` of a tilted disk.
    TILT: UNIFORM, picture;
    /// The hot spot of the disk, a uniform.
    HOT_SPOT: UNIFORM, picture;
    /// The uniform `Stars`: what the kernels of point stars share.
    STARS: UNIFORM;
    /// The uniform `StarMesh`: the mesh that finds images without an inversion.
    STAR_MESH: UNIFORM;
    /// The table of thermal colours, a uniform.
    SPECTRUM: UNIFORM, picture;
    /// The rings and waves of the disk's structure, a uniform.
    STRUCTURE: UNIFORM, picture;
    /// The uniform `Starlight` of the sky modes `stars` and `picture`.
    STARLIGHT: UNIFORM, picture;
    /// The table of the disk model `page-thorne`, a uniform.
    PAGE_THORNE: UNIFORM, picture;
    /// The table of the inversion that finds images of stars, a uniform.
    STAR_TABLE: UNIFORM;
    /// The grid of the view `error`, a uniform.
    ERROR_MAP: UNIFORM, picture;
    /// The storage array that a compute shader reads.
    INPUT: STORAGE;
    /// The storage array that a compute shader writes.
    OUTPUT: STORAGE;
    /// The Milky Way's light, a cube map.
    MILKY_WAY: CUBE_MAP, picture;
    /// The sampler of [`MILKY_WAY`].
    MILKY_WAY_SAMPLER: SAMPLER, picture;
    /// The list of stars, a storage array.
    STAR_LIST: STORAGE;
    /// The list of images, a storage array.
    STAR_IMAGES: STORAGE;
    /// The number of images and of workgroups that draw them, in storage.
    STAR_COUNT: STORAGE;
    /// The light of the images on each pixel, a storage array.
    STAR_SUMS: STORAGE, picture;
    /// The results of the rays of the mesh, a storage array.
    MESH_POINTS: STORAGE;
    /// The index of the stars over the sky, a storage array.
    STAR_INDEX: STORAGE;
    /// The stars that may have an image in a cell of the mesh, a storage array.
    CANDIDATES: STORAGE;
    /// The number of candidates and of workgroups that find their images, in storage.
    CANDIDATE_COUNT: STORAGE;
    /// The wave numbers along the normal of the structure of a disk with thickness, a uniform.
    WAVE_HEIGHTS: UNIFORM, picture;
    /// The numbers `ThickDisk`, in storage: as a uniform they would come after the seventh place.
    THICK_DISK: STORAGE, picture;
    /// The numbers `Jet`, with their table of colours and their waves, in storage: as a uniform they would
    /// come after the seventh place.
    JET: STORAGE, picture;
}

// Shaders with bindings of their own.

numbers! { PRESENTATION_NUMBERS:
    /// The uniform `Presentation`.
    PRESENTATION,
    /// The texture that a stage of the presentation reads.
    PRESENTATION_SOURCE,
}

numbers! { DIFFERENCE_NUMBERS:
    /// The uniform `Difference`.
    DIFFERENCE,
    /// The light of the pinned scene.
    DIFFERENCE_LEFT,
    /// The light of the current scene.
    DIFFERENCE_RIGHT,
}

numbers! { ACCUMULATION_NUMBERS:
    /// The uniform `Accumulation` of the shader that averages frames.
    ACCUMULATION,
    /// The light of the present frame.
    ACCUMULATION_LIGHT,
    /// The sum of the light of the frames before it.
    ACCUMULATION_SUM,
}

numbers! { PRINT_NUMBERS:
    /// The uniform `Print`.
    PRINT,
    /// The developed picture.
    PRINT_SOURCE,
}

numbers! { BLOOM_NUMBERS:
    /// The uniform `Bloom`.
    BLOOM,
    /// What a step of the bloom reads.
    BLOOM_SOURCE,
    /// The sampler of [`BLOOM_SOURCE`].
    BLOOM_SAMPLER,
}

numbers! { DEVELOPMENT_NUMBERS:
    /// The uniform `Development`.
    DEVELOPMENT,
    /// The picture's light.
    DEVELOPMENT_LIGHT,
    /// The largest level of the bloom.
    DEVELOPMENT_BLOOM,
    /// The sampler of [`DEVELOPMENT_BLOOM`].
    DEVELOPMENT_SAMPLER,
}

// The bindings of REFINE are in group 1: in group 0 it binds what the picture's shader does. EDGES
// has a group of its own.
numbers! { ANTIALIAS_NUMBERS:
    /// The work of REFINE, which EDGES writes.
    WORK,
    /// The list of pixels to refine.
    LIST,
    /// The picture's texture, which REFINE writes.
    PICTURE,
    /// The texture of classes and brightness, which EDGES reads.
    TRAITS,
    /// Where EDGES looks and how many rays it asks for, a uniform.
    SEARCH,
}

/// The constants of all bindings, and the size of a workgroup.
fn all_constants() -> impl Iterator<Item = (&'static str, u32)> {
    let own = [
        PRESENTATION_NUMBERS,
        DIFFERENCE_NUMBERS,
        ACCUMULATION_NUMBERS,
        BLOOM_NUMBERS,
        PRINT_NUMBERS,
        DEVELOPMENT_NUMBERS,
        ANTIALIAS_NUMBERS,
    ];
    ALL.iter()
        .map(|row| (row.name, row.number))
        .chain(own.into_iter().flatten().copied())
        .chain([("WORKGROUP_SIZE", WORKGROUP_SIZE)])
}

/// Whether a name is that of a binding in shaders, or of the size of a workgroup.
pub(super) fn is_constant(name: &str) -> bool {
    all_constants().any(|(constant, _)| constant == name)
}

/// The constants in front of a shader that is linked from these texts: the bindings that they
/// declare, and those of an entry that a test or a measurement appends.
pub(super) fn constants<'a>(
    texts: impl Iterator<Item = &'a str>,
) -> impl Iterator<Item = (&'static str, u32)> {
    let declarations = texts.flat_map(|text| text.split("@binding(").skip(1));
    let names = declarations.filter_map(|rest| Some(rest.split_once(')')?.0));
    let for_entries = ["BINDING_INPUT", "BINDING_OUTPUT", "WORKGROUP_SIZE"];
    let needed: HashSet<&str> = names.chain(for_entries).collect();
    all_constants().filter(move |(name, _)| needed.contains(name))
}

impl Binding {
    /// Whether a shader's text declares it.
    pub(super) fn is_declared_in(&self, text: &str) -> bool {
        text.contains(&format!("@binding({})", self.name))
    }

    /// Its entry in a layout.
    pub fn layout_entry(&self, visibility: ShaderStages) -> BindGroupLayoutEntry {
        BindGroupLayoutEntry {
            binding: self.number,
            visibility,
            ty: self.kind,
            count: None,
        }
    }
}

/// The layout of the picture's shaders. They share one, so that each uniform has the same place in
/// all of them.
pub fn picture_layout() -> Vec<BindGroupLayoutEntry> {
    let stages = ShaderStages::FRAGMENT | ShaderStages::COMPUTE;
    let rows = ALL.iter().filter(|row| row.in_picture);
    rows.map(|row| row.layout_entry(stages)).collect()
}

const fn buffer(ty: BufferBindingType) -> BindingType {
    BindingType::Buffer {
        ty,
        has_dynamic_offset: false,
        min_binding_size: None,
    }
}
