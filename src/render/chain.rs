//! What of the chain a scene needs: which passes run, and which textures exist for them. The passes
//! ask here whether they are wanted, and so does who wants to know.

use bevy::math::UVec2;
use lightfall_core::scene::Scene;

/// Bloom's largest level has half the default picture's height: a level finer than that changes
/// nothing that the presentation grid can show and is where most of the time goes (docs/PASSES.md).
const BLOOM_LEVEL: u32 = 256;

/// Widest bloom texture, in pixels.
const MAX_BLOOM_SIDE: u32 = 8192;

/// Fewest rows of bloom that show.
const MIN_BLOOM_SIDE: u32 = 8;

/// Passes of Bevy's own that run in every chain, on some devices at least, and find nothing to do
/// but to clear.
pub const EMPTY_PASSES: [&str; 3] = [
    "bin_unpacking",
    "early_mesh_preprocessing",
    "main_transparent_pass_2d",
];

/// The parts of the chain that not every scene has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chain {
    /// Size of the HDR picture.
    pub picture: UVec2,
    /// Whether there is a foreground, with its lamps.
    pub probe: bool,
    /// Samples of a pixel's foreground: one, or four where its edges are smoothed.
    pub samples: u32,
    /// Rows of bloom's largest level, where there is bloom.
    pub bloom: Option<u32>,
    /// Size of the presentation grid, where the picture is shown in cells.
    pub cells: Option<UVec2>,
}

/// A texture that a chain writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Written {
    /// What it holds.
    pub name: &'static str,
    /// Its size, in pixels; of the largest level, where it has several.
    pub size: UVec2,
    /// Its format, as WebGPU names it.
    pub format: &'static str,
    /// How many levels it has.
    pub levels: u32,
}

impl Chain {
    /// The one that draws the scene.
    pub fn of(scene: &Scene) -> Self {
        let picture = UVec2::new(scene.picture.width, scene.picture.height);
        // A wide picture's bloom has fewer rows, lest its texture be wider than a device can do.
        let widest = u64::from(MAX_BLOOM_SIDE) * u64::from(picture.y) / u64::from(picture.x.max(1));
        // A coarse picture's too: half its rows are as fine as bloom ever is.
        let rows = u64::from(BLOOM_LEVEL)
            .min(widest)
            .min(u64::from(picture.y.div_ceil(2))) as u32;
        let grid = UVec2::new(scene.picture.grid_width, scene.picture.grid_height);
        Self {
            picture,
            probe: scene.probe.enabled,
            samples: if scene.probe.enabled && scene.probe.antialias {
                4
            } else {
                1
            },
            bloom: (scene.picture.bloom > 0.0 && rows >= MIN_BLOOM_SIDE).then_some(rows),
            cells: (!scene.picture.bypass).then_some(grid),
        }
    }

    /// The passes in their order, by the names that `render --timings` gives them.
    pub fn passes(&self) -> Vec<&'static str> {
        let lamps: &[_] = if self.probe { &["clustering"] } else { &[] };
        let bloom: &[_] = if self.bloom.is_some() {
            &["bloom"]
        } else {
            &[]
        };
        let cells: &[_] = if self.cells.is_some() {
            &["pixelate"]
        } else {
            &[]
        };
        let eye = [
            lamps,
            &["main_opaque_pass_3d", "geodesic"],
            bloom,
            &["tonemapping"],
        ]
        .concat();
        [&eye, cells, self.kept_passes()].concat()
    }

    /// Those of them that still run while nothing changes: what shows a kept picture.
    pub fn kept_passes(&self) -> &'static [&'static str] {
        if self.cells.is_some() {
            &["expand", "upscaling"]
        } else {
            &["fit", "upscaling"]
        }
    }

    /// The textures between the passes.
    pub fn textures(&self) -> Vec<Written> {
        let of_picture = |name, format| Written {
            name,
            size: self.picture,
            format,
            levels: 1,
        };
        let mut textures = vec![
            of_picture("HDR picture", "rgba16float"),
            of_picture("tone-mapped picture", "rgba16float"),
            of_picture("depth", "depth32float"),
        ];
        if self.samples > 1 {
            textures.push(of_picture("HDR picture of four samples", "rgba16float"));
        }
        textures.extend(self.bloom.map(|rows| {
            Written {
                name: "bloom",
                // As Bevy sizes it.
                size: (self.picture.as_vec2() * (rows as f32 / self.picture.y as f32))
                    .round()
                    .as_uvec2()
                    .max(UVec2::ONE),
                format: "rg11b10ufloat",
                levels: rows.ilog2().max(2) - 1,
            }
        }));
        textures.extend(self.cells.map(|size| Written {
            name: "cells",
            size,
            format: "rgba8unorm-srgb",
            levels: 1,
        }));
        textures
    }
}
