//! The light of random scenes, before the picture's shader bounds it: every number of it is finite.

use crate::gpu;
use crate::random::Random;
use crate::random_scene::{SKIES, random_scene};
use glam::{UVec2, Vec4};
use lightfall_core::gpu::kernel::{ArrayKernel, uniform};
use lightfall_core::gpu::{Entry, GpuScene, GpuStarlight, Inputs, Variant, bindings};
use lightfall_core::optics::stars::{Depth, MAX_MAGNITUDE};
use lightfall_core::scene::{Frame, Scene, SkyMode};

/// Random scenes, each with a shader of its own to compile.
const SCENES: usize = 60;
/// The pixels of a picture fill whole workgroups.
const SIZE: UVec2 = UVec2::new(96, 54);

/// WGSL for a [`ArrayKernel`]: the light of pixels. Four rays in a row are those of 2 x 2 pixels, so
/// that each has the neighbours by which its footprints are measured, as in a picture.
pub(crate) const LIGHT: &str = "
    @group(0) @binding(BINDING_INPUT) var<storage, read> pixels: array<vec4<f32>>;
    @group(0) @binding(BINDING_OUTPUT) var<storage, read_write> light_of_pixels: array<vec4<f32>>;
    @compute @workgroup_size(WORKGROUP_SIZE)
    fn pixel_light(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
        own_lane = lane;
        own_share = 1.0;
        lane_beside = lane ^ 1u;
        lane_below = lane ^ 2u;
        light_of_pixels[id.x] = light_along(photon_from(pixel_direction(pixels[id.x].xy + 0.5)));
    }";

/// How the sky mode `stars` reads the map of the Milky Way, which a [`ArrayKernel`] cannot bind; and what
/// takes its place: a light that is finite where the place and the level are. Pictures of the
/// program have the map itself.
pub(crate) const MAP: &str = "textureSampleLevel(milky_way, milky_way_sampler, place, level).rgb";
const INSTEAD_OF_MAP: &str = "(abs(place) / (1.0 + level))";

/// The pixels of a picture, four by four those of 2 x 2 squares.
fn pixels() -> impl Iterator<Item = UVec2> {
    let squares = SIZE / 2;
    let corners = (0..squares.y).flat_map(move |y| (0..squares.x).map(move |x| UVec2::new(x, y)));
    corners.flat_map(|corner| (0..4).map(move |i| 2 * corner + UVec2::new(i % 2, i / 2)))
}

/// The light of each of the pixels in a picture of the scene, not bounded.
fn light(scene: &Scene) -> Vec<Vec4> {
    // Its rays find their neighbours without a fragment entry.
    let variant = Variant {
        entry: Entry::Refine,
        antialias: false,
        ..Variant::picture(scene)
    };
    let mut source = variant.source() + LIGHT;
    let mut uniforms = Inputs::new(scene).declared_in(&source);
    let numbers = GpuScene::new(scene, &Frame::of(scene).with_whole(SIZE)).unwrap();
    uniforms.push((bindings::SCENE, uniform(&numbers)));
    if scene.sky.mode == SkyMode::Stars {
        assert_eq!(source.matches(MAP).count(), 1);
        source = source.replace(MAP, INSTEAD_OF_MAP);
        let depth = Depth::new(scene, MAX_MAGNITUDE).unwrap();
        let starlight = GpuStarlight::new(scene, depth);
        uniforms.push((bindings::STARLIGHT, uniform(&starlight)));
    }
    let given: Vec<Vec4> = pixels()
        .map(|pixel| pixel.as_vec2().extend(0.0).extend(0.0))
        .collect();
    let kernel = ArrayKernel::new(gpu(), &source, "pixel_light", &uniforms).unwrap();
    kernel.run(gpu(), &given).unwrap()
}

/// Stars that are points have passes of their own: see the tests of stars.
#[test]
#[ignore = "needs a graphics adapter"]
fn the_light_of_every_pixel_of_random_scenes_is_finite_and_not_negative() {
    let mut random = Random::new();
    let mut lit = 0;
    for number in 0..SCENES {
        let mut scene = random_scene(&mut random, &SKIES).into_scene();
        [scene.picture.width, scene.picture.height] = SIZE.to_array();
        for (pixel, light) in pixels().zip(light(&scene)) {
            assert!(
                light.is_finite() && light.min_element() >= 0.0,
                "scene {number}, pixel {pixel}: {light}\n{}",
                scene.to_preset()
            );
            lit += usize::from(light.truncate() != Vec4::ZERO.truncate());
        }
    }
    // A fifth of all pixels shows light, so there was something to look at.
    let all = SCENES * (SIZE.x * SIZE.y) as usize;
    assert!(5 * lit > all, "{lit} of {all} pixels show light");
}
