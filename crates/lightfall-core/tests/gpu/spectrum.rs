//! The shader's look-up of thermal colours against the CPU's.

use crate::gpu;
use crate::light::light_from;
use glam::Vec4;
use lightfall_core::gpu::kernel::table_bytes;
use lightfall_core::gpu::{Variant, bindings};
use lightfall_core::optics::spectrum::{
    TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE, sample, table,
};
use lightfall_core::scene::Scene;

#[test]
#[ignore = "needs a graphics adapter"]
fn the_shader_finds_the_colour_that_the_cpu_finds() {
    // Temperatures from a little below the table to a little above it.
    let ratio = (TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE).ln();
    let temperatures: Vec<f32> = (0..4000)
        .map(|i| (TABLE_MIN_TEMPERATURE * (ratio * (f64::from(i) / 3900.0 - 0.01)).exp()) as f32)
        .collect();
    let entries = table();
    let colours = light_from(
        gpu(),
        &Variant::picture(&Scene::default()).source(),
        "vec4<f32>(thermal_colour(given.x), 1.0)",
        &[(bindings::SPECTRUM, table_bytes(&entries))],
        temperatures.iter().map(|kelvin| Vec4::splat(*kelvin)),
    );
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
