//! docs/PASSES.md.

use crate::render::short;
use crate::timings::{Passes, by_machine};

/// The rows of passes. In the records DEVELOP has the name of the pass of Bevy's before it.
const NAMED: &[(&str, Passes)] = &[
    ("geodesic", GEODESIC),
    ("stars", &["stars"]),
    ("edges", &["edges"]),
    ("refine", &["refine"]),
    ("bloom", &["bloom"]),
    ("develop, or tonemapping", &["develop", "tonemapping"]),
    ("pixelate", &["pixelate"]),
    ("expand", &["expand"]),
    ("upscaling", &["upscaling"]),
];
const GEODESIC: Passes = &["geodesic"];

pub fn passes() -> Result<String, String> {
    let named = NAMED.iter().map(|(row, passes)| (*row, Some(*passes)));
    let rest = [
        ("everything else in Bevy", None),
        ("**all**", Some(&[][..])),
    ];
    let rows: Vec<(&str, Option<Passes>)> = named.chain(rest).collect();
    let columns = ["no spin", "spin 0.9", "preset 2"];
    by_machine("pass, ms", columns, &rows, |machine, passes| {
        let views = ["smooth", "spin", "preset 2"];
        views.map(|view| match passes {
            Some(passes) => short(machine.drawn(view, passes)),
            None => short(machine.others(view, NAMED)),
        })
    })
}

/// The geodesic pass by each method.
pub fn methods() -> Result<String, String> {
    let rows = [
        ("`closed`", ["smooth", "spin"]),
        ("`mino`", ["smooth, mino", "spin, mino"]),
        ("`verlet`", ["smooth, verlet", ""]),
    ];
    let columns = ["no spin", "spin 0.9"];
    by_machine("geodesic pass, ms", columns, &rows, |machine, views| {
        views.map(|view| match view {
            "" => String::new(),
            _ => short(machine.drawn(view, GEODESIC)),
        })
    })
}

/// The geodesic pass with each part of a living disk.
pub fn living() -> Result<String, String> {
    let rows = [
        ("a smooth disk", "smooth"),
        ("limb darkening", "limb"),
        ("structure, with the delays that it needs", "structure"),
        ("both: preset 2 without spin", "living"),
        ("preset 2", "preset 2"),
        ("preset 2, by `mino`", "preset 2, mino"),
    ];
    by_machine("geodesic pass, with", ["ms"], &rows, |machine, view| {
        [short(machine.drawn(view, GEODESIC))]
    })
}
