//! The cost report: what the GPU compiles, runs and allocates for a scene. It is derived only from
//! the shader variant and the chain that draw the scene.

use crate::render::chain::{Chain, EMPTY_PASSES, WrittenTexture};
use lightfall_core::gpu::{Entry, Variant};
use lightfall_core::scene::Scene;
use std::collections::BTreeSet;
use std::fmt::Write;

/// The cost report of the scene: one line per topic, first the topic and then what belongs to it.
pub fn cost_report(scene: &Scene) -> String {
    let variant = Variant::picture(scene);
    let chain = Chain::of(scene);
    let (set, unset): (Vec<_>, Vec<_>) = variant.flags().into_iter().partition(|(_, set)| *set);
    let names = |flags: Vec<(&'static str, bool)>| {
        flags.into_iter().map(|(name, _)| name).collect::<Vec<_>>()
    };
    let full = chain_with_everything(&chain);
    let textures = chain.textures();
    let absent = full
        .textures()
        .into_iter()
        .filter(|absent| textures.iter().all(|texture| texture.name != absent.name));
    let passes = chain.passes();
    let mut text = format!("{}: {}\n", scene.name, scene.title);
    let mut line = |topic: &str, items: &[String]| {
        let items = if items.is_empty() {
            "none".into()
        } else {
            items.join(", ")
        };
        writeln!(text, "{topic:16} {items}").expect("writing to a string cannot fail");
    };
    let own = |names: Vec<&str>| names.into_iter().map(str::to_owned).collect::<Vec<_>>();
    line(
        "method",
        &[format!(
            "{} (asked for: {})",
            traced_by(scene),
            scene.method.word()
        )],
    );
    line(
        "disk crossings",
        &[if variant.disk {
            variant.most_hits.to_string()
        } else {
            "none".into()
        }],
    );
    line("flags set", &own(names(set)));
    line("flags not set", &own(names(unset)));
    line("shader files", &own(variant.files()));
    line("files left out", &own(unused_files(variant)));
    line("passes", &own(passes.clone()));
    line(
        "passes left out",
        &own(full
            .passes()
            .into_iter()
            .filter(|pass| !passes.contains(pass))
            .collect()),
    );
    line("passes, empty", &own(EMPTY_PASSES.to_vec()));
    line("while idle", &own(chain.idle_passes().to_vec()));
    let written = |texture: &WrittenTexture| {
        let levels = if texture.levels > 1 {
            format!(", {} levels", texture.levels)
        } else {
            String::new()
        };
        format!(
            "{} {}x{} {}{levels}",
            texture.name, texture.size.x, texture.size.y, texture.format
        )
    };
    line(
        "textures",
        &textures.iter().map(written).collect::<Vec<_>>(),
    );
    line(
        "not allocated",
        &own(absent.map(|texture| texture.name).collect()),
    );
    text
}

/// Shader files that pictures of other scenes use and this one does not.
fn unused_files(variant: Variant) -> Vec<&'static str> {
    let all: BTreeSet<_> = Variant::all()
        .into_iter()
        .filter(|other| other.entry == Entry::Picture)
        .flat_map(Variant::files)
        .collect();
    let used = variant.files();
    all.into_iter()
        .filter(|file| !used.contains(file))
        .collect()
}

/// The chain of the same picture size with every optional part, presented in cells.
fn chain_with_everything(chain: &Chain) -> Chain {
    let mut scene = Scene::default();
    scene.probe.enabled = true;
    scene.picture.bypass = false;
    scene.picture.bloom = 1.0;
    Chain {
        picture: chain.picture,
        ..Chain::of(&scene)
    }
}

/// The word of the method that traces the scene; without lensing, what takes its place.
fn traced_by(scene: &Scene) -> &'static str {
    if scene.effects.lensing {
        scene.method.resolved(scene.hole.spin).word()
    } else {
        "straight"
    }
}
