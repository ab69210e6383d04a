//! Which frames are drawn: the picture is never stale after a change, nothing is drawn without a
//! change, and passes that are switched off do not run.

use super::preset;
use glam::UVec2;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{DiskModel, Method, ObserverKind, Scene, SkyMode, View};
use lightfall_picture::{PassTime, Studio, render};
use lightfall_render::{Chain, EMPTY_PASSES};

const SIZE: UVec2 = UVec2::new(160, 90);

/// A small picture with all effects: disk, stars, bloom, cells and probe.
fn small() -> Scene {
    let mut scene = preset(6);
    scene.picture.automatic_exposure = false;
    (scene.picture.width, scene.picture.height) = SIZE.into();
    (scene.picture.grid_width, scene.picture.grid_height) = (80, 45);
    scene
}

/// Changes of the numbers that a pass is given, one of each kind: no pipeline has to be made for
/// them.
const OF_NUMBERS: [(&str, fn(&mut Scene)); 21] = [
    ("camera.r", |scene| scene.camera.r = 15.5),
    ("camera.phi_deg", |scene| scene.camera.phi_deg = 2.0),
    ("camera.yaw_deg", |scene| scene.camera.yaw_deg = 3.0),
    ("camera.roll_deg", |scene| scene.camera.roll_deg = 10.0),
    ("camera.fov_deg", |scene| scene.camera.fov_deg = 50.0),
    ("observer.kind", |scene| {
        scene.observer.kind = ObserverKind::Rain
    }),
    ("observer.velocity", |scene| {
        scene.observer.velocity = [0.0, 0.0, 0.3]
    }),
    ("disk.inner", |scene| scene.disk.inner = 4.0),
    ("disk.temperature_k", |scene| {
        scene.disk.temperature_k = 5000.0
    }),
    ("disk.brightness", |scene| scene.disk.brightness = 3.0),
    ("sky.ra_deg", |scene| scene.sky.ra_deg = 90.0),
    ("sky.magnitude_limit", |scene| {
        scene.sky.magnitude_limit = 2.0
    }),
    ("sky.brightness", |scene| scene.sky.brightness = 4.0),
    ("probe.phi_deg", |scene| scene.probe.phi_deg = 0.0),
    ("probe.size", |scene| scene.probe.size = 0.5),
    ("picture.exposure_ev", |scene| {
        scene.picture.exposure_ev = 3.0
    }),
    ("picture.bloom", |scene| scene.picture.bloom = 0.5),
    ("picture.levels", |scene| scene.picture.levels = 5),
    ("picture.dither", |scene| scene.picture.dither = false),
    ("picture.grid_width", |scene| scene.picture.grid_width = 40),
    ("picture.width", |scene| {
        (scene.picture.width, scene.picture.height) = (320, 180)
    }),
];

/// Changes for which a pipeline is made when they are asked for first.
const OF_PIPELINES: [(&str, fn(&mut Scene)); 11] = [
    ("hole.spin", |scene| scene.hole.spin = 0.9),
    ("method", |scene| scene.method = Method::Verlet),
    ("view", |scene| scene.view = View::Order),
    ("view, of errors", |scene| scene.view = View::Error),
    ("effects.lensing", |scene| scene.effects.lensing = false),
    ("disk.enabled", |scene| scene.disk.enabled = false),
    ("disk.model", |scene| {
        scene.disk.model = DiskModel::PageThorne
    }),
    ("disk.edge_taper", |scene| scene.disk.edge_taper = 0.0),
    ("sky.mode", |scene| scene.sky.mode = SkyMode::Grid),
    ("picture.bypass", |scene| scene.picture.bypass = true),
    ("picture.antialias", |scene| scene.picture.antialias = false),
];

fn changed(change: fn(&mut Scene)) -> Scene {
    let mut scene = small();
    change(&mut scene);
    scene
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_frame_after_a_change_is_the_changed_scene() {
    assert_next_frames(&small(), &OF_NUMBERS);
    // Real stars have a seed only where a picture shows fainter ones than the catalogue has.
    let mut procedural = small();
    procedural.sky.mode = SkyMode::Procedural;
    assert_next_frames(&procedural, &[("sky.seed", |scene| scene.sky.seed = 7)]);
    // Returning light is known for relativistic disks from the innermost stable orbit on.
    let mut relativistic = small();
    (relativistic.hole.spin, relativistic.disk.follow_isco) = (0.998, true);
    relativistic.disk.model = DiskModel::PageThorne;
    assert_next_frames(
        &relativistic,
        &[("disk.returning", |scene| scene.disk.returning = true)],
    );
}

/// A chain of passes that begins with every change that can be made with those before it. A number
/// that the chain of a test keeps by mistake is another one there.
fn other_studio(base: &Scene, changes: &[(&str, fn(&mut Scene))]) -> Studio {
    let mut all = base.clone();
    for (_, change) in changes {
        let mut next = all.clone();
        change(&mut next);
        if Drawable::new(next.clone()).is_ok() {
            all = next;
        }
    }
    let mut studio = Studio::open(&all, SIZE).unwrap();
    studio.settle().unwrap();
    studio
}

/// The picture of a scene by a chain that has drawn others.
fn settled(studio: &mut Studio, scene: &Scene) -> Vec<u8> {
    studio.show(scene).unwrap();
    studio.settle().unwrap();
    studio.picture().unwrap().rgb
}

/// Asserts that each of these changes shows in the next frame, and so does its end.
fn assert_next_frames(base: &Scene, changes: &[(&str, fn(&mut Scene))]) {
    let mut studio = Studio::open(base, SIZE).unwrap();
    let kept = studio.picture().unwrap().rgb;
    let mut other = other_studio(base, changes);
    for (what, change) in changes {
        let mut scene = base.clone();
        change(&mut scene);
        let fresh = settled(&mut other, &scene);
        assert!(fresh != kept, "{what} changes nothing, so it tests nothing");
        studio.show(&scene).unwrap();
        assert!(
            studio.picture().unwrap().rgb == fresh,
            "{what}: the next frame is not the changed scene's"
        );
        studio.settle().unwrap();
        studio.show(base).unwrap();
        assert!(
            studio.picture().unwrap().rgb == kept,
            "{what}: the next frame is not the scene's before the change"
        );
        studio.settle().unwrap();
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_change_that_needs_a_new_pipeline_keeps_the_old_picture_until_it_is_compiled_and_shows_at_once_the_second_time()
 {
    let base = small();
    let mut studio = Studio::open(&base, SIZE).unwrap();
    let kept = studio.picture().unwrap().rgb;
    let mut other = other_studio(&base, &OF_PIPELINES);
    for (what, change) in OF_PIPELINES {
        let scene = changed(change);
        let fresh = settled(&mut other, &scene);
        assert!(fresh != kept, "{what} changes nothing, so it tests nothing");
        studio.show(&scene).unwrap();
        // The screen's own stages are compiled apart and may need a frame in which they draw
        // nothing.
        let next = studio.picture().unwrap().rgb;
        assert!(
            what == "picture.bypass" || next == kept || next == fresh,
            "{what}: neither the old scene nor the new"
        );
        studio.settle().unwrap();
        assert!(
            studio.picture().unwrap().rgb == fresh,
            "{what}: a settled scene is not the fresh one"
        );
        studio.show(&base).unwrap();
        assert!(studio.picture().unwrap().rgb == kept, "{what}: going back");
        studio.settle().unwrap();
        studio.show(&scene).unwrap();
        assert!(
            studio.picture().unwrap().rgb == fresh,
            "{what}: the second time"
        );
        studio.settle().unwrap();
        studio.show(&base).unwrap();
        studio.settle().unwrap();
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn a_probe_that_appears_after_a_long_rest_is_complete_and_disappears_again() {
    let (with, mut without) = (small(), small());
    without.probe.enabled = false;
    let mut studio = Studio::open(&without, SIZE).unwrap();
    let bare = render(&without, SIZE).unwrap().rgb;
    let whole = render(&with, SIZE).unwrap().rgb;
    for _ in 0..2 {
        for (scene, fresh) in [(&with, &whole), (&without, &bare)] {
            studio.show(scene).unwrap();
            studio.settle().unwrap();
            assert!(
                studio.picture().unwrap().rgb == *fresh,
                "probe {}",
                scene.probe.enabled
            );
            // A rest of many frames, in which Bevy drops the scene camera's textures.
            studio.time(5).unwrap();
        }
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn scenes_with_more_variants_than_are_kept_are_all_drawn_correctly() {
    let mut base = small();
    base.probe.enabled = false;
    base.sky.reference_star = true;
    let mut studio = Studio::open(&base, SIZE).unwrap();
    let first = studio.picture().unwrap().rgb;
    let mut scenes = Vec::new();
    for set in 0..32 {
        for mode in [SkyMode::Grid, SkyMode::Off] {
            let mut scene = base.clone();
            scene.sky.mode = mode;
            let on = |effect: u32| set >> effect & 1 == 1;
            let effects = &mut scene.effects;
            (effects.lensing, effects.doppler, effects.beaming) = (on(0), on(1), on(2));
            (effects.gravitational_shift, effects.aberration) = (on(3), on(4));
            scenes.push(scene);
        }
    }
    for scene in &scenes {
        studio.show(scene).unwrap();
        studio.settle().unwrap();
    }
    // Their places have been taken meanwhile.
    for scene in [&scenes[0], &scenes[63]] {
        studio.show(scene).unwrap();
        studio.settle().unwrap();
        assert!(studio.picture().unwrap().rgb == render(scene, SIZE).unwrap().rgb);
    }
    studio.show(&base).unwrap();
    studio.settle().unwrap();
    assert!(studio.picture().unwrap().rgb == first);
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_passes_that_run_are_those_that_the_chain_names_and_a_still_frame_traces_nothing() {
    let scenes: [(&str, fn(&mut Scene)); 5] = [
        ("everything", |_| {}),
        ("without probe", |scene| scene.probe.enabled = false),
        ("without bloom", |scene| scene.picture.bloom = 0.0),
        ("without cells", |scene| scene.picture.bypass = true),
        ("without any of these", |scene| {
            scene.probe.enabled = false;
            scene.picture.bloom = 0.0;
            scene.picture.bypass = true;
        }),
    ];
    let mut studio = Studio::open(&small(), SIZE).unwrap();
    for (what, change) in scenes {
        let scene = changed(change);
        studio.show(&scene).unwrap();
        studio.settle().unwrap();
        let times = studio.time(5).unwrap();
        if times.is_empty() {
            println!("skipped: the device has no timestamps");
            return;
        }
        let sorted = |mut names: Vec<String>| {
            names.retain(|name| !EMPTY_PASSES.contains(&name.as_str()));
            names.sort();
            names
        };
        let ran = |time: fn(&PassTime) -> f64| {
            sorted(
                times
                    .iter()
                    .filter(|pass| time(pass) > 0.0)
                    .map(|pass| pass.pass.clone())
                    .collect(),
            )
        };
        let chain = Chain::of(&scene);
        let named = |names: &[&str]| sorted(names.iter().map(ToString::to_string).collect());
        assert_eq!(
            ran(|pass| pass.median_ms),
            named(&chain.passes()),
            "{what}, drawn"
        );
        assert_eq!(
            ran(|pass| pass.kept_ms),
            named(chain.idle_passes()),
            "{what}, kept"
        );
    }
}

#[test]
#[ignore = "needs a graphics adapter"]
fn the_error_map_is_computed_again_when_rays_change_but_not_when_only_light_changes() {
    let mut scene = small();
    (scene.view, scene.method, scene.probe.enabled) = (View::Error, Method::Verlet, false);
    let mut studio = Studio::open(&scene, SIZE).unwrap();
    let first = studio.picture().unwrap().rgb;
    // Marks show no light of the disk and of the sky.
    (scene.disk.temperature_k, scene.sky.mode) = (9000.0, SkyMode::Off);
    studio.show(&scene).unwrap();
    assert!(
        studio.picture().unwrap().rgb == first,
        "light changed the errors"
    );
    studio.settle().unwrap();
    scene.camera.r = 30.0;
    studio.show(&scene).unwrap();
    let moved = studio.picture().unwrap().rgb;
    assert!(moved != first, "the errors of another place are the same");
    assert!(
        moved == render(&scene, SIZE).unwrap().rgb,
        "the next frame is not the moved scene's"
    );
    studio.settle().unwrap();
    scene.quality.step_scale = 0.5;
    studio.show(&scene).unwrap();
    assert!(
        studio.picture().unwrap().rgb == render(&scene, SIZE).unwrap().rgb,
        "the errors of other steps"
    );
}
