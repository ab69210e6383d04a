//! Where a ray is inside a medium.

use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::mino::PhotonSeries;

/// Mino times within a step between which a ray is inside a medium, where its density is smooth.
pub type Span = [f64; 2];

/// Places of a step at which the search looks for the medium.
const PLACES: u32 = 96;
/// Halvings that take a boundary to its last digit.
const HALVINGS: u32 = 52;
/// Steps of the search for the deepest place between three others.
const DEEPER: u32 = 40;

/// The spans of a step of this length inside a medium, in the order of the backward ray. `depth_inside`
/// says how far inside the place (r, n_z) is, and is positive there. The spans are cut at these radii.
pub(super) fn spans(
    depth_inside: &dyn Fn(f64, f64) -> f64,
    radii: &[f64],
    series: &PhotonSeries,
    length: f64,
) -> Vec<Span> {
    let place = |t: f64| (series.u.at(t).0.recip(), series.n[2].at(t).0);
    let inside = |t: f64| {
        let (r, z) = place(t);
        depth_inside(r, z)
    };
    let times: Vec<f64> = (0..=PLACES)
        .map(|i| length * f64::from(i) / f64::from(PLACES))
        .collect();
    let mut marks = times.clone();
    // A ray that grazes the medium between two places.
    for three in times.windows(3) {
        let [before, at, after] = [three[0], three[1], three[2]].map(inside);
        if before < 0.0 && at < 0.0 && after < 0.0 && at >= before.max(after) {
            marks.push(deepest([three[0], three[2]], &inside));
        }
    }
    for radius in radii {
        let beyond = |t: f64| place(t).0 > *radius;
        for two in times.windows(2) {
            if beyond(two[0]) != beyond(two[1]) {
                let start = beyond(two[0]);
                let [low, high] = bisection([two[0], two[1]], HALVINGS, |t| beyond(t) == start);
                marks.push(0.5 * (low + high));
            }
        }
    }
    marks.sort_by(f64::total_cmp);
    let mut spans = Vec::new();
    for two in marks.windows(2) {
        let [from, to] = [two[0], two[1]];
        let middle = inside(0.5 * (from + to)) > 0.0;
        let ends = [from, to].map(|t| inside(t) > 0.0);
        let boundary = |outside: f64, within: f64| {
            bisection([outside, within], HALVINGS, |t| inside(t) <= 0.0)[1]
        };
        let half = 0.5 * (from + to);
        match (ends, middle) {
            ([true, true], _) => spans.push([from, to]),
            ([true, false], false) => spans.push([from, boundary(half, from)]),
            ([true, false], true) => spans.push([from, boundary(to, half)]),
            ([false, true], false) => spans.push([boundary(half, to), to]),
            ([false, true], true) => spans.push([boundary(from, half), to]),
            ([false, false], true) => spans.push([boundary(from, half), boundary(to, half)]),
            ([false, false], false) => {}
        }
    }
    spans
}

/// The place of the largest value between two places, by golden sections.
fn deepest([mut low, mut high]: [f64; 2], depth: &impl Fn(f64) -> f64) -> f64 {
    const SHARE: f64 = 0.618_033_988_749_894_9;
    for _ in 0..DEEPER {
        let [left, right] = [high - SHARE * (high - low), low + SHARE * (high - low)];
        if depth(left) < depth(right) {
            low = left;
        } else {
            high = right;
        }
    }
    0.5 * (low + high)
}
