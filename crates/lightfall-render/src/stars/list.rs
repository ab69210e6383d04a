//! The list of stars on the GPU, one for each seed and depth that is in use.

use bevy::prelude::Resource;
use bevy::render::render_resource::{Buffer, BufferInitDescriptor, BufferUsages};
use bevy::render::renderer::RenderDevice;
use lightfall_core::gpu::stars::{PackedStars, index_bytes};
use lightfall_core::optics::stars::{Catalogue, StarList};
use std::sync::{Arc, OnceLock};

/// Lists are made for depths a half magnitude apart, so that a list serves pictures of similar size.
const STEPS_PER_MAGNITUDE: f64 = 2.0;

/// Maximum number of lists: one for each of two compared scenes.
const MAX_LISTS: usize = 2;

/// The lists in use, the most recently used last.
#[derive(Resource, Default)]
pub(crate) struct StarLists(Vec<(Key, Arc<GpuStarList>)>);

/// What a list depends on, besides the catalogue: the seed, and the depth in steps.
type Key = (u32, i32);

/// A list of stars, and its copy on the GPU.
pub(crate) struct GpuStarList {
    pub(crate) stars: PackedStars,
    pub(crate) buffer: Buffer,
    /// Where on the sky the stars are, from the first scene on that searches the sky.
    index: OnceLock<Buffer>,
}

impl GpuStarList {
    /// The index by which a scene's mesh finds the stars.
    pub(super) fn index(&self, device: &RenderDevice) -> &Buffer {
        self.index.get_or_init(|| {
            device.create_buffer_with_data(&BufferInitDescriptor {
                label: Some("index of stars"),
                contents: &index_bytes(&self.stars),
                usage: BufferUsages::STORAGE,
            })
        })
    }
}

impl StarLists {
    /// The list of `catalogue` with the fainter stars of `seed`, at least as deep as `faintest` V.
    pub(crate) fn get(
        &mut self,
        catalogue: &Catalogue,
        seed: u32,
        faintest: f64,
        device: &RenderDevice,
    ) -> Arc<GpuStarList> {
        let depth = (faintest * STEPS_PER_MAGNITUDE).ceil();
        let key = (seed, depth as i32);
        let known = self.0.iter().position(|(known, _)| *known == key);
        let entry = match known {
            Some(index) => self.0.remove(index),
            None => {
                if self.0.len() >= MAX_LISTS {
                    self.0.remove(0);
                }
                let list = StarList::new(catalogue, seed, depth / STEPS_PER_MAGNITUDE);
                let stars = PackedStars::new(list.stars());
                let buffer = device.create_buffer_with_data(&BufferInitDescriptor {
                    label: Some("stars"),
                    contents: stars.bytes(),
                    usage: BufferUsages::STORAGE,
                });
                let index = OnceLock::new();
                let list = GpuStarList {
                    stars,
                    buffer,
                    index,
                };
                (key, Arc::new(list))
            }
        };
        let list = Arc::clone(&entry.1);
        self.0.push(entry);
        list
    }
}
