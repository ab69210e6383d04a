//! Numbers of the shaders' bindings, all of them in group 0, and the size of a workgroup. Every
//! shader gets them as constants in front of its text, under the names in the tables below.

// Uniforms with single numbers come before uniforms that are tables, because of a fault of Mesa's
// software renderer, version 22.3 (Debian 12). For each pipeline the renderer lists which numbers
// the shader's conditions read from each uniform. It counts uniforms from one, in the order of
// these bindings, and writes beyond the list from the fourth uniform of a layout on: for the fourth
// into the list's own counts, for the fifth to the seventh into parts of the pipeline that are not
// used, and for the eighth and later ones into the heap. Only reads at a fixed place enter the
// list. A table is read at computed places, so it can be the fourth or the eighth.

/// The uniform `Scene`.
pub const SCENE: u32 = 0;
/// The uniform `Tilt` of a tilted disk.
pub const TILT: u32 = 1;
/// The hot spot of the disk, a uniform.
pub const HOT_SPOT: u32 = 2;
/// The uniform `Stars`: what the kernels of point stars share.
pub const STARS: u32 = 3;
/// The uniform `StarMesh`: the mesh by which images are found without an inversion.
pub const STAR_MESH: u32 = 4;
/// The table of thermal colours, a uniform.
pub const SPECTRUM: u32 = 5;
/// The rings and waves of the disk's structure, a uniform.
pub const STRUCTURE: u32 = 6;
/// The uniform `Starlight` of the sky mode `stars`.
pub const STARLIGHT: u32 = 7;
/// The table of the disk model `page-thorne`, a uniform.
pub const PAGE_THORNE: u32 = 8;
/// The table by which the images of stars are found, a uniform.
pub const STAR_TABLE: u32 = 9;
/// The grid of the view `error`, a uniform.
pub const ERROR_MAP: u32 = 10;

/// The storage array that a compute shader reads.
pub const INPUT: u32 = 11;
/// The storage array that a compute shader writes.
pub const OUTPUT: u32 = 12;
/// The Milky Way's light, a cube map, and its sampler.
pub const MILKY_WAY: u32 = 13;
/// See [`MILKY_WAY`].
pub const MILKY_WAY_SAMPLER: u32 = 14;
/// The list of stars, a storage array.
pub const STAR_LIST: u32 = 15;
/// The list of images, a storage array.
pub const STAR_IMAGES: u32 = 16;
/// The number of images and of workgroups that draw them, in storage.
pub const STAR_COUNT: u32 = 17;
/// The light of the images on each pixel, a storage array.
pub const STAR_SUMS: u32 = 18;
/// What the rays of the mesh have met, a storage array.
pub const MESH_POINTS: u32 = 19;
/// Where on the sky the stars of the list are, a storage array.
pub const STAR_INDEX: u32 = 20;
/// The stars that may have an image in a cell of the mesh, a storage array.
pub const CANDIDATES: u32 = 21;
/// The number of candidates and of workgroups that polish them, in storage.
pub const CANDIDATE_COUNT: u32 = 22;

/// The uniform `Presentation` of the presentation's shader, which has bindings of its own.
pub const PRESENTATION: u32 = 0;
/// The texture that a stage of the presentation reads.
pub const PRESENTATION_SOURCE: u32 = 1;

/// The uniform `Difference` of the difference's shader, which has bindings of its own.
pub const DIFFERENCE: u32 = 0;
/// The light of the pinned scene.
pub const DIFFERENCE_LEFT: u32 = 1;
/// The light of the current scene.
pub const DIFFERENCE_RIGHT: u32 = 2;

/// What REFINE has to do, which EDGES writes. The bindings of REFINE are in group 1: in group 0 it
/// binds what the picture's shader does. EDGES has a group of its own.
pub const WORK: u32 = 0;
/// The list of pixels to refine.
pub const LIST: u32 = 1;
/// The picture's texture, which REFINE writes.
pub const PICTURE: u32 = 2;
/// The texture of classes and brightness, which EDGES reads.
pub const TRAITS: u32 = 3;
/// The columns of the picture in which EDGES looks, a uniform.
pub const COLUMNS: u32 = 4;

/// The uniform `Accumulation` of the shader that averages frames, which has bindings of its own.
pub const ACCUMULATION: u32 = 0;
/// The light of the present frame.
pub const ACCUMULATION_LIGHT: u32 = 1;
/// The sum of the light of the frames before it.
pub const ACCUMULATION_SUM: u32 = 2;

/// Invocations of a compute shader's workgroup.
pub const WORKGROUP_SIZE: u32 = 64;
/// Maximum number of workgroups along one side of a dispatch: WebGPU's default limit.
pub const MAX_WORKGROUPS: u32 = 65_535;

/// The constants of the shaders that trace rays or draw the picture.
pub(super) const CONSTANTS: [(&str, u32); 9] = [
    ("BINDING_SCENE", SCENE),
    ("BINDING_SPECTRUM", SPECTRUM),
    ("BINDING_INPUT", INPUT),
    ("BINDING_OUTPUT", OUTPUT),
    ("BINDING_PAGE_THORNE", PAGE_THORNE),
    ("BINDING_ERROR_MAP", ERROR_MAP),
    ("BINDING_STRUCTURE", STRUCTURE),
    ("BINDING_HOT_SPOT", HOT_SPOT),
    ("WORKGROUP_SIZE", WORKGROUP_SIZE),
];

/// The further constant of pictures with a sky behind a tilted disk.
pub(super) const TILT_CONSTANTS: [(&str, u32); 1] = [("BINDING_TILT", TILT)];

/// The further constants of pictures with the sky mode `stars`.
pub(super) const STARLIGHT_CONSTANTS: [(&str, u32); 4] = [
    ("BINDING_STARLIGHT", STARLIGHT),
    ("BINDING_MILKY_WAY", MILKY_WAY),
    ("BINDING_MILKY_WAY_SAMPLER", MILKY_WAY_SAMPLER),
    ("BINDING_STAR_SUMS", STAR_SUMS),
];

/// The constants of the shaders that find and refine edges, beside those above.
pub(super) const ANTIALIAS_CONSTANTS: [(&str, u32); 5] = [
    ("BINDING_WORK", WORK),
    ("BINDING_LIST", LIST),
    ("BINDING_PICTURE", PICTURE),
    ("BINDING_TRAITS", TRAITS),
    ("BINDING_COLUMNS", COLUMNS),
];

/// The further constants of the kernels of point stars.
pub(super) const STAR_CONSTANTS: [(&str, u32); 11] = [
    ("BINDING_STARS", STARS),
    ("BINDING_STAR_TABLE", STAR_TABLE),
    ("BINDING_STAR_LIST", STAR_LIST),
    ("BINDING_STAR_IMAGES", STAR_IMAGES),
    ("BINDING_STAR_COUNT", STAR_COUNT),
    ("BINDING_STAR_SUMS", STAR_SUMS),
    ("BINDING_STAR_MESH", STAR_MESH),
    ("BINDING_MESH_POINTS", MESH_POINTS),
    ("BINDING_STAR_INDEX", STAR_INDEX),
    ("BINDING_CANDIDATES", CANDIDATES),
    ("BINDING_CANDIDATE_COUNT", CANDIDATE_COUNT),
];

/// The constants of the shader that averages frames.
pub(super) const ACCUMULATION_CONSTANTS: [(&str, u32); 3] = [
    ("BINDING_ACCUMULATION", ACCUMULATION),
    ("BINDING_ACCUMULATION_LIGHT", ACCUMULATION_LIGHT),
    ("BINDING_ACCUMULATION_SUM", ACCUMULATION_SUM),
];

/// The constants of the presentation's shader.
pub(super) const PRESENTATION_CONSTANTS: [(&str, u32); 2] = [
    ("BINDING_PRESENTATION", PRESENTATION),
    ("BINDING_PRESENTATION_SOURCE", PRESENTATION_SOURCE),
];

/// The constants of the difference's shader.
pub(super) const DIFFERENCE_CONSTANTS: [(&str, u32); 3] = [
    ("BINDING_DIFFERENCE", DIFFERENCE),
    ("BINDING_DIFFERENCE_LEFT", DIFFERENCE_LEFT),
    ("BINDING_DIFFERENCE_RIGHT", DIFFERENCE_RIGHT),
];
