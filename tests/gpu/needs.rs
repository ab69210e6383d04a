//! What is left out of a shader changes nothing of what it shows, and what a scene needs is said as
//! it is.

use crate::light::{ALONG, light_from};
use crate::{edge_on, gpu, pixel_directions};
use glam::{DVec3, Vec4};
use lightfall::gpu::kernel::uniform;
use lightfall::gpu::{Gpu, GpuScene, Variant};
use lightfall::physics::spectrum;
use lightfall::render::needs;
use lightfall::scene::{Method, Scene, SkyMode, presets};

/// The light from these directions on the observer's legs, by a text of the picture's shader.
fn light(gpu: &Gpu, scene: &Scene, source: &str, directions: &[DVec3]) -> Vec<Vec4> {
    let numbers = GpuScene::for_rays(scene).unwrap();
    let table = spectrum::table()
        .iter()
        .flatten()
        .flat_map(|value| value.to_le_bytes())
        .collect();
    let uniforms = [(0, uniform(&numbers)), (1, table)];
    let given = directions
        .iter()
        .map(|direction| direction.as_vec3().extend(0.0));
    light_from(gpu, source, ALONG, &uniforms, given)
}

#[test]
fn what_is_left_out_of_a_shader_changes_no_light() {
    let Some(gpu) = gpu() else { return };
    let methods = [
        (Method::Closed, 0.0),
        (Method::Verlet, 0.0),
        (Method::Mino, 0.9),
        (Method::KerrSchild, 0.9),
    ];
    let opaque = |scene: &mut Scene| scene.disk.transmission = 0.0;
    let without_sky = |scene: &mut Scene| scene.sky.mode = SkyMode::Off;
    // The scene that can do without, the line that leaves out, and the line that does all the work.
    let omissions: [(fn(&mut Scene), &str, &str); 4] = [
        (
            opaque,
            "const MOST_HITS: u32 = 1u;",
            "const MOST_HITS: u32 = 2u;",
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
            // Another text is contracted otherwise by the compiler, and a hit's radius is taken
            // from r itself or from the length of r n: some roundings of 6e-8, which the steep edge
            // of a star's image and of the disk enlarge.
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
    let most_hits = |scene: &Scene| Variant::picture(scene).most_hits;
    assert_eq!(most_hits(&scene), 2);
    scene.disk.transmission = 0.001;
    assert_eq!(most_hits(&scene), 1);
    // Who asks for the rays themselves gets both crossings all the same.
    assert_eq!(Variant::rays(&scene).most_hits, 2);
}

/// The line of an answer that begins with this name.
fn line<'a>(answer: &'a str, name: &str) -> &'a str {
    answer
        .lines()
        .find_map(|line| line.strip_prefix(name))
        .unwrap()
        .trim_start()
}

#[test]
fn a_presets_needs_are_what_its_scene_says() {
    let needs_of = |number: &str, overrides: &[&str]| {
        let overrides: Vec<_> = overrides
            .iter()
            .map(|set| lightfall::scene::Override::assignment(set).unwrap())
            .collect();
        needs(&presets::find(number).unwrap().scene(&overrides).unwrap())
    };
    let probe = needs_of("6", &[]);
    assert_eq!(line(&probe, "method"), "closed (asked for: auto)");
    assert!(
        line(&probe, "passes ").starts_with("clustering, main_opaque_pass_3d, geodesic, bloom, ")
    );
    assert_eq!(line(&probe, "passes left out"), "none");
    assert!(line(&probe, "passes, empty").ends_with("main_transparent_pass_2d"));
    assert_eq!(line(&probe, "not allocated"), "none");
    assert!(line(&probe, "textures").contains("HDR picture 960x540 rgba16float"));
    assert!(line(&probe, "textures").contains("cells 480x270"));

    let ring = needs_of("5", &[]);
    assert!(line(&ring, "text left out").contains("disk/emission.wgsl"));
    assert!(!line(&ring, "text of shaders").contains("disk.wgsl"));
    assert_eq!(line(&ring, "passes left out"), "clustering");

    let spinning = needs_of("8", &["picture.bloom=0", "picture.bypass=true"]);
    assert_eq!(line(&spinning, "method"), "mino (asked for: auto)");
    assert!(line(&spinning, "flags set").starts_with("SPINNING, "));
    assert_eq!(
        line(&spinning, "passes left out"),
        "clustering, bloom, pixelate, expand"
    );
    assert_eq!(line(&spinning, "while still"), "fit, upscaling");
    assert_eq!(line(&spinning, "not allocated"), "bloom, cells");
}
