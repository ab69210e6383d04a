//! The numbers of the pictures through which a mesh finds images: the scene's own one, or the sides of
//! a cube about the camera.

use crate::graphics::Graphics;
use bevy::render::render_resource::encase::internal::WriteInto;
use bevy::render::render_resource::*;
use glam::DMat3;
use lightfall_core::gpu::GpuScene;
use lightfall_core::gpu::stars::{GpuStarMesh, PackedStars, StarSide, mesh_layout};
use lightfall_core::optics::stars::images::MeshLayout;
use lightfall_core::scene::{Frame, Scene};

/// The uniforms of the meshes of one scene.
#[derive(Default)]
pub(super) struct MeshNumbers {
    /// For each side, or for the picture itself.
    meshes: Vec<UniformBuffer<GpuStarMesh>>,
    /// The scene on each side, if there are any.
    sides: Vec<UniformBuffer<GpuScene>>,
}

impl MeshNumbers {
    /// Writes the numbers of a scene. `hole_from_list` turns the list's directions into the hole's
    /// frame. Returns the layout that all meshes have and how many there are; `None` if a side's
    /// observer does not exist.
    pub(super) fn write(
        &mut self,
        scene: &Scene,
        (list, hole_from_list): (&PackedStars, DMat3),
        graphics: &Graphics,
    ) -> Option<(MeshLayout, usize)> {
        let sides = StarSide::all_of(scene);
        // All sides have the same size.
        let searched: &Scene = sides.first().map_or(scene, |side| &side.scene);
        let layout = mesh_layout(searched, MeshLayout::CELLS);
        let own = GpuStarMesh::new(searched, &layout, list, hole_from_list);
        let meshes = if sides.is_empty() {
            vec![own]
        } else {
            let on_sides = sides.iter().map(|side| own.clone().on_side(side));
            on_sides.collect()
        };
        let scenes = sides
            .iter()
            .map(|side| GpuScene::new(&side.scene, &Frame::of(&side.scene)).ok());
        let scenes = scenes.collect::<Option<Vec<_>>>()?;
        write_all(&mut self.meshes, meshes, graphics);
        write_all(&mut self.sides, scenes, graphics);
        Some((layout, self.meshes.len()))
    }

    /// The mesh of a round.
    pub(super) fn mesh(&self, round: usize) -> Option<BindingResource<'_>> {
        self.meshes.get(round)?.binding()
    }

    /// The scene of a round; `None` where it is that of the picture.
    pub(super) fn scene(&self, round: usize) -> Option<&UniformBuffer<GpuScene>> {
        self.sides.get(round)
    }
}

/// Writes values to uniforms, which stay the same buffers as long as their number does.
fn write_all<T: ShaderType + WriteInto + Default>(
    uniforms: &mut Vec<UniformBuffer<T>>,
    values: Vec<T>,
    graphics: &Graphics,
) {
    uniforms.resize_with(values.len(), || UniformBuffer::from(T::default()));
    for (uniform, value) in uniforms.iter_mut().zip(values) {
        uniform.set(value);
        uniform.write_buffer(&graphics.device, &graphics.queue);
    }
}
