//! docs/EXTREMES.md.

use crate::measured::{files, measured};
use crate::render::{count, largest, median, ratio, short, table as markdown};
use lightfall_lab::extremes::{CellDelays, HuntRow, MatterVerdict, Verdict, matter_table};
use lightfall_lab::import::Report;

/// The methods of the matrix, as its rows name them. The first three answer every ray.
const METHODS: [&str; 5] = ["closed", "mino", "mino, tightest", "verlet", "kerr-schild"];
const ANSWERING: usize = 3;

/// The relative error that the median of a cell's hits is to stay below.
const HIT_GOAL: f64 = 1e-5;

/// What the groups of the matrix contain.
const GROUPS: [(&str, &str); 9] = [
    (
        "distance to the critical curve",
        "distance to the critical curve, 1e-1 to 1e-7",
    ),
    ("spin", "spin, 0 to +-0.999999"),
    ("place of the camera", "camera from 1.0001 r_+ to 1e7 r_s"),
    ("axis", "the axis, on it and through it"),
    ("radial", "radial, exactly and almost"),
    (
        "plane of the disk",
        "the plane of the disk, in it and grazing it",
    ),
    (
        "field of view",
        "fields of view from 1e-6 rad to 179 degrees",
    ),
    ("disk", "disks to 1e5 r_s, rings of 1e-6 of their radius"),
    ("observer", "observers up to 0.9999 c, orbits, free fall"),
];

/// What the cells of each method that answers every ray add up to.
pub fn totals() -> Result<String, String> {
    let mesa = measured::<Verdict>("llvmpipe/extremes-closed")?.rows;
    let rows = [
        sums("hard places", &hard_places()?),
        sums("hard places, on Mesa's driver", &mesa),
        sums("grid", &grid()?),
    ];
    Ok(markdown(
        "| cells that hold | rays | given up | not finite | beyond the tolerance | unexplained | \
         largest 99th percentile, rad | largest error | largest of a wrong class",
        rows.concat(),
    ))
}

/// For each group and method: the cells that hold, and the largest error or the rays given up.
pub fn matrix() -> Result<String, String> {
    let rows = hard_places()?;
    Ok(markdown(
        "what is extreme | closed | mino | mino, tightest | verlet | kerr-schild",
        GROUPS.map(|(group, title)| {
            let cell = |method: &str| {
                let mut own = of(&rows, method);
                own.retain(|row| row.group == group);
                let what = match own.iter().map(|row| row.unfinished).sum::<usize>() {
                    0 => worst(&own, |row| row.backward_max),
                    given_up => format!("{given_up} given up"),
                };
                format!("{}, {what}", holding(&own))
            };
            [vec![title.to_owned()], METHODS.map(cell).to_vec()].concat()
        }),
    ))
}

/// The errors of hits in the cells that have some: for each method the middle of the cells' medians and
/// of their 99th percentiles, and the number of cells whose median is above [`HIT_GOAL`].
pub fn hits() -> Result<String, String> {
    let rows = [
        middles("hard places", &hard_places()?),
        middles("grid", &grid()?),
    ];
    Ok(markdown(
        "| cells with hits | middle of the cells' medians: r | g | middle of their 99th percentiles: r | g | \
         cells with a median above 1e-5: r | g",
        rows.concat(),
    ))
}

fn hard_places() -> Result<Vec<Verdict>, String> {
    Ok(measured("h200/extremes")?.rows)
}

fn grid() -> Result<Vec<Verdict>, String> {
    Ok(measured("h200/grid")?.rows)
}

fn of<'a>(rows: &'a [Verdict], method: &str) -> Vec<&'a Verdict> {
    rows.iter().filter(|row| row.method == method).collect()
}

fn total(counts: impl Iterator<Item = usize>) -> String {
    count(counts.sum())
}

fn holding(rows: &[&Verdict]) -> String {
    let holding = rows.iter().filter(|row| row.holds).count();
    format!("{holding}/{}", rows.len())
}

fn worst(rows: &[&Verdict], of: fn(&Verdict) -> f64) -> String {
    short(largest(rows.iter().map(|row| of(row))))
}

fn sums(place: &str, rows: &[Verdict]) -> Vec<Vec<String>> {
    let measured = METHODS[..ANSWERING]
        .iter()
        .map(|method| (method, of(rows, method)));
    measured
        .filter(|(_, own)| !own.is_empty())
        .map(|(method, own)| {
            let sum = |of: fn(&Verdict) -> usize| total(own.iter().map(|row| of(row)));
            vec![
                format!("{place}: {method}"),
                holding(&own),
                sum(|row| row.rays),
                sum(|row| row.unfinished),
                sum(|row| row.not_finite),
                sum(|row| row.beyond),
                sum(|row| row.unexplained),
                worst(&own, |row| row.backward_p99),
                worst(&own, |row| row.backward_max),
                worst(&own, |row| row.misclassified_max),
            ]
        })
        .collect()
}

fn middles(place: &str, rows: &[Verdict]) -> Vec<Vec<String>> {
    let row = |method: &&str| {
        let mut cells = of(rows, method);
        cells.retain(|row| row.hits > 0);
        let medians: [fn(&Verdict) -> f64; 2] = [|row| row.hit_r_p50, |row| row.hit_g_p50];
        let percentiles: [fn(&Verdict) -> f64; 2] = [|row| row.hit_r_p99, |row| row.hit_g_p99];
        let middle = |of: fn(&Verdict) -> f64| short(median(cells.iter().map(|row| of(row))));
        let above = medians.map(|of| cells.iter().filter(|row| of(row) > HIT_GOAL).count());
        let mut columns = vec![format!("{place}: {method}"), count(cells.len())];
        columns.extend(medians.map(middle));
        columns.extend(percentiles.map(middle));
        columns.extend(above.map(count));
        columns
    };
    METHODS[..ANSWERING].iter().map(row).collect()
}

/// The hits of each method, by class.
pub fn delays() -> Result<String, String> {
    let rows = measured::<CellDelays>("llvmpipe/delays")?.rows;
    Ok(markdown(
        "method | hits compared | beyond 1e-3 rad | right for the place found | at a far place | unexplained | \
         rays not compared",
        ["closed", "mino"].map(|method| {
            let sum = |of: fn(&CellDelays) -> usize| {
                total(rows.iter().filter(|row| row.method == method).map(of))
            };
            vec![
                method.to_owned(),
                sum(|row| row.hits),
                sum(|row| row.over),
                sum(|row| row.place),
                sum(|row| row.far),
                sum(|row| row.unexplained),
                sum(|row| row.lost),
            ]
        }),
    ))
}

/// The cells of matter with depth.
pub fn matter() -> Result<String, String> {
    let rows = measured::<MatterVerdict>("llvmpipe/matter")?.rows;
    Ok(matter_table(&rows))
}

/// The rays beyond their tolerance that each hunt found. A file lists its worst scenes, which are
/// those with such rays and some more.
pub fn hunts() -> Result<String, String> {
    let mut rows = Vec::new();
    for folder in ["h200", "llvmpipe"] {
        for file in files(folder, "hunt-")? {
            let hunt: Report<HuntRow> = measured(&file)?;
            let said = |name: &str| hunt.head.get(name).unwrap_or("unknown");
            let sum = |of: fn(&HuntRow) -> usize| total(hunt.rows.iter().map(of));
            let far = hunt.rows.iter().filter(|row| row.rays_beyond > 0);
            let [excess, error] = match far.max_by(|a, b| a.excess.total_cmp(&b.excess)) {
                Some(worst) if worst.excess.is_finite() => {
                    [ratio(worst.excess), short(worst.backward)]
                }
                Some(worst) => [short(worst.excess), short(worst.backward)],
                None => Default::default(),
            };
            let seed = file.rsplit('-').next().unwrap_or_default();
            rows.push(vec![
                format!("[{seed}](bench/{file}.csv)"),
                said("adapter")
                    .split(" (")
                    .next()
                    .unwrap_or_default()
                    .into(),
                said("commit").to_owned(),
                sum(|row| row.rays_beyond),
                sum(|row| row.rays_unexplained),
                excess,
                error,
                sum(|row| row.rays_unanswerable),
            ]);
        }
    }
    Ok(markdown(
        "seed | machine | revision | rays beyond their tolerance | unexplained | largest error over its \
         tolerance | that error, rad | at a ring too narrow for f32",
        rows,
    ))
}
