//! The parts that a shader omits do not change its picture.

use crate::ALONG;
use crate::light::light_from;
use crate::{edge_on, gpu, pixel_directions};
use glam::{DVec3, Vec4};
use lightfall_core::gpu::kernel::{table_bytes, uniform};
use lightfall_core::gpu::{Gpu, GpuScene, Variant, bindings};
use lightfall_core::optics::spectrum;
use lightfall_core::scene::{Method, Scene, SkyMode};

/// The light from these directions on the observer's axes, by this text of the picture's shader.
fn light(gpu: &Gpu, scene: &Scene, source: &str, directions: &[DVec3]) -> Vec<Vec4> {
    let numbers = GpuScene::for_rays(scene).unwrap();
    let uniforms = [
        (bindings::SCENE, uniform(&numbers)),
        (bindings::SPECTRUM, table_bytes(&spectrum::table())),
    ];
    let given = directions
        .iter()
        .map(|direction| direction.as_vec3().extend(0.0));
    light_from(gpu, source, ALONG, &uniforms, given)
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_work_that_a_shader_omits_changes_no_light() {
    let gpu = gpu();
    let methods = [
        (Method::Closed, 0.0),
        (Method::Verlet, 0.0),
        (Method::Mino, 0.9),
        (Method::KerrSchild, 0.9),
    ];
    // A disk without faded edges, at which light from behind passes.
    let opaque = |scene: &mut Scene| (scene.disk.transmission, scene.disk.edge_taper) = (0.0, 0.0);
    let without_sky = |scene: &mut Scene| scene.sky.mode = SkyMode::Off;
    // A change to a scene that needs less work, the flag that omits the work, and the flag that
    // does it.
    let omissions: [(fn(&mut Scene), &str, &str); 4] = [
        (
            opaque,
            "const MAX_HITS: u32 = 1u;",
            "const MAX_HITS: u32 = 2u;",
        ),
        (
            opaque,
            "const FOLLOW_BEYOND_HITS: bool = false;",
            "const FOLLOW_BEYOND_HITS: bool = true;",
        ),
        (
            without_sky,
            "const SKY_DIRECTION: bool = false;",
            "const SKY_DIRECTION: bool = true;",
        ),
        (
            |_| {},
            "const AZIMUTH: bool = false;",
            "const AZIMUTH: bool = true;",
        ),
    ];
    for (method, spin) in methods {
        for (change, short, long) in omissions {
            let mut scene = edge_on();
            (scene.method, scene.hole.spin) = (method, spin);
            // A sky that needs nothing but the uniform.
            scene.sky.mode = SkyMode::Procedural;
            change(&mut scene);
            let source = Variant::picture(&scene).source();
            assert!(
                source.contains(short),
                "{method:?} with {scene:?} does not leave out {short}"
            );
            let directions = pixel_directions(&scene, 96, 54);
            let least = light(gpu, &scene, &source, &directions);
            let most = light(gpu, &scene, &source.replace(short, long), &directions);
            let lit = most
                .iter()
                .filter(|light| light.max_element() > 1e-3)
                .count();
            assert!(
                lit > 300,
                "{method:?}, {short}: only {lit} rays bring light"
            );
            // The compiler contracts the two texts differently, and a hit's radius is r itself or
            // the length of r n. These are some roundings of 6e-8, which the steep edges of a
            // star's image and of the disk amplify.
            let worst = least
                .iter()
                .zip(&most)
                .map(|(a, b)| (*a - *b).abs().max_element() / (b.max_element() + 0.1));
            let differ = worst.filter(|difference| *difference > 1e-3).count();
            assert!(differ <= 2, "{method:?}, {short}: {differ} rays differ");
        }
    }
}

#[test]
fn a_disk_that_lets_light_through_counts_two_crossings() {
    let mut scene = edge_on();
    let max_hits = |scene: &Scene| Variant::picture(scene).max_hits;
    // Its faded edges let all light through.
    assert_eq!(max_hits(&scene), 2);
    scene.disk.edge_taper = 0.0;
    assert_eq!(max_hits(&scene), 1);
    scene.disk.transmission = 0.001;
    assert_eq!(max_hits(&scene), 1);
    scene.disk.transmission = 0.04;
    assert_eq!(max_hits(&scene), 2);
    // The records of rays contain both crossings all the same.
    assert_eq!(Variant::rays(&scene).max_hits, 2);
}
