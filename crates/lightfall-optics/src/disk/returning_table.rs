//! The table of returning light: for each limb law and twelve spins, its strength at 24 radii of a
//! disk that begins at the innermost stable orbit. It is computed from [`super::returning`].

use lightfall_model::geometry::chebyshev::Chebyshev;
use lightfall_model::scene::LimbDarkening;
use std::sync::LazyLock;

/// Number of radii.
pub const RADII: usize = 24;

/// Number of spins.
pub const SPINS: usize = 12;

/// The largest spin of the table, beyond which returning light is that of this spin.
pub const MAX_SPIN: f64 = 0.9999;

/// Number of limb laws.
const LAWS: usize = LimbDarkening::ALL.len();

/// The table: a comment, a line that names the columns, and a line for each law and spin.
const ASSET: &str = include_str!("../../../../assets/disk/returning.csv");

/// The depths 1 - sqrt(r_in/r) of the table's radii.
pub static DEPTHS: LazyLock<Chebyshev<RADII>> = LazyLock::new(Chebyshev::new);

/// The places of the table's spins between the largest spin (0) and -1 (1), in the cube root of 1 -
/// chi. Close to the largest spin the innermost stable orbit is smooth in this root.
static SPIN_PLACES: LazyLock<Chebyshev<SPINS>> = LazyLock::new(Chebyshev::new);

/// The logarithms of the numbers of the asset.
static LOGARITHMS: LazyLock<[[[f64; RADII]; SPINS]; LAWS]> = LazyLock::new(|| {
    read(ASSET).unwrap_or_else(|fault| panic!("assets/disk/returning.csv: {fault}"))
});

/// Light that falls back on the disk around a hole of one spin, in units of the flux that the disk
/// would have if its torque did not vanish at the inner edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReturningLight {
    /// The values at [`DEPTHS`].
    values: [f64; RADII],
}

impl ReturningLight {
    /// The light that returns to the disk around a hole of spin `spin`, if the surface has this
    /// `limb` law. The logarithm is interpolated between spins, since the light grows a thousandfold
    /// from one end of the table to the other.
    pub fn new(spin: f64, limb: LimbDarkening) -> Self {
        let law = LimbDarkening::ALL.iter().position(|&law| law == limb);
        let rows = &LOGARITHMS[law.unwrap_or_default()];
        let shares = SPIN_PLACES.shares(spin_place(spin));
        let logarithm = |i: usize| -> f64 {
            let column = rows.iter().map(|row| row[i]);
            shares.iter().zip(column).map(|(a, b)| a * b).sum()
        };
        Self {
            values: std::array::from_fn(|i| logarithm(i).exp()),
        }
    }

    /// The light at the depth 1 - sqrt(r_in/r), from 0 at the edge to 1 at infinity.
    pub fn at(&self, depth: f64) -> f64 {
        DEPTHS.value(&self.values, depth)
    }
}

/// The table's spins, from the largest one on.
pub fn spins() -> [f64; SPINS] {
    let [low, high] = root_range();
    SPIN_PLACES
        .nodes
        .map(|place| 1.0 - (low + (high - low) * place).powi(3))
}

fn spin_place(spin: f64) -> f64 {
    let [low, high] = root_range();
    ((1.0 - spin.min(MAX_SPIN)).cbrt() - low) / (high - low)
}

/// The cube roots of 1 - chi between which the table lies.
fn root_range() -> [f64; 2] {
    [(1.0 - MAX_SPIN).cbrt(), 2.0_f64.cbrt()]
}

/// The logarithms of the numbers of a table.
///
/// # Errors
/// One sentence, if a line is not one of the expected law and spin with as many positive numbers as
/// there are radii.
fn read(text: &str) -> Result<[[[f64; RADII]; SPINS]; LAWS], String> {
    let mut table = [[[0.0; RADII]; SPINS]; LAWS];
    let mut lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    for (rows, law) in table.iter_mut().zip(LimbDarkening::WORDS) {
        for (row, spin) in rows.iter_mut().zip(spins()) {
            let begin = format!("{law},{spin:.8},");
            let line = lines.next().unwrap_or_default();
            let numbers = line.strip_prefix(&begin).unwrap_or_default().split(',');
            let logarithms: Vec<f64> = numbers
                .map_while(|number| number.parse().ok())
                .filter(|number| *number > 0.0)
                .map(f64::ln)
                .collect();
            *row = logarithms.try_into().map_err(|_| {
                format!("expected \"{begin}\" and {RADII} positive numbers, found \"{line}\"")
            })?;
        }
    }
    Ok(table)
}
