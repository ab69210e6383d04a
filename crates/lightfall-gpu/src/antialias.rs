//! The shader EDGES, which finds the pixels at edges, and the sizes that it shares with REFINE.

use super::bindings;
use super::shader::ShaderText;
use super::shader::text::add_u32;
use glam::UVec2;

/// Pixels that one workgroup of REFINE refines with 4 rays each, and with 16 each.
const BENT_PIXELS: u32 = 16;
const COARSE_PIXELS: u32 = 4;

/// Maximum size of the list of marked pixels in bytes: what WebGPU lets every device bind.
const MAX_LIST_SIZE: u64 = 128 << 20;

/// Rows of the picture that one invocation of EDGES reads.
const STRIP: u32 = 16;

/// The texture that the search for edges compares: each ray's class, and the brightness of its
/// light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct EdgeTraits {
    /// Samples per pixel, as many as the picture has.
    pub samples: u32,
}

/// The search for edges in a picture of this size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edges {
    /// Width and height of the picture, in pixels.
    pub size: UVec2,
}

impl EdgeTraits {
    /// The shader: entry point `edges`.
    pub fn shader(self) -> ShaderText {
        let kind = if self.samples > 1 {
            "texture_multisampled_2d"
        } else {
            "texture_2d"
        };
        let mut prelude = format!("alias Traits = {kind}<u32>;\n");
        add_sizes(&mut prelude);
        add_u32(&mut prelude, "SAMPLES", self.samples);
        add_u32(&mut prelude, "STRIP", STRIP);
        ShaderText::new(prelude, &["edges"], Vec::new())
    }
}

impl Edges {
    /// Size of the buffer `Work` of shaders/antialias/edges.wgsl, in bytes.
    pub const WORK_SIZE: u64 = 28;

    /// Its bytes before the search: no column of workgroups, and columns long enough to keep their
    /// number within WebGPU's limit even if every pixel has a workgroup of its own.
    pub fn no_work(self) -> Vec<u8> {
        let rows = (self.size.x * self.size.y)
            .div_ceil(bindings::MAX_WORKGROUPS)
            .max(1);
        [0, rows, 1, 0, 0, 0, 0]
            .into_iter()
            .flat_map(u32::to_le_bytes)
            .collect()
    }

    /// Size of the list of marked pixels, in bytes. All pixels may be marked: for 16 rays in the
    /// first half of the list, for 4 or 64 in the second. In pictures with more than 16 million
    /// pixels, those that do not fit into WebGPU's smallest binding keep the light of one ray.
    pub fn list_size(self) -> u64 {
        let all = 8 * u64::from(self.size.x) * u64::from(self.size.y);
        all.min(MAX_LIST_SIZE)
    }

    /// Workgroups of EDGES for this many columns of the picture.
    pub fn groups(self, columns: u32) -> UVec2 {
        UVec2::new(
            columns.div_ceil(bindings::WORKGROUP_SIZE),
            self.size.y.div_ceil(STRIP),
        )
    }
}

/// Appends the sizes that EDGES and REFINE share.
pub(super) fn add_sizes(prelude: &mut String) {
    add_u32(prelude, "BENT_PIXELS", BENT_PIXELS);
    add_u32(prelude, "COARSE_PIXELS", COARSE_PIXELS);
}
