//! The legends of the views, compared with the shaders' own colours.

use crate::adapter::gpu;
use crate::light::light_from;
use glam::{Vec3, Vec4};
use lightfall_core::gpu::Variant;
use lightfall_core::scene::{Method, Scene, View};

/// WGSL expressions that give the colours of a legend's swatches, in order, from the values that
/// the swatches state.
fn colours(view: View) -> &'static [&'static str] {
    match view {
        View::Colour => &[],
        View::Unfinished => &["MAGENTA"],
        View::Classes => &[
            "colour_by_crossings(SKY_CLASSES, 0u)",
            "colour_by_crossings(SKY_CLASSES, 1u)",
            "colour_by_crossings(SKY_CLASSES, 2u)",
            "colour_by_crossings(CAPTURED_CLASSES, 0u)",
            "colour_by_crossings(CAPTURED_CLASSES, 1u)",
            "colour_by_crossings(CAPTURED_CLASSES, 2u)",
            "colour_by_crossings(UNFINISHED_CLASSES, 0u)",
        ],
        View::Order => &[
            "order_colour(0.0)",
            "order_colour(1.0)",
            "order_colour(2.0)",
            "order_colour(3.0)",
            "vec3<f32>(0.0)",
            "MAGENTA",
        ],
        View::Delay => &[
            "delay_colour(-10.0)",
            "delay_colour(0.0)",
            "delay_colour(10.0)",
            "delay_colour(20.0)",
            "delay_colour(30.0)",
            "vec3<f32>(0.0)",
            "MAGENTA",
        ],
        View::Redshift => &[
            "shift_colour(2.0)",
            "shift_colour(1.41421356)",
            "shift_colour(1.0)",
            "shift_colour(0.70710678)",
            "shift_colour(0.5)",
            "vec3<f32>(0.0)",
        ],
        View::Residual => &[
            "residual_colour(1e-8)",
            "residual_colour(1e-6)",
            "residual_colour(1e-4)",
            "residual_colour(1e-2)",
            "residual_colour(1.0)",
        ],
        View::Steps | View::Samples => &[
            "vec3<f32>(0.0)",
            "count_colour(4.0)",
            "count_colour(8.0)",
            "count_colour(16.0)",
            "count_colour(32.0)",
            "count_colour(64.0)",
            "count_colour(128.0)",
            "count_colour(256.0)",
            "MAGENTA",
        ],
        View::Error => &[
            "scale_colour(0.0)",
            "scale_colour(0.25)",
            "scale_colour(0.5)",
            "scale_colour(0.75)",
            "scale_colour(1.0)",
            "MAGENTA",
            "vec3<f32>(0.0)",
            "vec3<f32>(0.05)",
        ],
        View::Depth => &[
            "vec3<f32>(0.0)",
            "depth_colour(0.01)",
            "depth_colour(0.1)",
            "depth_colour(1.0)",
            "depth_colour(5.0)",
            "MAGENTA",
        ],
        View::LightError => &[
            "scale_colour(0.0)",
            "scale_colour(0.25)",
            "scale_colour(0.5)",
            "scale_colour(0.75)",
            "scale_colour(1.0)",
            "vec3<f32>(0.0)",
            "MAGENTA",
        ],
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn every_view_has_a_legend_in_its_shaders_own_colours() {
    let gpu = gpu();
    for view in View::ALL {
        let swatches = view.properties().swatches;
        let wanted = colours(view);
        assert_eq!(swatches.is_empty(), view == View::Colour, "{view:?}");
        if swatches.is_empty() {
            continue;
        }
        assert_eq!(swatches.len(), wanted.len(), "{view:?}");
        let mut scene = Scene {
            view,
            method: Method::Verlet,
            ..Scene::default()
        };
        if view.shows_matter() {
            (scene.method, scene.disk.thickness) = (Method::Auto, 0.06);
        }
        let source = Variant::picture(&scene).source();
        let expression = format!(
            "vec4<f32>(array<vec3<f32>, {}>({})[u32(given.x)], 0.0)",
            wanted.len(),
            wanted.join(", ")
        );
        let given = (0..wanted.len()).map(|index| Vec4::splat(index as f32));
        let lights = light_from(gpu, &source, &expression, &[], given);
        for ((colour, meaning), light) in swatches.iter().zip(lights) {
            // The scale of errors is written down in four places; one in 255 tones is ten times
            // coarser where it is finest.
            let off = (light.truncate() - Vec3::from(*colour)).abs().max_element();
            assert!(
                off < 1e-4,
                "{view:?}, {meaning}: {light} in the shader, {colour:?} in the legend"
            );
        }
    }
}
