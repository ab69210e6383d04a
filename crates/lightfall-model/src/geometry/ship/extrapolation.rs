//! The extrapolated midpoint method.

/// Maximum number of rows of a tableau.
pub(super) const MAX_ROWS: usize = 6;

/// Minimum number of rows: with fewer, two entries of a row may agree by chance.
const MIN_ROWS: usize = 3;

/// A step that converged.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step<const N: usize> {
    /// Where it leads: the last entry of the last row.
    pub(super) end: [f64; N],
    /// Its difference from the entry before it, of two orders less.
    pub(super) difference: [f64; N],
    /// How many rows it took.
    pub(super) rows: usize,
}

/// How often a tableau of so many rows evaluates the derivative: once at the start, and n times for
/// each row.
pub(super) fn evaluations(rows: usize) -> u64 {
    let rows = rows as u64;
    1 + rows * (rows + 1)
}

/// A step of the length `length` from `start`: Gragg's modified midpoint method with 2, 4, ... 12
/// substeps, extrapolated to infinitely many in h^2 (Bulirsch & Stoer 1966; Hairer, Norsett &
/// Wanner 1993, section II.9). Rows are added until the last two entries of one agree for
/// `agree(last, before)`. `None` if those of the last row do not.
pub(super) fn step<const N: usize>(
    start: &[f64; N],
    length: f64,
    rate: impl Fn(&[f64; N]) -> [f64; N],
    agree: impl Fn(&[f64; N], &[f64; N]) -> bool,
) -> Option<Step<N>> {
    let first = rate(start);
    // The row before: entry j of the row after n substeps is of the order 2 j + 2.
    let mut last_row = [[0.0; N]; MAX_ROWS];
    for row in 0..MAX_ROWS {
        let mut entry = midpoint(start, &first, length, substeps(row), &rate);
        let mut before = entry;
        for (j, older) in last_row.iter_mut().enumerate().take(row) {
            before = entry;
            let ratio = substeps(row) as f64 / substeps(row - j - 1) as f64;
            let weight = 1.0 / (ratio * ratio - 1.0);
            let better = std::array::from_fn(|i| entry[i] + weight * (entry[i] - older[i]));
            *older = entry;
            entry = better;
        }
        last_row[row] = entry;
        if row + 1 >= MIN_ROWS && agree(&entry, &before) {
            return Some(Step {
                end: sum(start, &entry),
                difference: std::array::from_fn(|i| (entry[i] - before[i]).abs()),
                rows: row + 1,
            });
        }
    }
    None
}

fn substeps(row: usize) -> usize {
    2 * (row + 1)
}

/// The change in a step of Gragg's modified midpoint method with its last smoothing. It is added up
/// apart from the start, so that rounding is relative to the change.
fn midpoint<const N: usize>(
    start: &[f64; N],
    first: &[f64; N],
    length: f64,
    count: usize,
    rate: &impl Fn(&[f64; N]) -> [f64; N],
) -> [f64; N] {
    let short = length / count as f64;
    let (mut old, mut new) = ([0.0; N], scaled(first, short));
    for _ in 1..count {
        let next = sum(&old, &scaled(&rate(&sum(start, &new)), 2.0 * short));
        (old, new) = (new, next);
    }
    let last = sum(&new, &scaled(&rate(&sum(start, &new)), short));
    scaled(&sum(&old, &last), 0.5)
}

fn sum<const N: usize>(left: &[f64; N], right: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| left[i] + right[i])
}

fn scaled<const N: usize>(numbers: &[f64; N], factor: f64) -> [f64; N] {
    numbers.map(|number| factor * number)
}
