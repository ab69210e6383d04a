//! docs/SCENES.md.

use crate::timings::{Passes, by_machine, compared};

const GEODESIC: Passes = &["geodesic"];
const EDGES: Passes = &["geodesic", "edges", "refine"];
const CELLS: Passes = &["pixelate", "expand", "fit"];
const PROBE: Passes = &["main_opaque_pass_3d", "clustering"];

/// The frame of a view that keeps its picture, in place of a view.
const KEPT: &str = "kept";

/// What is left out, with the views that have it and that lack it, and the passes that it takes.
const OMISSIONS: [(&str, ([&str; 2], Passes)); 12] = [
    (
        "the whole picture, in a frame in which nothing changed",
        (["smooth", KEPT], &[]),
    ),
    ("disk, under stars", (["smooth", "no disk"], GEODESIC)),
    (
        "disk, under the grid",
        (["grid", "grid, no disk"], GEODESIC),
    ),
    (
        "disk, with no sky: nothing is traced",
        (["no sky", "no sky, no disk"], GEODESIC),
    ),
    ("sky: stars and Milky Way", (["smooth", "no sky"], GEODESIC)),
    ("spin", (["spin", "smooth"], GEODESIC)),
    (
        "bloom, with 7 levels of texture",
        (["smooth", "no bloom"], &["bloom"]),
    ),
    ("smooth edges", (["smooth", "no smooth edges"], EDGES)),
    (
        "structure of the disk, with the delays that it needs",
        (["structure", "smooth"], GEODESIC),
    ),
    ("limb darkening", (["limb", "smooth"], GEODESIC)),
    ("cells", (["smooth", "no cells"], CELLS)),
    ("probe and lamps", (["probe", "no probe"], PROBE)),
];

pub fn omissions() -> Result<String, String> {
    let columns = ["ms with", "without", "times"];
    by_machine("left out", columns, &OMISSIONS, |machine, row| {
        let ([with, without], passes) = *row;
        let left = match without {
            KEPT => machine.kept(with, passes),
            view => machine.drawn(view, passes),
        };
        compared(machine.drawn(with, passes), left)
    })
}
