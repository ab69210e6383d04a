//! docs/EXTREMES.md.

use super::document::{Claim, Figures, claim};
use super::hits;
use super::measured::{files, is_stale, measured};
use super::render::{at_most, bound, count, largest, ratio, short, table};
use lightfall_core::reports::extremes::{CellDelays, HuntRow, Verdict};
use lightfall_core::reports::import::Report;
use lightfall_core::scene::Method;

/// The methods of the matrix, as its rows name them. The first three answer every ray.
pub(super) const METHODS: [&str; 5] = ["closed", "mino", "mino, tightest", "verlet", "kerr-schild"];
pub(super) const ANSWERING: usize = 3;
/// The error below which a cell of `closed` is not listed, in radians.
const LISTED: f64 = 1e-6;

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

pub fn figures() -> Figures {
    let matrix = measured::<Verdict>("h200/extremes").rows;
    let closed = measured::<Verdict>("llvmpipe/extremes-closed").rows;
    let grid = measured::<Verdict>("h200/grid").rows;
    let delays = measured::<CellDelays>("llvmpipe/delays").rows;
    let hunts: Vec<Report<HuntRow>> = ["h200", "llvmpipe"]
        .iter()
        .flat_map(|folder| files(folder, "hunt-"))
        .map(|file| measured(&file))
        .collect();
    let claims = [
        tolerances(),
        of_matrix(&matrix),
        of_closed(&closed),
        of_delays(&delays),
        of_grid(&grid),
        hits::claims(&[&matrix, &grid]),
        of_hunts(&hunts),
    ];
    Figures {
        tables: vec![
            ("matrix", by_group(&matrix)),
            ("matrix-closed", listed(of(&matrix, "closed"))),
            ("closed", listed(of(&closed, "closed"))),
            ("delays", by_class(&delays)),
            ("hunts", by_seed(&hunts)),
            (
                "hits",
                hits::by_method(&[("matrix", &matrix), ("grid", &grid)]),
            ),
        ],
        claims: claims.into_iter().flatten().collect(),
    }
}

pub(super) fn of<'a>(rows: &'a [Verdict], method: &str) -> Vec<&'a Verdict> {
    rows.iter().filter(|row| row.method == method).collect()
}

fn total(counts: impl Iterator<Item = usize>) -> String {
    count(counts.sum())
}

fn holding(rows: &[&Verdict]) -> usize {
    rows.iter().filter(|row| row.holds).count()
}

/// Number of rays beyond their tolerance, and of those whose error is explained.
fn beyond_and_explained(rows: &[&Verdict]) -> Vec<String> {
    let explained = rows.iter().map(|row| row.beyond - row.unexplained);
    vec![total(rows.iter().map(|row| row.beyond)), total(explained)]
}

fn worst(rows: &[&Verdict]) -> f64 {
    largest(rows.iter().map(|row| row.backward_max))
}

fn tolerances() -> Vec<Claim> {
    let tiny = 1e-9;
    let spinning = Method::Closed.backward_max(tiny) - 2e-7;
    vec![claim(
        "{} rad for `closed` without spin, and {} + 2e-7/(r_+ - r_-) rad with spin; for `mino` its own setting in pixels \
         of the scene's picture, but at least {} rad",
        [
            Method::Closed.backward_max(0.0),
            spinning,
            Method::Mino.backward_max(tiny),
        ]
        .map(bound),
    )]
}

/// For each group and method: the cells that hold, and the largest error or the rays given up.
fn by_group(rows: &[Verdict]) -> String {
    table(
        "what is extreme | closed | mino | mino, tightest | verlet | kerr-schild",
        GROUPS.map(|(group, title)| {
            let cell = |method: &str| {
                let mut own = of(rows, method);
                own.retain(|row| row.group == group);
                let given_up: usize = own.iter().map(|row| row.unfinished).sum();
                let what = match given_up {
                    0 => short(worst(&own)),
                    _ => format!("{given_up} given up"),
                };
                format!("{}/{}, {what}", holding(&own), own.len())
            };
            [vec![title.to_owned()], METHODS.map(cell).to_vec()].concat()
        }),
    )
}

/// The cells whose largest error is not below [`LISTED`].
fn listed(rows: Vec<&Verdict>) -> String {
    let far = rows.into_iter().filter(|row| row.backward_max > LISTED);
    table(
        "cell | largest error, rad | tolerance, rad",
        far.map(|row| {
            vec![
                row.cell.clone(),
                format!("{:.2e}", row.backward_max),
                short(row.tolerance),
            ]
        }),
    )
}

fn of_matrix(rows: &[Verdict]) -> Vec<Claim> {
    let closed = of(rows, "closed");
    let answering: Vec<&Verdict> = METHODS[..ANSWERING]
        .iter()
        .flat_map(|method| of(rows, method))
        .collect();
    let near = closed.iter().filter(|row| row.backward_max <= LISTED);
    vec![
        claim(
            "`closed` and `mino`, at both settings, hold {} of their {} cells. They give up {} rays, and {} answers are not finite. \
             Of their rays {} are beyond their tolerance, and roundings explain {} of them",
            [
                vec![
                    count(holding(&answering)),
                    count(answering.len()),
                    total(answering.iter().map(|row| row.unfinished)),
                    total(answering.iter().map(|row| row.not_finite)),
                ],
                beyond_and_explained(&answering),
            ]
            .concat(),
        ),
        claim(
            "In {} of the {} cells every ray of `closed` is within 1e-6 rad. The others are",
            [count(near.count()), count(closed.len())],
        ),
    ]
}

fn of_closed(rows: &[Verdict]) -> Vec<Claim> {
    let near = rows.iter().filter(|row| row.backward_max <= LISTED);
    let rows: Vec<&Verdict> = rows.iter().collect();
    vec![claim(
        "{} rays are given up, {} answers are not finite, {} of the {} cells hold, and in {} every ray is within 1e-6 rad",
        [
            total(rows.iter().map(|row| row.unfinished)),
            total(rows.iter().map(|row| row.not_finite)),
            count(holding(&rows)),
            count(rows.len()),
            count(near.count()),
        ],
    )]
}

/// The hits of each method, by class.
fn by_class(rows: &[CellDelays]) -> String {
    table(
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
    )
}

fn of_delays(rows: &[CellDelays]) -> Vec<Claim> {
    let sum = |of: fn(&CellDelays) -> usize| rows.iter().map(of).sum::<usize>();
    let critical = |of: fn(&CellDelays) -> usize| {
        let near = rows
            .iter()
            .filter(|row| row.group.contains("critical curve"));
        near.map(of).sum::<usize>()
    };
    let (hits, over) = (sum(|row| row.hits), sum(|row| row.over));
    let without_hits = rows.iter().filter(|row| row.hits == 0).count();
    vec![
        claim(
            "So the delays of {} of {} hits are within the bar. The other {}, {} of them in the cells that approach the critical curve",
            [hits - over, hits, over, critical(|row| row.over)].map(count),
        ),
        claim(
            "**Right for the place found, {} hits.**",
            [count(sum(|row| row.place))],
        ),
        claim("**At a far place, {} hits.**", [count(sum(|row| row.far))]),
        claim(
            "**Unexplained, {} hits.**",
            [count(sum(|row| row.unexplained))],
        ),
        claim(
            "within 0.003 of their radius of the reference's place, none is off by more than {} rad for its own place",
            [at_most(largest(
                rows.iter().map(|row| row.turn_at_place_max),
            ))],
        ),
        claim(
            "For {} rays the method has another outcome or number of hits than the reference, so their delays are not compared; \
             {} of them are in the cells that approach the critical curve. {} of the {} rows have no hits",
            [
                sum(|row| row.lost),
                critical(|row| row.lost),
                without_hits,
                rows.len(),
            ]
            .map(count),
        ),
    ]
}

fn of_grid(rows: &[Verdict]) -> Vec<Claim> {
    let [closed, mino, tightest] =
        [METHODS[0], METHODS[1], METHODS[2]].map(|method| of(rows, method));
    let misplaced = |rows: &[&Verdict]| largest(rows.iter().map(|row| row.misclassified_max));
    let p99 = |rows: &[&Verdict]| largest(rows.iter().map(|row| row.backward_p99));
    let counts = |rows: &[&Verdict]| [holding(rows), rows.len()].map(count).to_vec();
    let answering = [&closed[..], &mino, &tightest].concat();
    let near = closed.iter().filter(|row| row.backward_max <= LISTED);
    vec![
        claim(
            "{} of the rays of `closed` and `mino` are given up and {} answers are not finite. Misclassified rays lie within \
             {} rad of where they belong, those of `closed` and of the tightest setting within {}",
            [
                total(answering.iter().map(|row| row.unfinished)),
                total(answering.iter().map(|row| row.not_finite)),
                at_most(misplaced(&answering)),
                at_most(misplaced(&closed).max(misplaced(&tightest))),
            ],
        ),
        claim(
            "`closed`: {} of {} cells hold. The largest error is {} rad, and {} cells are within 1e-6",
            [
                counts(&closed),
                vec![at_most(worst(&closed)), count(near.count())],
            ]
            .concat(),
        ),
        claim(
            "`mino` at its default setting: {} of {} cells hold. The 99th percentile of each is within {} rad, and the largest error is {}",
            [
                counts(&mino),
                vec![at_most(p99(&mino)), at_most(worst(&mino))],
            ]
            .concat(),
        ),
        claim(
            "`mino` at its tightest setting: {} of {} cells hold. The 99th percentile of each is within {}",
            [counts(&tightest), vec![at_most(p99(&tightest))]].concat(),
        ),
        claim(
            "Of all these rays {} are beyond their tolerance, and roundings explain {} of them",
            beyond_and_explained(&answering),
        ),
    ]
}

/// The number that follows this word in a text.
fn number_after(text: &str, word: &str) -> usize {
    let mut words = text.split(' ').skip_while(|other| *other != word);
    let number = words.nth(1).and_then(|number| number.parse().ok());
    number.unwrap_or_else(|| panic!("no number after {word} in: {text}"))
}

/// The rays beyond their tolerance that each hunt found. A file lists its worst scenes, which are
/// those with such rays and some more.
fn by_seed(hunts: &[Report<HuntRow>]) -> String {
    table(
        "seed | machine | revision | rays beyond their tolerance | unexplained | largest error over its tolerance | \
         that error, rad | at a ring too narrow for f32",
        hunts.iter().map(|hunt| {
            let said = |name: &str| hunt.head.get(name).expect("a hunt says how it was made");
            let sum = |of: fn(&HuntRow) -> usize| total(hunt.rows.iter().map(of));
            let seed = number_after(said("command"), "--seed").to_string();
            let revision = said("commit").to_owned()
                + if is_stale("hunt", &hunt.head) {
                    ", older"
                } else {
                    ""
                };
            let machine = said("adapter").split(" (").next().unwrap_or_default();
            let far = hunt.rows.iter().filter(|row| row.rays_beyond > 0);
            let [excess, error] = match far.max_by(|a, b| a.excess.total_cmp(&b.excess)) {
                Some(worst) => [ratio(worst.excess), short(worst.backward)],
                None => Default::default(),
            };
            vec![
                seed,
                machine.into(),
                revision,
                sum(|row| row.rays_beyond),
                sum(|row| row.rays_unexplained),
                excess,
                error,
                sum(|row| row.rays_unanswerable),
            ]
        }),
    )
}

fn of_hunts(hunts: &[Report<HuntRow>]) -> Vec<Claim> {
    let size =
        |hunt: &Report<HuntRow>| hunt.head.get("size").expect("a hunt has a size").to_owned();
    let rays = hunts
        .iter()
        .map(|hunt| number_after(&format!("of {}", size(hunt)), "of"));
    let scenes = hunts.iter().map(|hunt| number_after(&size(hunt), "in"));
    let rows = hunts.iter().flat_map(|hunt| &hunt.rows);
    let unexplained = rows.map(|row| row.rays_unexplained);
    vec![
        claim(
            "The {} runs below traced {} rays in {} random scenes by `auto`",
            [count(hunts.len()), total(rays), total(scenes)],
        ),
        claim(
            "The number of rays that are beyond their tolerance without such an explanation is {}",
            [total(unexplained)],
        ),
    ]
}
