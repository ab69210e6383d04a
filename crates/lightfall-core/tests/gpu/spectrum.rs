//! The shader's look-up of thermal colours against the CPU's.

use crate::gpu;
use glam::Vec4;
use lightfall_core::gpu::kernel::{ArrayKernel, uniform};
use lightfall_core::gpu::{Variant, bindings};
use lightfall_core::optics::spectrum::{
    TABLE_LEN, TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE, sample, table,
};
use lightfall_core::scene::Scene;

#[test]
#[ignore = "needs a graphics adapter"]
fn the_shader_finds_the_colour_that_the_cpu_finds() {
    let gpu = gpu();
    let source = Variant::picture(&Scene::default()).source()
        + "@group(0) @binding(BINDING_INPUT) var<storage, read> temperatures: array<f32>;
           @group(0) @binding(BINDING_OUTPUT) var<storage, read_write> colours: array<vec4<f32>>;
           @compute @workgroup_size(WORKGROUP_SIZE) fn colours_of(@builtin(global_invocation_id) id: vec3<u32>) {
               if id.x < arrayLength(&temperatures) {
                   colours[id.x] = vec4<f32>(thermal_colour(temperatures[id.x]), 1.0);
               }
           }";
    let entries = table();
    let rows: [Vec4; TABLE_LEN] = std::array::from_fn(|i| Vec4::from_array(entries[i]));
    let kernel = ArrayKernel::new(
        gpu,
        &source,
        "colours_of",
        &[(bindings::SPECTRUM, uniform(&rows))],
    )
    .unwrap();
    // Temperatures from a little below the table to a little above it.
    let ratio = (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).ln();
    let temperatures: Vec<f32> = (0..4000)
        .map(|i| (TABLE_MIN_TEMPERATURE * (ratio * (f64::from(i) / 3900.0 - 0.01)).exp()) as f32)
        .collect();
    let colours: Vec<Vec4> = kernel.run(gpu, &temperatures).unwrap();
    for (temperature, colour) in temperatures.iter().zip(colours) {
        let truth = sample(&entries, f64::from(*temperature)).map(|channel| channel.max(0.0));
        let brightest = truth.into_iter().fold(0.0, f64::max);
        for (found, truth) in colour.truncate().to_array().into_iter().zip(truth) {
            // ln T to 3 units in the last place is 2e-4 of an entry, the steepest of which differ
            // by a factor 2.3; exp of up to -50 adds 1e-5.
            assert!(
                (f64::from(found) - truth).abs() < 3e-4 * brightest,
                "{temperature} K: {colour} against {truth}"
            );
        }
    }
}
