//! The cost report: what the GPU compiles, runs and allocates for a scene. It is derived only from
//! the shader variant and the chain that draw the scene.

use crate::chain::{Chain, EMPTY_PASSES, WrittenTexture};
use crate::detail_limits::DetailLimits;
use crate::resting_frames::FRAMES_AT_REST;
use lightfall_core::gpu::Variant;
use lightfall_core::gpu::stars::{StarKernel, sums_size};
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::stars::{Depth, MAX_MAGNITUDE};
use lightfall_core::scene::{HotSpotKind, LimbDarkening, Scene};
use std::collections::BTreeSet;
use wgpu::DeviceType;

/// The cost report of the scene as text: its name, then one line per topic.
pub fn cost_report(scene: &Scene) -> String {
    let rows = cost_rows(scene, DetailLimits::default());
    let lines = rows
        .iter()
        .map(|(topic, items)| format!("{topic:16} {items}\n"));
    format!("{}: {}\n", scene.name, scene.title) + &lines.collect::<String>()
}

/// The cost report of the scene as rows: a topic, and what belongs to it. The rows depend on the
/// scene's method, its view, its disk without the clock, its [`Variant`] and its [`Chain`], and on
/// how many waves are drawn, and on nothing else.
pub fn cost_rows(scene: &Scene, limits: DetailLimits) -> Vec<(&'static str, String)> {
    let variant = Variant::picture(scene);
    let chain = Chain::of(scene);
    let flags = |set: bool| {
        let flags = variant.flags().into_iter();
        flags.filter_map(move |(name, is_set)| (is_set == set).then_some(name))
    };
    let full = chain_with_everything(&chain);
    let (passes, textures) = (chain.passes(), chain.textures());
    let absent_passes = full.passes().into_iter();
    let absent_passes = absent_passes.filter(|pass| !passes.contains(pass));
    let absent_textures = full.textures().into_iter().map(|texture| texture.name);
    let absent_textures =
        absent_textures.filter(|absent| textures.iter().all(|texture| texture.name != *absent));
    let size = chain.picture;
    let cells = chain.cells.map_or("no cells".into(), |grid| {
        format!("{}x{} cells", grid.x, grid.y)
    });
    let (traced_by, asked_for) = (traced_by(scene), scene.method.word());
    vec![
        row("picture", [format!("{}x{} pixels", size.x, size.y), cells]),
        row("method", [format!("{traced_by} (asked for: {asked_for})")]),
        row("disk crossings", variant.disk.then_some(variant.max_hits)),
        row("edges", [edges(&chain)]),
        row("frames averaged", [frames(&chain)]),
        row("disk's light", lights(scene, variant, limits)),
        row("disk's clock", [clock(scene)]),
        row("stars", stars(scene, chain)),
        row("star kernels", star_kernels(scene, chain)),
        row("star files", star_files(scene, chain)),
        row("flags set", flags(true)),
        row("flags not set", flags(false)),
        row("shader files", variant.files()),
        row("files left out", unused_files(variant)),
        row("passes", &passes),
        row("passes left out", absent_passes),
        row("passes, empty", EMPTY_PASSES),
        row("while idle", chain.idle_passes()),
        row("textures", textures.iter().map(texture_in_words)),
        row("not allocated", absent_textures),
    ]
}

/// A topic and its items.
fn row(topic: &'static str, items: impl IntoIterator<Item: ToString>) -> (&'static str, String) {
    let items: Vec<_> = items.into_iter().map(|item| item.to_string()).collect();
    if items.is_empty() {
        return (topic, "none".into());
    }
    (topic, items.join(", "))
}

fn texture_in_words(texture: &WrittenTexture) -> String {
    let WrittenTexture {
        name,
        size,
        format,
        levels,
    } = texture;
    let levels = match levels {
        1 => String::new(),
        levels => format!(", {levels} levels"),
    };
    format!("{name} {}x{} {format}{levels}", size.x, size.y)
}

/// The parts of the disk's light beside its flux.
fn lights(scene: &Scene, variant: Variant, limits: DetailLimits) -> Vec<String> {
    let mut lights = Vec::new();
    if variant.structure {
        let (waves, drawn) = (scene.disk.waves, limits.drawn_waves(scene.disk.waves));
        let fewer = match limits.waves {
            None => {
                let least = DetailLimits::of_window(DeviceType::Cpu).drawn_waves(waves);
                if least < waves {
                    format!(" ({least} in a window on a software renderer)")
                } else {
                    String::new()
                }
            }
            _ if drawn < waves => {
                format!(" of {waves}, the most in a window on a software renderer")
            }
            _ => String::new(),
        };
        lights.push(format!(
            "structure {} of {drawn} waves a ring{fewer}",
            scene.disk.structure.word()
        ));
    }
    if variant.hot_spot != HotSpotKind::None {
        lights.push(format!("hot spot, {}", variant.hot_spot.word()));
    }
    if variant.limb != LimbDarkening::None {
        lights.push(format!("limb darkening, {}", variant.limb.word()));
    }
    if variant.delay_nodes > 0 {
        lights.push(format!(
            "delay of the light by {} nodes a stretch",
            variant.delay_nodes
        ));
    }
    lights
}

/// How deep the point stars go, and what they take.
fn stars(scene: &Scene, chain: Chain) -> Vec<String> {
    let Some(depth) = Depth::new(scene, MAX_MAGNITUDE)
        .ok()
        .filter(|_| chain.stars)
    else {
        return Vec::new();
    };
    let sums = sums_size(chain.picture) as f64 / 1e6;
    vec![
        format!("points down to V = {:.1}", depth.limit),
        format!("of stars down to V = {:.1}", depth.last),
        format!("{sums:.1} MB of sums"),
    ]
}

/// The kernels of the star pass, in the order in which they run.
fn star_kernels(scene: &Scene, chain: Chain) -> impl Iterator<Item = &'static str> {
    let kernels = StarKernel::of(scene).filter(move |_| chain.stars);
    kernels.map(StarKernel::word)
}

/// The shader files that these kernels have and the picture's shader does not.
fn star_files(scene: &Scene, chain: Chain) -> Vec<String> {
    let picture = Variant::picture(scene).files();
    let kernels = StarKernel::of(scene).filter(|_| chain.stars);
    let mut own = BTreeSet::new();
    for text in kernels.map(|kernel| kernel.text(scene)) {
        let files = text.files().map(|(file, _)| file);
        own.extend(
            files
                .filter(|file| !picture.contains(file))
                .map(str::to_owned),
        );
    }
    own.into_iter().collect()
}

/// How edges are drawn.
fn edges(chain: &Chain) -> &'static str {
    if chain.antialias {
        "4 or 16 rays in each pixel where they pass, 64 where the shadow's edge does"
    } else {
        "one ray a pixel"
    }
}

/// How many frames are averaged.
fn frames(chain: &Chain) -> String {
    let frames = chain.frames;
    if chain.shows_light && frames < FRAMES_AT_REST {
        format!("{frames} ({FRAMES_AT_REST} in a window at rest on a graphics card)")
    } else {
        frames.to_string()
    }
}

/// What the disk's clock makes the window draw.
fn clock(scene: &Scene) -> String {
    if !scene.disk_moves() {
        return "nothing moves: a still picture is kept".into();
    }
    if !scene.shows_disk_motion() {
        return "stands still in this view: a still picture is kept".into();
    }
    if scene.disk.rate == 0.0 {
        return "stands still: a still picture is kept".into();
    }
    format!(
        "{} r_s/c per second: a window draws every frame while it runs; / pauses it",
        four_digits(scene.disk.rate)
    )
}

/// Shader files that pictures of other scenes use and this one does not.
fn unused_files(variant: Variant) -> Vec<&'static str> {
    let used = variant.files();
    let mut files = Variant::files_of_all_pictures();
    files.retain(|file| !used.contains(file));
    files.into_iter().collect()
}

/// The chain of the same picture size with every optional part, presented in cells.
fn chain_with_everything(chain: &Chain) -> Chain {
    let mut scene = Scene::default();
    scene.probe.enabled = true;
    scene.picture.bypass = false;
    scene.picture.bloom = 1.0;
    scene.picture.antialias = true;
    scene.picture.samples = 2;
    Chain {
        picture: chain.picture,
        ..Chain::of(&scene)
    }
}

/// The word of the method that traces the scene; without lensing, what takes its place.
fn traced_by(scene: &Scene) -> &'static str {
    if scene.effects.lensing {
        scene.resolved_method().word()
    } else {
        "straight"
    }
}
