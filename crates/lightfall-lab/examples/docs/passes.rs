//! docs/PASSES.md.

use crate::render::short;
use crate::timings::{Machine, Passes, by_machine, sources};

/// The passes with a row of their own.
const NAMED: Passes = &[
    "geodesic",
    "stars",
    "edges",
    "refine",
    "bloom",
    "tonemapping",
    "pixelate",
    "expand",
    "upscaling",
];
const GEODESIC: Passes = &["geodesic"];

pub fn table(name: &str) -> Result<String, String> {
    match name {
        "passes" => passes(),
        "methods" => methods(),
        "living" => living(),
        "timings" => sources(),
        _ => Err(format!("nothing renders table {name}")),
    }
}

fn passes() -> Result<String, String> {
    let views = ["smooth", "spin", "preset 2"];
    let of_pass =
        |pass: Passes| move |machine: &Machine| views.map(|view| short(machine.drawn(view, pass)));
    let others = |machine: &Machine| views.map(|view| short(machine.others(view, NAMED)));
    let all = |machine: &Machine| views.map(|view| short(machine.drawn(view, &[])));
    let mut rows: Vec<(&str, &dyn Fn(&Machine) -> [String; 3])> = Vec::new();
    let named: Vec<_> = NAMED
        .chunks(1)
        .map(|pass| (pass[0], of_pass(pass)))
        .collect();
    for (pass, times) in &named {
        rows.push((pass, times));
    }
    rows.push(("everything else in Bevy", &others));
    rows.push(("**all**", &all));
    by_machine("pass, ms", ["no spin", "spin 0.9", "preset 2"], &rows)
}

/// The geodesic pass by each method.
fn methods() -> Result<String, String> {
    let times = |views: [&'static str; 2]| {
        move |machine: &Machine| {
            views.map(|view| match view {
                "" => String::new(),
                _ => short(machine.drawn(view, GEODESIC)),
            })
        }
    };
    by_machine(
        "geodesic pass, ms",
        ["no spin", "spin 0.9"],
        &[
            ("`closed`", &times(["smooth", "spin"])),
            ("`mino`", &times(["smooth, mino", "spin, mino"])),
            ("`verlet`", &times(["smooth, verlet", ""])),
        ],
    )
}

/// The geodesic pass with each part of a living disk.
fn living() -> Result<String, String> {
    let time = |view: &'static str| move |machine: &Machine| [short(machine.drawn(view, GEODESIC))];
    by_machine(
        "geodesic pass, with",
        ["ms"],
        &[
            ("a smooth disk", &time("smooth")),
            ("limb darkening", &time("limb")),
            (
                "structure, with the delays that it needs",
                &time("structure"),
            ),
            ("both: preset 2 without spin", &time("living")),
            ("preset 2", &time("preset 2")),
            ("preset 2, by `mino`", &time("preset 2, mino")),
        ],
    )
}
