//! The cost of a scene, as `presets show --needs` prints it.

use lightfall_core::scene::presets;
use lightfall_render::cost_report;

/// The line of an answer that begins with this name.
fn line<'a>(answer: &'a str, name: &str) -> &'a str {
    answer
        .lines()
        .find_map(|line| line.strip_prefix(name))
        .unwrap()
        .trim_start()
}

#[test]
fn the_cost_report_follows_from_the_scene() {
    let needs_of = |number: &str, overrides: &[&str]| {
        let overrides: Vec<_> = overrides
            .iter()
            .map(|set| lightfall_core::scene::Override::assignment(set).unwrap())
            .collect();
        cost_report(&presets::find(number).unwrap().scene(&overrides).unwrap())
    };
    let still = ["disk.structure=\"none\"", "disk.limb=\"none\""];
    let probe = needs_of("6", &still);
    assert_eq!(line(&probe, "method"), "closed (asked for: auto)");
    assert_eq!(line(&probe, "picture"), "960x540 pixels, 480x270 cells");
    assert!(
        line(&probe, "passes ").starts_with(
            "stars, clustering, main_opaque_pass_3d, geodesic, edges, refine, bloom, "
        )
    );
    assert_eq!(line(&probe, "passes left out"), "accumulate");
    assert!(line(&probe, "passes, empty").ends_with("main_transparent_pass_2d"));
    let sums = "sum of frames, sum of one frame less";
    assert_eq!(line(&probe, "not allocated"), sums);
    assert!(line(&probe, "textures").contains("HDR picture 960x540 rgba16float"));
    assert!(line(&probe, "textures").contains("cells 480x270"));

    let ring = needs_of("5", &[]);
    assert!(line(&ring, "files left out").contains("disk/emission.wgsl"));
    assert!(!line(&ring, "shader files").contains("disk.wgsl"));
    assert_eq!(line(&ring, "passes left out"), "clustering, accumulate");

    assert_eq!(line(&probe, "disk's light"), "none");
    assert_eq!(
        line(&probe, "disk's clock"),
        "nothing moves: a still picture is kept"
    );
    let living = [
        "disk.structure=\"streaks\"",
        "disk.waves=32",
        "disk.limb=\"electron-scattering\"",
        "hot_spot.kind=\"sheared\"",
    ];
    let moving = needs_of("2", &living);
    let light = line(&moving, "disk's light");
    for part in [
        "structure streaks of 32 waves a ring (12 in a window on a software renderer)",
        "hot spot, sheared",
        "limb darkening, electron-scattering",
        "delay of the light by ",
    ] {
        assert!(light.contains(part), "{light}");
    }
    assert_eq!(
        line(&moving, "disk's clock"),
        "4 r_s/c per second: a window draws every frame while it runs; / pauses it"
    );
    let order = needs_of("2", &[&living[..], &["view=\"order\""]].concat());
    assert_eq!(line(&order, "disk's light"), "none");
    assert!(line(&order, "disk's clock").starts_with("stands still in this view"));

    let spinning = needs_of(
        "8",
        &[
            "picture.bloom=0",
            "picture.bypass=true",
            "picture.antialias=false",
        ],
    );
    assert_eq!(line(&spinning, "method"), "closed (asked for: auto)");
    assert!(line(&spinning, "flags set").starts_with("SPINNING, "));
    assert_eq!(
        line(&spinning, "passes left out"),
        "clustering, edges, refine, accumulate, bloom, pixelate, expand"
    );
    assert_eq!(line(&spinning, "picture"), "960x540 pixels, no cells");
    assert_eq!(line(&spinning, "while idle"), "fit, upscaling");
    assert_eq!(
        line(&spinning, "not allocated"),
        format!("classes, {sums}, bloom, cells")
    );
    assert_eq!(line(&spinning, "edges"), "one ray a pixel");

    let kernels = line(&spinning, "star kernels");
    assert!(
        kernels.starts_with("trace_mesh, find_candidates, "),
        "{kernels}"
    );
    assert!(kernels.ends_with("dim, splat"), "{kernels}");
    assert!(line(&spinning, "star files").contains("stars/refine_image.wgsl"));
    assert_eq!(line(&ring, "star kernels"), "solve, splat");
    let grid = needs_of("2", &["sky.mode=\"grid\""]);
    for topic in ["stars", "star kernels", "star files"] {
        assert_eq!(line(&grid, &format!("{topic} ")), "none");
    }

    let mean = needs_of("2", &["picture.samples=64"]);
    assert_eq!(line(&mean, "frames averaged"), "64");
    assert!(line(&mean, "passes ").contains(", edges, refine, accumulate, bloom"));
    assert!(line(&mean, "textures").contains("classes 960x540 rg8uint"));
    // Marks are neither refined nor averaged.
    let marks = needs_of("2", &["picture.samples=64", "view=\"order\""]);
    assert_eq!(line(&marks, "frames averaged"), "1");
    assert!(!line(&marks, "passes ").contains("edges"));
}
