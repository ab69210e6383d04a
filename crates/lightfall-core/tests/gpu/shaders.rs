//! The text of every shader, without a GPU.

use crate::variants::every_variant;
use lightfall_core::gpu::stars::{StarKernel, candidate_shader, splat_shader};
use lightfall_core::gpu::{
    Accumulation, Bloom, Developer, Difference, EdgeTraits, Entry, Presentation, Print, ShaderText,
    Variant,
};
use lightfall_core::scene::{
    ARTICLE_MAX_STEPS, DiskModel, DiskStructure, HotSpotKind, LimbDarkening, Method, Projection,
    Scene, SkyMode, View,
};
use std::collections::{BTreeSet, HashMap, HashSet};

#[test]
fn naga_accepts_every_variant() {
    // naga checks what is behind a flag whatever the flag's value is: one of the texts that differ in
    // such values alone is enough.
    let without_values = |source: String| {
        source
            .replace(": bool = true;", ": bool;")
            .replace(": bool = false;", ": bool;")
    };
    let mut seen = HashSet::new();
    let mut variants = every_variant();
    variants.retain(|variant| seen.insert(without_values(variant.source())));
    assert!(variants.len() > 100, "{} variants", variants.len());
    let failures: Vec<String> = variants
        .into_iter()
        .filter_map(|variant| {
            let message = validate(&variant.text(), variant.entry.points()).err()?;
            Some(format!("{variant:?}\n{message}"))
        })
        .collect();
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_files_of_all_pictures_are_those_of_every_variant_that_draws_one() {
    let mut variants = every_variant();
    // No scene asks for layers: a command does.
    variants.retain(|variant| variant.entry == Entry::Picture && !variant.layers);
    let files: BTreeSet<_> = variants.into_iter().flat_map(Variant::files).collect();
    assert_eq!(Variant::files_of_all_pictures(), files);
}

/// The shaders that are no variants, with their entry points.
pub fn other_shaders() -> Vec<(ShaderText, &'static [&'static str])> {
    let [one, four] = [1, 4].map(|samples| EdgeTraits { samples }.shader());
    let developers = Developer::all().map(|developer| -> (ShaderText, &'static [&'static str]) {
        (developer.shader(), &["vertex", "develop"])
    });
    let others: Vec<(ShaderText, &'static [&'static str])> = vec![
        (
            Presentation::shader(),
            &["vertex", "pixelate", "expand", "fit"],
        ),
        (one, &["edges"]),
        (four, &["edges"]),
        (
            candidate_shader(),
            &["find_candidates", "find_wide_candidates", "test_candidates"],
        ),
        (splat_shader(Projection::Perspective), &["splat"]),
        (splat_shader(Projection::Fisheye), &["splat"]),
        (splat_shader(Projection::Equirectangular), &["splat"]),
        (Accumulation::shader(), &["vertex", "accumulate"]),
        (
            Bloom::shader(),
            &[
                "over_all",
                "bloom_base",
                "bloom_first",
                "bloom_shrink",
                "bloom_spread",
            ],
        ),
        (Print::shader(), &["vertex", "print"]),
        (Difference::shader(), &["vertex", "difference"]),
    ];
    developers.into_iter().chain(others).collect()
}

#[test]
fn naga_accepts_every_other_shader() {
    for (shader, entries) in other_shaders() {
        if let Err(message) = validate(&shader, entries) {
            panic!("{entries:?}: {message}");
        }
    }
}

/// Validates a text and compares its entry points. No layout may depend on attributes, which wgpu
/// leaves out where it writes shaders anew for browsers.
fn validate(text: &ShaderText, entries: &[&str]) -> Result<(), String> {
    let found = text.validate().map_err(|fault| fault.to_string())?;
    let source = text.source();
    if source.contains("@align") || source.contains("@size") {
        Err("a layout depends on attributes".into())
    } else if found == entries {
        Ok(())
    } else {
        Err(format!("entry points are {found:?}"))
    }
}

#[test]
fn a_fault_is_one_line_with_its_file_and_its_line_there() {
    for (text, line, reason) in [
        (
            "// Ours.\nfn ours() -> f32 { return theirs; }\n",
            2,
            "no definition in scope for identifier: `theirs`",
        ),
        // Valid by its words, and invalid by its types.
        (
            "fn ours() -> f32 { return vec2<f32>(); }\n",
            1,
            "Function [N] 'ours' is invalid: ",
        ),
    ] {
        let fault = Presentation::shader()
            .followed_by("ours.wgsl", text)
            .validate()
            .unwrap_err();
        assert_eq!((&*fault.file, fault.line), ("ours.wgsl", line), "{fault}");
        // naga counts the functions of a text.
        let reason = reason.split("[N]");
        let said = fault.to_string();
        assert!(reason.clone().all(|part| said.contains(part)), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
    }
}

/// The lines of a file below shaders/, if there is such a file.
fn lines_of(file: &str) -> Option<Vec<String>> {
    let path = format!("{}/../../shaders/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).ok()?;
    Some(text.lines().map(str::to_owned).collect())
}

#[test]
fn a_line_of_a_variant_is_found_in_its_file() {
    let mut files: HashMap<String, Option<Vec<String>>> = HashMap::new();
    let mut seen = HashSet::new();
    // One variant of those with the same files is enough.
    for variant in every_variant() {
        if !seen.insert(variant.files()) {
            continue;
        }
        let text = variant.text();
        // A file that is off by a line is so in every line.
        for (index, line) in text.source().lines().enumerate().step_by(10) {
            let (file, number) = text.locate(index + 1);
            let known = files.entry(file.to_owned());
            let Some(lines) = known.or_insert_with(|| lines_of(file)) else {
                assert!(
                    line.starts_with("const ") || line.starts_with("alias "),
                    "only constants and names of types are in no file: {line}"
                );
                continue;
            };
            let in_file = lines.get(number - 1).map(String::as_str);
            // Behind a tilted disk a sky gives its function under another name, and so do the sums of stars
            // and the disk among jets in layers.
            let own_name = match file {
                "sky/tilted.wgsl" | "layers/point_light.wgsl" | "layers/sheet.wgsl" => {
                    line.to_owned()
                }
                _ => line
                    .replace("background_in_hole_frame", "sky_background")
                    .replace("light_of_all_points", "point_light")
                    .replace("add_whole_sheet", "add_sheet"),
            };
            assert_eq!(in_file, Some(own_name.as_str()), "{file}:{number}");
        }
    }
}

/// One dispatch refines all edges, however many there are, and a budget of more steps than the
/// article's could make it take too long.
#[test]
fn edges_are_refined_only_with_the_articles_budget_of_steps() {
    let refines = |method, max_steps| {
        let mut scene = Scene {
            method,
            ..Scene::default()
        };
        scene.quality.max_steps = max_steps;
        Variant::picture(&scene).refined().is_some()
    };
    assert!(refines(Method::Verlet, ARTICLE_MAX_STEPS));
    assert!(!refines(Method::Verlet, ARTICLE_MAX_STEPS + 1));
    assert!(refines(Method::Closed, ARTICLE_MAX_STEPS + 1));
}

#[test]
fn a_shader_contains_only_the_parts_that_its_scene_needs() {
    for variant in every_variant() {
        let source = variant.source();
        let pictures = matches!(
            variant.entry,
            Entry::Picture | Entry::Refine | Entry::TimedLight | Entry::Passages { .. }
        );
        let sky = pictures && variant.sky != SkyMode::Off;
        let thick = variant.medium_nodes > 0;
        assert_eq!(
            source.contains("fn hermite"),
            variant.disk && !thick,
            "{variant:?}"
        );
        assert_eq!(source.contains("fn add_disk"), thick, "{variant:?}");
        let jets = variant.jet_nodes > 0;
        for part in ["fn add_jet", "> jet:", "JET_NODES"] {
            assert_eq!(source.contains(part), jets, "{part} in {variant:?}");
        }
        for part in ["JET_WAVE_ROWS", "struct JetWaves"] {
            assert_eq!(
                source.contains(part),
                variant.knots,
                "{part} in {variant:?}"
            );
        }
        let sheet = jets && variant.disk && !thick;
        assert_eq!(source.contains("fn add_sheet"), sheet, "{variant:?}");
        let through_matter = thick || jets;
        let light = match variant.view {
            View::Colour | View::Unfinished => true,
            // A ray takes samples until the light in front outshines what may be behind.
            View::LightError | View::Samples => through_matter,
            // The disk's light comes with the crossing that dims what is behind it.
            View::Depth => sheet,
            _ => false,
        };
        let stars = matches!(
            variant.entry,
            Entry::Star(StarKernel::Solve | StarKernel::Interpolate)
        );
        let lights_stars = stars || variant.entry == Entry::Star(StarKernel::RefineImage);
        // The lines of the grid have no temperature.
        let thermal_sky = sky && (variant.sky != SkyMode::Grid || variant.reference_star);
        let spectrum = lights_stars || pictures && light && (variant.disk || thermal_sky);
        assert_eq!(
            source.contains("var<uniform> spectrum"),
            spectrum,
            "{variant:?}"
        );
        assert_eq!(
            source.contains("fn shifted_spot_radius"),
            sky,
            "{variant:?}"
        );
        let relativistic = variant.disk_model == DiskModel::PageThorne;
        assert_eq!(
            source.contains("var<uniform> page_thorne"),
            relativistic,
            "{variant:?}"
        );
        assert!(!relativistic || pictures && variant.disk, "{variant:?}");
        // The view `error` shows what the CPU has computed and traces nothing.
        let shows_errors = pictures && variant.view == View::Error;
        // Images of stars are found without rays.
        let shows_nothing = pictures && variant.view.shows_matter() && !through_matter;
        let traces = !shows_errors && !stars && !shows_nothing;
        let trace = traces && !through_matter;
        assert_eq!(source.contains("\nfn trace("), trace, "{variant:?}");
        assert_eq!(
            source.contains("\nfn passage("),
            through_matter,
            "{variant:?}"
        );
        assert_eq!(
            source.contains("var<uniform> errors"),
            shows_errors,
            "{variant:?}"
        );
    }
}

/// The files that a shader has only where the disk has structure, where it has a hot spot, and
/// where something asks when light left.
const LIVING_FILES: [&[&str]; 3] = [
    &["disk/structure/footprint.wgsl", "disk/structure/waves.wgsl"],
    &["disk/hot_spot/spot.wgsl"],
    &["delay/closed.wgsl", "delay/mino.wgsl"],
];

/// The same for pieces of its text.
const LIVING_TEXT: [&[&str]; 3] = [
    &["var<uniform> structure", "MAX_RINGS", "dpdx(", "dpdy("],
    &["var<uniform> hot_spot", "const SHEARED_SPOT: bool = true"],
    &["Nodes", "const DELAY: bool = true"],
];

#[test]
fn a_shader_contains_of_a_living_disk_only_what_its_scene_asks_for() {
    type Change = fn(&mut Scene);
    // Whether the shader has structure, a hot spot, and delays after a change to a smooth disk.
    let changes: [(Change, [bool; 3]); 7] = [
        (|_| {}, [false; 3]),
        (
            |scene| scene.disk.limb = LimbDarkening::ElectronScattering,
            [false; 3],
        ),
        (
            |scene| scene.disk.structure = DiskStructure::Turbulent,
            [true, false, true],
        ),
        (
            |scene| scene.hot_spot.kind = HotSpotKind::Sheared,
            [false, true, true],
        ),
        (|scene| scene.view = View::Delay, [false, false, true]),
        (
            // A view that shows no light has nothing to modulate.
            |scene| {
                scene.disk.structure = DiskStructure::Streaks;
                scene.hot_spot.kind = HotSpotKind::Sheared;
                scene.view = View::Redshift;
            },
            [false; 3],
        ),
        (
            |scene| {
                scene.disk.structure = DiskStructure::Streaks;
                scene.hot_spot.kind = HotSpotKind::Sheared;
                scene.disk.enabled = false;
            },
            [false; 3],
        ),
    ];
    for method in Method::on_gpu() {
        for (change, expected) in changes {
            let mut scene = Scene {
                method,
                ..Scene::default()
            };
            // A sky that is not filtered.
            scene.sky.mode = SkyMode::Procedural;
            change(&mut scene);
            let variant = Variant::picture(&scene);
            let (files, source) = (variant.files(), variant.source());
            // Other methods sum the delay in the file that traces.
            let own_file = match method {
                Method::Mino => Some("delay/mino.wgsl"),
                Method::Closed => Some("delay/closed.wgsl"),
                _ => None,
            };
            for (i, expected) in expected.into_iter().enumerate() {
                for file in LIVING_FILES[i] {
                    let of_method = i < 2 || own_file == Some(file);
                    assert_eq!(
                        files.contains(file),
                        expected && of_method,
                        "{file}: {variant:?}"
                    );
                }
                for text in LIVING_TEXT[i] {
                    assert_eq!(source.contains(text), expected, "{text}: {variant:?}");
                }
            }
            // What is timed is the tracing alone.
            let timed = Variant::timed(&scene);
            for text in LIVING_TEXT.concat() {
                assert!(!timed.source().contains(text), "{text}: {timed:?}");
            }
        }
    }
}

#[test]
fn only_a_structure_with_a_period_counts_its_lives_anew() {
    let mut scene = Scene::default();
    let repeats = |scene: &Scene| {
        let source = Variant::picture(scene).source();
        [true, false].map(|value| source.contains(&format!("const REPEATS: bool = {value};")))
    };
    assert_eq!(repeats(&scene), [false, false]);
    let smooth = Variant::picture(&scene);
    scene.disk.period = 24.0;
    assert_eq!(Variant::picture(&scene), smooth);
    scene.disk.structure = DiskStructure::Turbulent;
    assert_eq!(repeats(&scene), [true, false]);
    scene.disk.period = 0.0;
    assert_eq!(repeats(&scene), [false, true]);
}

#[test]
fn only_delays_around_a_nearly_extremal_hole_go_through_its_throat() {
    let mut scene = Scene::default();
    scene.hot_spot.kind = HotSpotKind::Sheared;
    let throat = |variant: Variant| variant.files().contains(&"delay/closed_kerr_throat.wgsl");
    for (spin, expected) in [(0.99, false), (0.9999, true), (-0.9999, true)] {
        scene.hole.spin = spin;
        assert_eq!(throat(Variant::picture(&scene)), expected, "spin {spin}");
        assert_eq!(throat(Variant::rays(&scene)), expected, "spin {spin}");
        assert!(!throat(Variant::timed(&scene)), "spin {spin}");
    }
    scene.disk.enabled = false;
    assert!(!throat(Variant::picture(&scene)) && !throat(Variant::rays(&scene)));
    scene.disk.enabled = true;
    // The same shader as that of any other hole that spins.
    scene.hot_spot.kind = HotSpotKind::None;
    let extremal = Variant::picture(&scene);
    scene.hole.spin = 0.5;
    assert_eq!(extremal, Variant::picture(&scene));
}
