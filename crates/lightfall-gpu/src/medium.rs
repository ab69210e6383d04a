//! The numbers of matter with depth: those of a disk with thickness, and the nodes at which
//! light is asked for.

use super::shader::text::{add_constant, add_f32, add_u32};
use encase::ShaderType;
use lightfall_model::scene::Scene;
use lightfall_optics::medium::{Nodes, ThickDisk};
use lightfall_optics::structure::Structure;

/// Mirror of `ThickDisk` in shaders/medium/thick_disk.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Debug, Default, PartialEq)]
pub struct GpuThickDisk {
    pub half_opening: f32,
    pub max_half_opening: f32,
    pub inverse_pivot: f32,
    pub flare: f32,
    pub depth: f32,
    pub outer_fade: f32,
    pub emission_scale: f32,
    pub thin_emission: f32,
    pub flux_spread: f32,
    pub density_spread: f32,
}

impl GpuThickDisk {
    /// The numbers of the scene's disk; `None` if it has no thickness.
    pub fn new(scene: &Scene) -> Option<Self> {
        let disk = ThickDisk::of(scene)?;
        let structure = Structure::new(scene, Some(0));
        let [flux_spread, density_spread] = structure
            .map_or([0.0; 2], |structure| structure.spread(&scene.disk))
            .map(|spread| spread as f32);
        let [_, outer] = disk.shape.edges;
        Some(Self {
            half_opening: disk.pivot_half_opening() as f32,
            max_half_opening: disk.max_half_opening() as f32,
            inverse_pivot: (1.0 / disk.pivot()) as f32,
            flare: disk.shape.flare as f32,
            depth: disk.shape.depth as f32,
            outer_fade: (disk.shape.tapers[1] * outer) as f32,
            emission_scale: disk.emission_scale() as f32,
            thin_emission: (0.5 / disk.shape.depth) as f32,
            flux_spread,
            density_spread,
        })
    }
}

/// How well light is integrated, for a largest error: the nodes of a chunk, and the optical depth at
/// which a ray ends.
///
/// Measured in f64 in four scenes, from edge-on to depth 200: 95 of 100 pixels with light have an
/// error below 7e-2 with three nodes, 1.2e-2 with four, and 1e-3 with eight. In random scenes the
/// error reaches 8e-2 with three and 1.1e-3 with eight.
pub(super) fn medium_nodes(max_error: f64) -> u32 {
    match max_error {
        error if error >= 0.1 => 3,
        error if error >= 0.012 => 4,
        error if error >= 0.002 => 8,
        _ => 12,
    }
}

/// The optical depth at which a ray with so many nodes in a chunk ends.
fn end_depth(nodes: u32) -> f64 {
    match nodes {
        3 | 4 => 6.0,
        8 => 10.0,
        _ => 12.0,
    }
}

/// Steps of the search for a boundary. Where a disk is opaque, most of its light comes from places next
/// to its boundary.
fn searches(nodes: u32) -> u32 {
    match nodes {
        3 => 4,
        4 => 5,
        8 => 7,
        _ => 9,
    }
}

/// Appends the share of light at which a ray ends that has so many nodes in a chunk.
pub(super) fn add_min_transmission(prelude: &mut String, nodes: u32) {
    add_f32(prelude, "MIN_TRANSMISSION", (-end_depth(nodes)).exp());
}

/// Appends the nodes to a prelude, four in a vector, of which the last may be empty.
pub(super) fn add_constants(prelude: &mut String, count: u32) {
    let nodes = Nodes::new(count as usize);
    let blocks = count.div_ceil(4);
    let at = |values: &[f64], i: usize| values.get(i).copied().unwrap_or(0.0);
    let vector = |values: &[f64], block: u32| {
        let first = 4 * block as usize;
        let lanes = [0, 1, 2, 3].map(|lane| format!("{:?}", at(values, first + lane) as f32));
        format!("vec4<f32>({})", lanes.join(", "))
    };
    let vectors = |values: &[f64]| {
        let vectors: Vec<_> = (0..blocks).map(|block| vector(values, block)).collect();
        format!("array<vec4<f32>, {blocks}>({})", vectors.join(", "))
    };
    // The columns of a matrix belong to the densities, and its rows to the nodes up to which they
    // are summed.
    let matrix = |rows: u32, columns: u32| {
        let column = |j: u32| {
            let column = nodes.partial.iter().map(|row| at(row, j as usize));
            vector(&column.collect::<Vec<_>>(), rows)
        };
        let columns: Vec<_> = (4 * columns..4 * columns + 4).map(column).collect();
        format!("mat4x4<f32>({})", columns.join(", "))
    };
    let matrices: Vec<_> = (0..blocks * blocks)
        .map(|i| matrix(i / blocks, i % blocks))
        .collect();
    add_u32(prelude, "MEDIUM_NODES", count);
    add_u32(prelude, "MEDIUM_BLOCKS", blocks);
    add_u32(prelude, "MEDIUM_SEARCHES", searches(count));
    let kind = |of: &str, length: u32| format!("array<{of}, {length}>");
    let list = kind("vec4<f32>", blocks);
    add_constant(prelude, "MEDIUM_PLACES", &list, vectors(&nodes.places));
    add_constant(prelude, "MEDIUM_WEIGHTS", &list, vectors(&nodes.weights));
    let kind = kind("mat4x4<f32>", blocks * blocks);
    let text = format!("{kind}({})", matrices.join(", "));
    add_constant(prelude, "MEDIUM_PARTIAL", &kind, text);
}
