//! What a scene needs, in words: from the variant that is compiled and the chain that runs, and
//! from nothing else.

use super::{Chain, EMPTY_PASSES};
use lightfall_core::gpu::{Entry, Variant};
use lightfall_core::scene::Scene;
use std::collections::BTreeSet;
use std::fmt::Write;

/// What the scene compiles in, leaves out and runs; lines of a name and what it needs.
pub fn cost_report(scene: &Scene) -> String {
    let variant = Variant::picture(scene);
    let chain = Chain::of(scene);
    let (set, unset): (Vec<_>, Vec<_>) = variant.flags().into_iter().partition(|(_, set)| *set);
    let names = |flags: Vec<(&'static str, bool)>| {
        flags.into_iter().map(|(name, _)| name).collect::<Vec<_>>()
    };
    let most = chain_with_everything(&chain);
    let textures = chain.textures();
    let absent = most
        .textures()
        .into_iter()
        .filter(|most| textures.iter().all(|texture| texture.name != most.name));
    let passes = chain.passes();
    let mut text = format!("{}: {}\n", scene.name, scene.title);
    let mut line = |name: &str, what: &[String]| {
        let what = if what.is_empty() {
            "none".into()
        } else {
            what.join(", ")
        };
        writeln!(text, "{name:16} {what}").expect("writing to a string cannot fail");
    };
    let own = |names: Vec<&str>| names.into_iter().map(str::to_owned).collect::<Vec<_>>();
    line(
        "method",
        &[format!(
            "{} (asked for: {})",
            word(variant.tracer),
            word(scene.method)
        )],
    );
    line(
        "disk crossings",
        &[if variant.disk {
            variant.most_hits.to_string()
        } else {
            "none looked for".into()
        }],
    );
    line("flags set", &own(names(set)));
    line("flags not set", &own(names(unset)));
    line("text of shaders", &own(variant.files()));
    line("text left out", &own(left_out(variant)));
    line("passes", &own(passes.clone()));
    line(
        "passes left out",
        &own(most
            .passes()
            .into_iter()
            .filter(|pass| !passes.contains(pass))
            .collect()),
    );
    line("passes, empty", &own(EMPTY_PASSES.to_vec()));
    line("while still", &own(chain.kept_passes().to_vec()));
    let written = |texture: &super::Written| {
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

/// The files that pictures of other scenes are made of, and this one's is not.
fn left_out(variant: Variant) -> Vec<&'static str> {
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

/// The chain with every part that there is; with cells rather than without.
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

/// A variant's name as presets write it.
fn word(name: impl std::fmt::Debug) -> String {
    let mut word = String::new();
    for letter in format!("{name:?}").chars() {
        if letter.is_uppercase() && !word.is_empty() {
            word.push('-');
        }
        word.extend(letter.to_lowercase());
    }
    word
}
