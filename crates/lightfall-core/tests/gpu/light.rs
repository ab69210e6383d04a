//! Values of expressions in a picture's shader.

use glam::Vec4;
use lightfall_core::gpu::Gpu;
use lightfall_core::gpu::kernel::ArrayKernel;

/// The value of a WGSL expression, a `vec4<f32>`, for each `vec4<f32>` called `given` in it.
/// `uniforms` are the bytes of the shader's uniforms, by binding.
pub fn light_from(
    gpu: &Gpu,
    shader: &str,
    expression: &str,
    uniforms: &[(u32, Vec<u8>)],
    given: impl IntoIterator<Item = Vec4>,
) -> Vec<Vec4> {
    let entry = "@group(0) @binding(BINDING_INPUT) var<storage, read> all_given: array<vec4<f32>>;
        @group(0) @binding(BINDING_OUTPUT) var<storage, read_write> lights: array<vec4<f32>>;
        @compute @workgroup_size(WORKGROUP_SIZE) fn light_from(@builtin(global_invocation_id) id: vec3<u32>) {
            if id.x < arrayLength(&all_given) {
                let given = all_given[id.x];
                lights[id.x] = EXPRESSION;
            }
        }";
    let source = shader.to_owned() + &entry.replace("EXPRESSION", expression);
    let kernel = ArrayKernel::new(gpu, &source, "light_from", uniforms).unwrap();
    kernel
        .run(gpu, &given.into_iter().collect::<Vec<_>>())
        .unwrap()
}
