//! The backward error: by how much a ray must be turned for the reference to give the method's
//! answer, up to an angle no greater than that turn.

use super::chart::{Chart, DIFFERENCE};
use super::finite::greater;
use super::ray::Ray;
use super::reference_camera::ReferenceCamera;
use crate::geometry::sphere::wrap_angle;
use crate::optics::trace::{Hit, Trace};
use glam::{DMat2, DVec2, DVec3};
use std::f64::consts::TAU;

/// Most steps of Newton's method.
const MAX_STEPS: u32 = 24;
/// Share of the way at which Newton's method has arrived.
const SETTLED: f64 = 1e-6;
/// Least damping of a step, as a logarithm. Where rays are focused onto one point nothing explains
/// an answer's last digits, and a step hardly damped goes far astray; next to an edge a step along
/// it needs it.
const DAMPED: f64 = -30.0;
const FREE: f64 = -70.0;
/// Within this share of the distance to the edge the plane is as good a chart as the edge's own;
/// beyond so many of them an explanation may not be the nearest.
const NEAR: f64 = 0.1;
const FAR: f64 = 3.0;
/// A backward error so large is worth a search for the edge, if the forward one is so much larger
/// or it is larger than this.
const MIN_WORTH: f64 = 1e-6;
const AMPLIFIED: f64 = 30.0;
const LARGE: f64 = 0.01;
/// Steps of an answer's height along the line toward the edge, and bisections of such a step.
const HEIGHT_STEP: f64 = 0.1;
const BISECTIONS: u32 = 30;
/// How often a step that leads to where the miss has no meaning is halved.
const HALVINGS: i32 = 8;
/// How many of the places on that line where the height is right are looked at closer, the nearest
/// first.
const MAX_PLACES: usize = 4;
/// Where rays wind faster than this, in radians an e-fold, the right height comes with every
/// azimuth next to it.
const FAST: f64 = 2.0 * TAU;

/// The sky of an answer, or one of its hits.
#[derive(Clone, Copy)]
pub(super) enum Part {
    /// Where the ray comes from.
    Sky(DVec3),
    /// Where it meets the disk, and for the how manieth time.
    Hit(usize, Hit),
}

impl Part {
    /// The parts of an answer.
    pub(super) fn all(given: &Trace) -> impl Iterator<Item = Self> {
        let hits = given
            .hits
            .into_iter()
            .enumerate()
            .filter_map(|(i, hit)| hit.map(|hit| Self::Hit(i, hit)));
        given.sky.map(Self::Sky).into_iter().chain(hits)
    }

    /// By how much another answer misses this part: a direction on two axes at right angles to the
    /// wanted one; a hit as a share of its 1/r, which unlike r is smooth to infinity, and along the
    /// azimuth.
    fn miss(&self, found: &Trace) -> Option<DVec2> {
        match self {
            Self::Sky(wanted) => found.sky.map(|found| {
                let (u, v) = wanted.any_orthonormal_pair();
                let miss = found - wanted;
                DVec2::new(miss.dot(u), miss.dot(v))
            }),
            Self::Hit(..) => self
                .height(found)
                .zip(self.azimuth(found))
                .map(|(height, azimuth)| DVec2::new(height, azimuth)),
        }
    }

    /// How much of that is not azimuth: next to a fast hole rays differ much more in the azimuth
    /// than in this.
    fn height(&self, found: &Trace) -> Option<f64> {
        match self {
            Self::Sky(wanted) => found.sky.map(|found| found.z - wanted.z),
            Self::Hit(i, wanted) => found.hits[*i].map(|found| 1.0 - wanted.r / found.r),
        }
    }

    /// By how much the azimuth is off.
    fn azimuth(&self, found: &Trace) -> Option<f64> {
        let off = match self {
            Self::Sky(wanted) => found
                .sky
                .map(|found| found.y.atan2(found.x) - wanted.y.atan2(wanted.x)),
            Self::Hit(i, wanted) => found.hits[*i].map(|found| found.phi - wanted.phi),
        };
        off.map(wrap_angle)
    }
}

/// The turn that explains an answer of the right class: the largest of those that explain its
/// parts.
///
/// What is off by less than `fine` is not looked at closer: its own size, which bounds the turn,
/// will do.
pub(super) fn of_answer(
    camera: &ReferenceCamera,
    ray: &Ray,
    truth: &Trace,
    given: &Trace,
    fine: f64,
) -> f64 {
    Part::all(given).fold(0.0, |most, part| {
        let forward = part.miss(truth).map_or(f64::INFINITY, DVec2::length);
        greater(
            most,
            if forward < fine {
                forward
            } else {
                explained(camera, ray, part, fine)
            },
        )
    })
}

/// The smallest angle found for which a turn of the ray by no more leaves a `miss` of no more;
/// infinite where the miss has no meaning anywhere near.
///
/// That is the mixed forward-backward error (Higham 2002, section 1.5): nearly the right answer to
/// nearly the right question. Behind the hole there are points onto which whole rings of rays are
/// focused, and next to them no turn explains an answer's last digit; elsewhere it is the turn that
/// explains the answer, but for a factor of two at most. Every place that is tried bounds it from
/// above, so a search that fails can but overstate it; one below `fine` ends it.
fn explained(camera: &ReferenceCamera, ray: &Ray, part: Part, fine: f64) -> f64 {
    let least = in_plane(camera, ray, part, &|_, _| {});
    // Edges are dear to find: only for answers far off to which a small turn leads, as next to an
    // edge.
    let forward = part
        .miss(&camera.trace(ray.direction()))
        .map_or(f64::INFINITY, DVec2::length);
    let amplified = least > MIN_WORTH && (forward > AMPLIFIED * least || least > LARGE);
    let ray = if amplified && least > fine {
        camera.with_edge(ray)
    } else {
        *ray
    };
    match Chart::edge(&ray) {
        Some(chart) if least > fine => beside_edge(camera, &chart, part, [fine, least], &|_, _| {}),
        _ => least,
    }
}

/// The same by two directions at right angles to the ray; `seen` is told of each place that is
/// tried, by its turn and answer.
pub(super) fn in_plane(
    camera: &ReferenceCamera,
    ray: &Ray,
    part: Part,
    seen: &dyn Fn(f64, &Trace),
) -> f64 {
    let plane = Chart::plane(ray, camera.scale);
    newton(
        &plane,
        &missed(camera, &plane, part, seen),
        DVec2::ZERO,
        DAMPED,
    )
}

/// The same by the edge's own chart; `fine` is good enough, and `least` is known.
pub(super) fn beside_edge(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    [fine, mut least]: [f64; 2],
    seen: &dyn Fn(f64, &Trace),
) -> f64 {
    let at = missed(camera, chart, part, seen);
    if least > NEAR * chart.scale {
        least = least.min(newton(chart, &at, along_edge(&at, 0.0), DAMPED));
    }
    if least > fine.max(FAR * chart.scale) {
        least = least.min(newton(chart, &at, along_edge(&at, 0.0), FREE));
    }
    // Where rays wind fast, others that give the same answer are next to any.
    let near = if rate(camera, chart, part, 0.0).is_some_and(|[_, rate]| rate.abs() > FAST) {
        NEAR * NEAR
    } else {
        FAR
    };
    if least < fine.max(near * chart.scale) {
        return least;
    }
    // The answer may be one of another number of turns about the hole: those lie in a row toward
    // the edge, and away from it.
    let [inward, outward] = [-1.0, 1.0].map(|side| heights(camera, chart, part, side, least));
    // Each e-fold of the distance to the edge adds as much of an orbit as the one before, without
    // end. About a spinning hole such an orbit fills all the latitudes between which it swings:
    // rays that pass an answer above and below come as close to it as one likes in the end, and so
    // the distance to the edge bounds its error.
    if camera.is_spinning && passes(&inward) {
        least = least.min(chart.scale);
    }
    let mut places = places(&inward);
    places.extend(self::places(&outward));
    places.sort_by(|a, b| a[0].abs().total_cmp(&b[0].abs()));
    for place in places.into_iter().take(MAX_PLACES) {
        if least <= fine {
            break;
        }
        for start in starts(camera, chart, part, place) {
            least = least.min(newton(chart, &at, along_edge(&at, start), FREE));
        }
    }
    least
}

/// By how much the answer at a place of a chart misses a part; `seen` is told of the place.
fn missed(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    seen: &dyn Fn(f64, &Trace),
) -> impl Fn(DVec2) -> Option<DVec2> {
    move |place| {
        let trace = camera.trace(chart.at(place));
        seen(chart.turn(place), &trace);
        part.miss(&trace)
    }
}

/// The places on the line toward the edge, or away from it, with what an answer's height is off by
/// there.
fn heights(
    camera: &ReferenceCamera,
    chart: &Chart,
    part: Part,
    side: f64,
    farthest: f64,
) -> Vec<[f64; 2]> {
    let moved = |before: &Trace, after: &Trace| {
        part.height(before)
            .zip(part.height(after))
            .map_or(0.0, |(before, after)| (after - before).abs())
    };
    let line = chart
        .line(camera, side, farthest, HEIGHT_STEP, moved)
        .into_iter();
    line.filter_map(|(x, trace)| part.height(&trace).map(|height| [x, height]))
        .collect()
}

/// Whether a line passes an answer's height.
fn passes(line: &[[f64; 2]]) -> bool {
    line.iter().any(|[_, height]| *height > 0.0) && line.iter().any(|[_, height]| *height < 0.0)
}

/// The steps of a line, by their ends, within which the height is right, or about whose start it is
/// nearest to being so.
fn places(line: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let right = line
        .windows(2)
        .filter(|two| two[0][1] * two[1][1] <= 0.0)
        .map(|two| [two[0][0], two[1][0]]);
    let nearest = line.windows(3).filter(|three| {
        let [before, here, after] = [three[0][1].abs(), three[1][1].abs(), three[2][1].abs()];
        here <= before
            && here <= after
            && three[0][1] * three[1][1] > 0.0
            && three[1][1] * three[2][1] > 0.0
    });
    right.chain(nearest.map(|three| [three[1][0]; 2])).collect()
}

/// The first coordinates next to a place of the right height at which the azimuth is right, too.
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
        Some([off, rate]) if rate.abs() > FAST => [-1.0, 0.0, 1.0]
            .map(|turns| x + (TAU * turns - off) / rate)
            .into(),
        _ => vec![x],
    }
}

/// By how much the azimuth is off on the line toward the edge, and its derivative there.
fn rate(camera: &ReferenceCamera, chart: &Chart, part: Part, x: f64) -> Option<[f64; 2]> {
    let at = |x: f64| part.azimuth(&camera.trace(chart.at(DVec2::new(x, 0.0))));
    let (here, beside) = at(x).zip(at(x + DIFFERENCE))?;
    Some([here, wrap_angle(beside - here) / DIFFERENCE])
}

/// The place nearest to explaining an answer on the line toward the edge, from a place there (Gauss
/// and Newton).
fn along_edge(at: &impl Fn(DVec2) -> Option<DVec2>, start: f64) -> DVec2 {
    let mut place = DVec2::new(start, 0.0);
    let Some(mut left) = at(place) else {
        return place;
    };
    for _ in 0..8 {
        let Some(slope) = [DIFFERENCE, -DIFFERENCE]
            .into_iter()
            .find_map(|h| Some((at(place + h * DVec2::X)? - left) / h))
        else {
            break;
        };
        let step = -(slope.dot(left) / slope.length_squared()).clamp(-1.0, 1.0);
        match (step.abs() > DIFFERENCE)
            .then(|| advance(at, place, step * DVec2::X))
            .flatten()
        {
            Some(next) => (place, left) = next,
            None => break,
        }
    }
    place
}

/// The place a step away, or as much of it as remains where the miss has a meaning, and the miss
/// there: an image of the disk ends where the answer may lie next to its end, and a step goes
/// beyond.
fn advance(
    at: &impl Fn(DVec2) -> Option<DVec2>,
    place: DVec2,
    step: DVec2,
) -> Option<(DVec2, DVec2)> {
    (0..HALVINGS)
        .map(|i| place + step * 0.5_f64.powi(i))
        .find_map(|next| at(next).map(|left| (next, left)))
}

/// Newton's method for the smallest place that explains an answer: the least bound met on the way.
fn newton(chart: &Chart, at: &impl Fn(DVec2) -> Option<DVec2>, start: DVec2, damping: f64) -> f64 {
    let Some(left) = at(start) else {
        return f64::INFINITY;
    };
    let mut least = f64::max(chart.turn(start), left.length());
    let (mut place, mut left) = (start, left);
    for _ in 1..MAX_STEPS {
        let Some(aim) = jacobian(chart, at, place, left)
            .and_then(|jacobian| smallest(chart, place, left, jacobian, damping))
        else {
            break;
        };
        let step = aim - place;
        let before = place;
        let Some(next) = advance(
            at,
            place,
            step / f64::max(1.0, (step / chart.reach()).length()),
        ) else {
            break;
        };
        (place, left) = next;
        least = least.min(f64::max(chart.turn(place), left.length()));
        if (place - before).length() <= SETTLED * place.length() {
            break;
        }
    }
    least
}

/// The nearest place to the ray from which a miss that is linear in the place is no greater than
/// the turn to there.
fn smallest(
    chart: &Chart,
    place: DVec2,
    left: DVec2,
    jacobian: DMat2,
    damping: f64,
) -> Option<DVec2> {
    let aim = jacobian * place - left;
    // Columns of length one first: next to an edge a turn across it does so much more than one
    // along it that the square of the ratio is beyond f64. A direction may do nothing at all.
    let lengths =
        DVec2::new(jacobian.x_axis.length(), jacobian.y_axis.length()).max(DVec2::splat(1e-100));
    let unit = jacobian * DMat2::from_diagonal(1.0 / lengths);
    let square = unit.transpose() * unit;
    let largest = lengths.length_squared();
    let solution = |exponent: f64| {
        let damped = square + DMat2::from_diagonal(largest * exponent.exp() / (lengths * lengths));
        damped.inverse() * (unit.transpose() * aim) / lengths
    };
    let allowed = |x: DVec2| chart.scale * x.length();
    let mut bracket = [damping, 5.0];
    for _ in 0..50 {
        let middle = 0.5 * (bracket[0] + bracket[1]);
        let x = solution(middle);
        bracket[usize::from((jacobian * x - aim).length() > allowed(x))] = middle;
    }
    Some(solution(bracket[0])).filter(|x| x.is_finite())
}

/// The derivative of the miss, by differences, on whichever side there is something.
fn jacobian(
    chart: &Chart,
    at: &impl Fn(DVec2) -> Option<DVec2>,
    place: DVec2,
    left: DVec2,
) -> Option<DMat2> {
    let differences = chart.differences();
    let derivative = |axis: DVec2| {
        let sided = |h: f64| at(place + h * axis).map(|miss| (miss - left) / h);
        let difference = axis.dot(differences);
        match (sided(difference), sided(-difference)) {
            (Some(a), Some(b)) => Some(0.5 * (a + b)),
            (a, b) => a.or(b),
        }
    };
    Some(DMat2::from_cols(
        derivative(DVec2::X)?,
        derivative(DVec2::Y)?,
    ))
}
