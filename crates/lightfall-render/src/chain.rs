//! The passes and textures that a scene needs. Both the passes themselves and the reports take them
//! from here.

use crate::comparison::ComparedScene;
use bevy::math::UVec2;
use lightfall_core::gpu::BloomLevels;
use lightfall_core::scene::{Part, Scene};

/// Rows of bloom's largest level: half the default picture's height. A finer level would take most
/// of the time and change nothing that the presentation grid can show (docs/PASSES.md).
const BLOOM_ROWS: u32 = 256;

/// Smallest number of bloom rows with a visible effect.
const MIN_BLOOM_ROWS: u32 = 8;

/// Bevy's own passes that run in every chain, on some devices at least, and do nothing but clear.
pub const EMPTY_PASSES: [&str; 3] = [
    "bin_unpacking",
    "early_mesh_preprocessing",
    "main_transparent_pass_2d",
];

/// The parts of the chain that depend on the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chain {
    /// Size of the HDR picture.
    pub picture: UVec2,
    /// Whether there is a foreground, with its lamps.
    pub probe: bool,
    /// Samples per pixel of the foreground: one, or four where its edges are smoothed.
    pub samples: u32,
    /// Whether stars are drawn as points.
    pub stars: bool,
    /// Whether edges are found and refined.
    pub antialias: bool,
    /// Whether all of the picture shows light, rather than colours that have a meaning and must not
    /// be averaged.
    pub shows_light: bool,
    /// How many frames are averaged, one at least.
    pub frames: u32,
    /// The textures of the bloom; `None` without bloom, as in views whose colours have a meaning.
    pub bloom: Option<BloomLevels>,
    /// Size of the presentation grid; `None` where it is bypassed.
    pub cells: Option<UVec2>,
    /// Whether the picture shows the difference of two scenes.
    pub difference: bool,
}

/// A texture that a chain writes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrittenTexture {
    /// Name of its content.
    pub name: &'static str,
    /// Size of its largest level, in pixels.
    pub size: UVec2,
    /// WebGPU's name of its format.
    pub format: &'static str,
    /// Number of mip levels.
    pub levels: u32,
}

impl Chain {
    /// The chain that draws the scene.
    pub fn of(scene: &Scene) -> Self {
        let picture = scene.picture.size();
        // A wide picture has fewer rows, so that the bloom texture does not exceed its largest
        // width.
        let rows_of_max_width = u64::from(BloomLevels::MAX_COLUMNS) * u64::from(picture.y)
            / u64::from(picture.x.max(1));
        // A small picture has fewer rows, too: bloom is never finer than half the picture's rows.
        let rows = u64::from(BLOOM_ROWS)
            .min(rows_of_max_width)
            .min(u64::from(picture.y.div_ceil(2))) as u32;
        let shows_light = scene.view.shows_light();
        let smooth_probe = scene.probe.enabled && scene.probe.antialias;
        let bloom = shows_light && scene.picture.bloom > 0.0 && rows >= MIN_BLOOM_ROWS;
        Self {
            picture,
            probe: scene.probe.enabled,
            samples: if smooth_probe { 4 } else { 1 },
            stars: shows_light && scene.sky.has_star_points(),
            antialias: shows_light && scene.picture.antialias,
            shows_light,
            frames: if shows_light {
                scene.picture.samples
            } else {
                1
            },
            bloom: bloom.then_some(BloomLevels { picture, rows }),
            cells: scene.has_cells().then_some(scene.picture.grid()),
            difference: false,
        }
    }

    /// The chain that draws a part of the picture, if one is given.
    #[must_use]
    pub fn of_part(self, part: Option<Part>) -> Self {
        Self {
            picture: part.map_or(self.picture, |part| part.size),
            ..self
        }
    }

    /// The chain that also draws a compared scene. Two scenes side by side need no more passes than
    /// one; two whole pictures have no foreground, which is drawn once. A difference has neither
    /// bloom, which would spread it, nor smooth edges: what is compared are single rays, and it
    /// covers the foreground.
    #[must_use]
    pub fn comparing(self, compared: &ComparedScene) -> Self {
        let pinned = compared.drawn().map(|(scene, _)| Self::of(scene));
        let stars = self.stars || pinned.is_some_and(|pinned| pinned.stars);
        if !compared.is_difference() {
            let two_pictures = compared.is_two_pictures();
            return Self {
                stars,
                probe: self.probe && !two_pictures,
                samples: if two_pictures { 1 } else { self.samples },
                antialias: self.antialias || pinned.is_some_and(|pinned| pinned.antialias),
                shows_light: self.shows_light && pinned.is_none_or(|pinned| pinned.shows_light),
                frames: self
                    .frames
                    .min(pinned.map_or(u32::MAX, |pinned| pinned.frames)),
                ..self
            };
        }
        Self {
            samples: 1,
            stars,
            antialias: false,
            shows_light: false,
            frames: 1,
            bloom: None,
            difference: true,
            ..self
        }
    }

    /// Names of the passes in their order, as in `render --timings`.
    pub fn passes(&self) -> Vec<&'static str> {
        let optional = |present: bool, names: &'static [&'static str]| {
            if present { names } else { &[] }
        };
        [
            optional(self.stars, &["stars"]),
            optional(self.probe, &["clustering"]),
            &["main_opaque_pass_3d", "geodesic"],
            optional(self.difference, &["geodesic_pinned", "difference"]),
            optional(self.antialias, &["edges", "refine"]),
            optional(self.frames > 1, &["accumulate"]),
            optional(self.bloom.is_some(), &["bloom"]),
            &["develop"],
            optional(self.cells.is_some(), &["pixelate"]),
            self.idle_passes(),
        ]
        .concat()
    }

    /// Names of the passes that also run while nothing changes: they show the last picture.
    pub fn idle_passes(&self) -> &'static [&'static str] {
        if self.cells.is_some() {
            &["expand", "upscaling"]
        } else {
            &["fit", "upscaling"]
        }
    }

    /// The textures that pass data from one pass to the next.
    pub fn textures(&self) -> Vec<WrittenTexture> {
        let of_picture_size = [
            (true, "HDR picture", "rgba16float"),
            (true, "tone-mapped picture", "rgba16float"),
            (true, "depth", "depth32float"),
            (self.difference, "light of the scene", "rgba16float"),
            (self.difference, "light of the pinned scene", "rgba16float"),
            (
                self.samples > 1,
                "HDR picture of four samples",
                "rgba16float",
            ),
            (self.antialias, "classes", "rg8uint"),
            (self.frames > 1, "sum of frames", "rgba32float"),
            (self.frames > 1, "sum of one frame less", "rgba32float"),
        ];
        let present = of_picture_size.into_iter().filter(|(present, ..)| *present);
        let mut textures: Vec<_> = present
            .map(|(_, name, format)| WrittenTexture {
                name,
                size: self.picture,
                format,
                levels: 1,
            })
            .collect();
        let base = self.bloom.filter(|levels| levels.square() > 1);
        textures.extend(base.map(|levels| WrittenTexture {
            name: "base of the bloom",
            size: levels.base(),
            format: "rgba16float",
            levels: 1,
        }));
        textures.extend(self.bloom.map(|levels| WrittenTexture {
            name: "bloom",
            size: levels.size(),
            format: "rg11b10ufloat",
            levels: levels.count(),
        }));
        textures.extend(self.cells.map(|size| WrittenTexture {
            name: "cells",
            size,
            format: "rgba8unorm-srgb",
            levels: 1,
        }));
        textures
    }
}
