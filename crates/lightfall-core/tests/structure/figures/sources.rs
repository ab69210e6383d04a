//! The list of each report's sources, in the core's build script, has the shaders that the report runs.

use crate::root;
use lightfall_core::gpu::Variant;
use lightfall_core::reports::bench::{BenchScene, methods_for, scenes};
use lightfall_core::reports::sources::Sources;
use lightfall_core::scene::Scene;

/// The shaders that a report runs for a scene.
type Shaders = fn(&Scene) -> Vec<Variant>;

#[test]
fn every_file_that_a_reports_shaders_are_joined_from_is_one_of_its_sources() {
    let rays: Shaders = |scene| vec![Variant::rays(scene)];
    let timed: Shaders = |scene| vec![Variant::rays(scene), Variant::timed(scene)];
    let light: Shaders = |scene| vec![Variant::timed_light(scene)];
    let picture: Shaders = |scene| {
        let picture = Variant::picture(scene);
        [picture].into_iter().chain(picture.refined()).collect()
    };
    for (report, shaders) in [
        ("bench", timed),
        ("refine", rays),
        ("delay", timed),
        ("light", light),
        ("pictures", picture),
        ("extremes", rays),
        ("grid", rays),
        ("delays", rays),
        ("hunt", rays),
        ("timings", picture),
    ] {
        let files = Sources::of(report).expect("the report exists").files;
        for BenchScene { scene, .. } in scenes() {
            for method in methods_for(&scene) {
                let scene = Scene {
                    method,
                    ..scene.clone()
                };
                for file in shaders(&scene).into_iter().flat_map(Variant::files) {
                    let path = format!("shaders/{file}");
                    assert!(files.contains(&path.as_str()), "{report}: {path}");
                }
            }
        }
    }
}

#[test]
fn the_sources_of_reports_exist_and_reports_of_other_sources_have_other_fingerprints() {
    for report in Sources::reports() {
        let sources = Sources::of(report).expect("a listed report");
        assert_eq!(sources.fingerprint.len(), 8, "{report}");
        for file in sources.files {
            assert!(root().join(file).is_file(), "{report}: {file}");
        }
    }
    let fingerprint = |report| Sources::of(report).map(|sources| sources.fingerprint);
    assert_eq!(fingerprint("extremes"), fingerprint("grid"));
    assert_ne!(fingerprint("extremes"), fingerprint("bench"));
    assert_eq!(fingerprint("nothing"), None);
}
