//! docs/SCENES.md.

use crate::timings::{Machine, Passes, by_machine, compared, sources};

const GEODESIC: Passes = &["geodesic"];
const EDGES: Passes = &["geodesic", "edges", "refine"];
const CELLS: Passes = &["pixelate", "expand", "fit"];
const PROBE: Passes = &["main_opaque_pass_3d", "clustering"];

pub fn table(name: &str) -> Result<String, String> {
    match name {
        "omissions" => omissions(),
        "timings" => sources(),
        _ => Err(format!("nothing renders table {name}")),
    }
}

fn omissions() -> Result<String, String> {
    let left_out = |with: &'static str, without: &'static str, passes: Passes| {
        move |machine: &Machine| {
            compared(machine.drawn(with, passes), machine.drawn(without, passes))
        }
    };
    let kept =
        |machine: &Machine| compared(machine.drawn("smooth", &[]), machine.kept("smooth", &[]));
    by_machine(
        "left out",
        ["ms with", "without", "times"],
        &[
            (
                "the whole picture, in a frame in which nothing changed",
                &kept,
            ),
            (
                "disk, under stars",
                &left_out("smooth", "no disk", GEODESIC),
            ),
            (
                "disk, under the grid",
                &left_out("grid", "grid, no disk", GEODESIC),
            ),
            (
                "disk, with no sky: nothing is traced",
                &left_out("no sky", "no sky, no disk", GEODESIC),
            ),
            (
                "sky: stars and Milky Way",
                &left_out("smooth", "no sky", GEODESIC),
            ),
            ("spin", &left_out("spin", "smooth", GEODESIC)),
            (
                "bloom, with 7 levels of texture",
                &left_out("smooth", "no bloom", &["bloom"]),
            ),
            (
                "smooth edges",
                &left_out("smooth", "no smooth edges", EDGES),
            ),
            (
                "structure of the disk, with the delays that it needs",
                &left_out("structure", "smooth", GEODESIC),
            ),
            ("limb darkening", &left_out("limb", "smooth", GEODESIC)),
            ("cells", &left_out("smooth", "no cells", CELLS)),
            ("probe and lamps", &left_out("probe", "no probe", PROBE)),
        ],
    )
}
