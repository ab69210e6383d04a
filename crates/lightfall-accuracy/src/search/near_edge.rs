//! The search for the turn that explains an answer near the edge of the shadow.

use super::chart::{Chart, DIFFERENCE};
use super::newton::{MIN_DAMPING, NO_DAMPING, along_first_axis, newton};
use super::part::{Part, miss_on_chart};
use crate::reference_camera::ReferenceCamera;
use glam::{DVec2, DVec3};
use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_optics::trace::Trace;
use std::f64::consts::TAU;

/// For turns within `NEAR` times the distance to the edge, the plane is as good a chart as the
/// edge's own. A turn beyond `FAR` times that distance may not be the smallest.
const NEAR: f64 = 0.1;
const FAR: f64 = 3.0;
/// Change of an answer's height in one step along the line toward the edge.
const HEIGHT_STEP: f64 = 0.1;
/// A part converges toward the edge if its heights at this many last places of the line differ by
/// less than this.
const CONVERGED_PLACES: usize = 5;
const CONVERGED_HEIGHT: f64 = 0.5 * HEIGHT_STEP;
/// Number of bisections of such a step.
const BISECTIONS: u32 = 30;
/// Number of steps of a golden-section search between three such steps: it ends within 1e-5 of
/// their width, so the height is right to 1e-10 of their heights.
const SUMMIT_STEPS: u32 = 24;
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Maximum number of places of the right height that are searched, the nearest first.
const MAX_PLACES: usize = 4;
/// Where the azimuth changes faster than this, in radians per e-fold of the distance to the edge,
/// every azimuth occurs close to any place of the right height.
const FAST_AZIMUTH: f64 = 2.0 * TAU;

/// The smallest angle found such that some rotation of the ray by at most that angle leaves a miss
/// of at most that angle, searched on the edge's own chart. `least` is the bound known so far. A
/// bound below `precision` ends the search. `visit` is called with each direction and its answer.
pub(super) fn turn_near_edge(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    [precision, mut least]: [f64; 2],
    visit: &dyn Fn(DVec3, &Trace),
) -> f64 {
    let at = miss_on_chart(camera, chart, part, visit);
    if least > NEAR * chart.scale {
        least = least.min(newton(chart, &at, along_first_axis(&at, 0.0), MIN_DAMPING));
    }
    if least > precision.max(FAR * chart.scale) {
        least = least.min(newton(chart, &at, along_first_axis(&at, 0.0), NO_DAMPING));
    }
    // Where the azimuth changes fast, every ray has rays with the same answer close by.
    let near = if rate(camera, chart, part, 0.0).is_some_and(|[_, rate]| rate.abs() > FAST_AZIMUTH)
    {
        NEAR * NEAR
    } else {
        FAR
    };
    if least < precision.max(near * chart.scale) {
        return least;
    }
    // The answer may belong to a ray with another number of turns about the hole. Such rays lie
    // along the line toward the edge and away from it.
    let [toward, away] = [-1.0, 1.0].map(|side| line(camera, chart, part, side, least));
    let [inward, outward] = [&toward, &away].map(|line| heights(camera, chart, part, line));
    // Each e-fold of the distance to the edge adds an equal part of an orbit, without end. About a
    // spinning hole such an orbit fills its whole range of latitudes. So if rays pass an answer
    // above and below, or meet the ring only now and then, others come arbitrarily close to it, and
    // the distance to the edge bounds its error. A hit in front of the orbit converges instead.
    let is_behind_orbit = matches!(part, Part::Sky(_)) || !converges(&toward);
    let is_missing =
        matches!(part, Part::Hit(..)) && toward.iter().any(|(_, height)| height.is_none());
    if camera.is_spinning && is_behind_orbit && (brackets_zero(&inward) || is_missing) {
        least = least.min(chart.scale);
    }
    let mut places = places(&inward);
    places.extend(self::places(&outward));
    places.sort_by(|a, b| a[0].abs().total_cmp(&b[0].abs()));
    for place in places.into_iter().take(MAX_PLACES) {
        if least <= precision {
            break;
        }
        for start in starts(camera, chart, part, place) {
            least = least.min(newton(chart, &at, along_first_axis(&at, start), NO_DAMPING));
        }
    }
    least
}

/// The places on the line toward the edge (`side` -1) or away from it (1), with the difference in
/// height there; `None` where the ray has no such part.
fn line(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    side: f64,
    farthest: f64,
) -> Vec<(f64, Option<f64>)> {
    let moved = |before: &Trace, after: &Trace| {
        part.height(before)
            .zip(part.height(after))
            .map_or(0.0, |(before, after)| (after - before).abs())
    };
    let line = chart.line(camera, side, farthest, HEIGHT_STEP, moved);
    let height = |(x, trace): (f64, Trace)| (x, part.height(&trace));
    line.into_iter().map(height).collect()
}

/// Whether the last places of the line toward the edge all have the part at nearly the same height.
fn converges(inward: &[(f64, Option<f64>)]) -> bool {
    let Some(last) = inward.last_chunk::<CONVERGED_PLACES>() else {
        return false;
    };
    let heights: Option<Vec<f64>> = last.iter().map(|(_, height)| *height).collect();
    heights.is_some_and(|heights| {
        let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
        high - low < CONVERGED_HEIGHT
    })
}

/// The differences in height on a line, with those at its extrema.
fn heights(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    line: &[(f64, Option<f64>)],
) -> Vec<[f64; 2]> {
    let line: Vec<[f64; 2]> = line
        .iter()
        .filter_map(|(x, height)| height.map(|height| [*x, height]))
        .collect();
    with_summits(&line, |x| {
        part.height(&camera.trace(chart.at(DVec2::new(x, 0.0))))
    })
}

/// The line with the extrema of the height next to the right height added. At the ends of the
/// orbit's range of latitudes the right height may lie between two steps on the same side of it.
/// `height` gives the height between the steps.
fn with_summits(line: &[[f64; 2]], height: impl Fn(f64) -> Option<f64>) -> Vec<[f64; 2]> {
    let mut summits: Vec<[f64; 2]> = line
        .windows(3)
        .filter(|three| is_nearest(three) && three[1][1].abs() < HEIGHT_STEP)
        .filter_map(|three| {
            // Golden-section search for the extremum toward the right height.
            let toward = -three[1][1].signum();
            let beyond = |x: f64| height(x).map_or(f64::NEG_INFINITY, |height| toward * height);
            let (mut low, mut high) = (three[0][0], three[2][0]);
            for _ in 0..SUMMIT_STEPS {
                let width = (1.0 - GOLDEN) * (high - low);
                if beyond(low + width) < beyond(high - width) {
                    low += width;
                } else {
                    high -= width;
                }
            }
            let x = 0.5 * (low + high);
            height(x).map(|height| [x, height])
        })
        .collect();
    summits.extend(line);
    summits.sort_by(|a, b| a[0].abs().total_cmp(&b[0].abs()));
    summits
}

/// Whether the middle one of three steps is the nearest to the right height, and all are on one
/// side of it.
fn is_nearest(three: &[[f64; 2]]) -> bool {
    let [before, here, after] = [three[0][1], three[1][1], three[2][1]];
    here.abs() <= before.abs()
        && here.abs() <= after.abs()
        && before * here > 0.0
        && here * after > 0.0
}

/// Whether the difference in height is positive at one place of a line and negative at another.
fn brackets_zero(line: &[[f64; 2]]) -> bool {
    line.iter().any(|[_, height]| *height > 0.0) && line.iter().any(|[_, height]| *height < 0.0)
}

/// The steps of a line that contain a place of the right height, by their two ends; and the places
/// where the height is locally closest to it, as steps of length zero.
fn places(line: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let right = line
        .windows(2)
        .filter(|two| two[0][1] * two[1][1] <= 0.0)
        .map(|two| [two[0][0], two[1][0]]);
    let nearest = line.windows(3).filter(|three| is_nearest(three));
    right.chain(nearest.map(|three| [three[1][0]; 2])).collect()
}

/// The first coordinates near a place of the right height at which the azimuth is right too.
fn starts(camera: &ReferenceCamera, chart: &Chart, part: Part, [from, to]: [f64; 2]) -> Vec<f64> {
    let at = |x: f64| camera.trace(chart.at(DVec2::new(x, 0.0)));
    let mut bracket = [from, to];
    let below = part.height(&at(from)).is_some_and(|height| height < 0.0);
    for _ in 0..if from == to { 0 } else { BISECTIONS } {
        let middle = 0.5 * (bracket[0] + bracket[1]);
        let same = part
            .height(&at(middle))
            .is_some_and(|height| (height < 0.0) == below);
        bracket[usize::from(!same)] = middle;
    }
    let x = bracket[0];
    match rate(camera, chart, part, x) {
        Some([off, rate]) if rate.abs() > FAST_AZIMUTH => [-1.0, 0.0, 1.0]
            .map(|turns| x + (TAU * turns - off) / rate)
            .into(),
        _ => vec![x],
    }
}

/// The difference in azimuth at a place on the line toward the edge, and its derivative along the
/// line.
fn rate(camera: &ReferenceCamera, chart: &Chart, part: Part, x: f64) -> Option<[f64; 2]> {
    let at = |x: f64| part.azimuth(&camera.trace(chart.at(DVec2::new(x, 0.0))));
    let (here, next) = at(x).zip(at(x + DIFFERENCE))?;
    Some([here, wrap_angle(next - here) / DIFFERENCE])
}
