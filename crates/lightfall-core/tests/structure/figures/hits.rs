//! docs/EXTREMES.md: the errors of hits.

use super::document::{Claim, claim};
use super::extremes::{ANSWERING, METHODS, of};
use super::render::{at_most, count, extent, largest, median, short, table};
use lightfall_core::reports::extremes::Verdict;

/// The relative error that the median of a cell's hits is to stay below.
const HIT_GOAL: f64 = 1e-5;
/// A cell with more hits than this, a fifth of its rays, has many.
const MAX_FEW_HITS: usize = 60;

/// The errors of hits in the cells that have some: for each method the middle of the cells' medians and
/// of their 99th percentiles, and the number of cells whose median is above [`HIT_GOAL`].
pub fn by_method(reports: &[(&str, &[Verdict])]) -> String {
    let row = |report: &str, rows: &[Verdict], method: &str| {
        let mut cells = of(rows, method);
        cells.retain(|row| row.hits > 0);
        let medians: [fn(&Verdict) -> f64; 2] = [|row| row.hit_r_p50, |row| row.hit_g_p50];
        let percentiles: [fn(&Verdict) -> f64; 2] = [|row| row.hit_r_p99, |row| row.hit_g_p99];
        let middle = |of: fn(&Verdict) -> f64| short(median(cells.iter().map(|row| of(row))));
        let above = medians.map(|of| cells.iter().filter(|row| of(row) > HIT_GOAL).count());
        let name = match method.split_once(", ") {
            Some((method, setting)) => format!("`{method}`, {setting}"),
            None => format!("`{method}`"),
        };
        let mut columns = vec![format!("{report}, {name}"), count(cells.len())];
        columns.extend(medians.map(middle));
        columns.extend(percentiles.map(middle));
        columns.extend(above.map(count));
        columns
    };
    let rows = reports.iter().flat_map(|(report, rows)| {
        METHODS[..ANSWERING]
            .iter()
            .map(|method| row(report, rows, method))
    });
    table(
        "| cells with hits | middle of the cells' medians: r | g | middle of their 99th percentiles: r | g | cells \
         with a median above 1e-5: r | g",
        rows,
    )
}

/// The cells in which the median of the hits of `mino` at its own setting is above [`HIT_GOAL`].
pub fn claims(reports: &[&[Verdict]]) -> Vec<Claim> {
    let [closed, mino, tightest] = [METHODS[0], METHODS[1], METHODS[2]];
    let far = reports.iter().flat_map(|rows| {
        let by = |method: &str, cell: &Verdict| {
            let same = |row: &&&Verdict| row.cell == cell.cell && row.group == cell.group;
            of(rows, method)
                .iter()
                .find(same)
                .map_or(f64::NAN, |row| row.hit_r_p50)
        };
        let far = of(rows, mino)
            .into_iter()
            .filter(|cell| cell.hit_r_p50 > HIT_GOAL);
        far.map(move |cell| {
            (
                cell.hits,
                [cell.hit_r_p50, by(closed, cell), by(tightest, cell)],
            )
        })
    });
    let (few, many): (Vec<_>, Vec<_>) = far.partition(|(hits, _)| *hits <= MAX_FEW_HITS);
    let hits = |cells: &[(usize, [f64; 3])]| {
        let [least, most] = extent(cells.iter().map(|(hits, _)| *hits as f64));
        [cells.len(), least as usize, most as usize]
            .map(count)
            .to_vec()
    };
    let medians = |cells: &[(usize, [f64; 3])], i: usize| {
        extent(cells.iter().map(|(_, medians)| medians[i])).map(short)
    };
    let most = |cells: &[(usize, [f64; 3])], i: usize| {
        at_most(largest(cells.iter().map(|(_, medians)| medians[i])))
    };
    vec![
        claim(
            "**Few hits.** In {} cells {} to {} of the 300 rays have a hit",
            hits(&few),
        ),
        claim(
            "The medians are at most {}, where `closed` has at most {}. Every backward error",
            [most(&few, 0), most(&few, 1)],
        ),
        claim(
            "**Many hits.** In the other {} cells {} to {} rays have a hit",
            hits(&many),
        ),
        claim(
            "The medians are {} to {}, where `closed` has at most {} and `mino` at its tightest setting at most {}",
            [
                medians(&many, 0).to_vec(),
                vec![most(&many, 1), most(&many, 2)],
            ]
            .concat(),
        ),
    ]
}
