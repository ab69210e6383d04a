//! The uniform of a tilted disk, in a binding of its own: only skies behind such a disk read it.

use encase::ShaderType;
use glam::Mat3;
use lightfall_model::scene::Scene;

/// Mirror of `Tilt` in shaders/sky/tilted.wgsl.
#[expect(missing_docs, reason = "the shader says what each field means")]
#[derive(ShaderType, Clone, Copy, Debug, Default, PartialEq)]
pub struct GpuTilt {
    pub hole_from_disk: Mat3,
}

impl GpuTilt {
    /// The numbers of the scene's disk.
    pub fn new(scene: &Scene) -> Self {
        Self {
            hole_from_disk: scene.disk.hole_from_disk().as_mat3(),
        }
    }
}
