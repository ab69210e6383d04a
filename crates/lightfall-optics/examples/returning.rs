//! Computes the table of light that returns to the disk, and writes it to standard output, in some
//! minutes:
//!
//!     cargo run -p lightfall-optics --release --example returning > returning.csv
//!
//! The program reads it as assets/disk/returning.csv.

use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::observer::ObserverError;
use lightfall_model::scene::LimbDarkening;
use lightfall_optics::disk::PageThorne;
use lightfall_optics::disk::returning::{Return, Sampling};
use lightfall_optics::disk::returning_table::{DEPTHS, spins};
use rayon::prelude::*;

/// Half as many nodes or azimuths change the light by 0.5 % around a fast hole. Without spin, where it
/// is faint, they change it by 3 % near the edge.
const SAMPLING: Sampling = Sampling {
    nodes: 64,
    azimuths: 128,
};

/// What returns once more is less than half of what returned before, even around the fastest hole.
const ORDERS: u32 = 60;

fn main() -> Result<(), ObserverError> {
    let returns = spins()
        .into_par_iter()
        .map(|spin| {
            let disk = PageThorne::new(spin, Kerr { spin }.isco());
            Return::on_disk(&disk, LimbDarkening::ALL, SAMPLING)
        })
        .collect::<Result<Vec<_>, _>>()?;
    println!(
        "# Light that falls back on the disk, over 3 G M Mdot / (8 pi r^3), for a limb law and a spin"
    );
    println!(
        "# (rows) at radii r/r_in (columns). Made by crates/lightfall-optics/examples/returning.rs."
    );
    let radii = DEPTHS.nodes.map(|depth| (1.0 - depth).powi(-2));
    println!("limb,spin{}", listed(radii));
    for (i, law) in LimbDarkening::WORDS.into_iter().enumerate() {
        for (spin, returns) in spins().into_iter().zip(&returns) {
            println!("{law},{spin:.8}{}", listed(returns[i].light(ORDERS)));
        }
    }
    Ok(())
}

fn listed(numbers: impl IntoIterator<Item = f64>) -> String {
    let number = |number| format!(",{number:.4e}");
    numbers.into_iter().map(number).collect()
}
