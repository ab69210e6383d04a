//! The path of one ray, for looking at: places along it, and what it did on its way.
//!
//! The path is that of the reference, step by step, from the same series. Two lengths along it are
//! integrals over Mino time, by Gauss and Legendre on ever smaller parts until they agree:
//!
//! * the angle swept about the hole, of dpsi = |n'| dtau with |n'|^2 = K + a^2 E^2 n_z^2 (what spin
//!   drags along is not in it);
//! * the Boyer-Lindquist time that light takes, of dt = ((r^2 + a^2) (E (r^2 + a^2) - a L) / Delta
//!   + a L - a^2 E sin^2 theta) dtau (Carter 1968; Misner, Thorne & Wheeler 1973 eq. 33.32d).

use crate::geometry::kerr::Kerr;
use crate::geometry::mino::{Constants, Expansion, State};
use crate::geometry::observer::Photon;
use crate::optics::reference::{Reference, Surroundings};
use crate::optics::trace::{Outcome, Trace};
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

/// Places of a step that are kept.
const PLACES: usize = 24;
/// The path of a captured ray ends this close to the horizon, as a share of its radius: azimuths
/// grow without end there.
const HORIZON_MARGIN: f64 = 0.02;
/// Most places of a path; a ray that winds about the hole for ever is cut off.
const MAX_PLACES: usize = 4000;
/// Angles that are a whole number of half-turns but for rounding belong to the lower order: from a
/// camera in the disk's plane, the disk is met after whole half-turns exactly.
const WHOLE_TURN: f64 = 1e-5;

/// What a ray did on its way.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Places along the backward ray, from the camera on, in r_s: r times the unit vector toward
    /// Boyer-Lindquist theta, phi; from a camera at or inside the horizon, toward Kerr's ingoing
    /// azimuth.
    pub places: Vec<DVec3>,
    /// Smallest r that the ray reaches, in r_s; the horizon's for a captured ray.
    pub closest_r: f64,
    /// Angle swept about the hole up to what is seen first, in radians.
    pub turn: f64,
    /// Boyer-Lindquist time from the emission at each of the disk's hits to the camera, in r_s / c.
    pub delays: [Option<f64>; 2],
    /// Constants of the motion; none for straight rays, which have none.
    pub constants: Option<Invariants>,
}

/// A photon's constants per unit energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Invariants {
    /// b = sqrt(eta + lambda^2), in r_s: without spin the impact parameter at infinity.
    pub impact_parameter: f64,
    /// lambda = L/E, in r_s.
    pub lambda: f64,
    /// eta = Q/E^2, in r_s^2.
    pub eta: f64,
}

impl Path {
    /// The path of the ray that arrives from the unit direction `direction`, on the observer's
    /// axes, as far out as `farthest` (r_s), beside its trace by the same reference.
    #[must_use]
    pub fn of(reference: &Reference, direction: DVec3, farthest: f64) -> (Trace, Self) {
        let trace = reference.trace(direction);
        let photon = reference.photon(direction.normalize());
        let (r, n) = reference.camera();
        let surroundings = reference.surroundings();
        let path = if reference.lensing() {
            bent(surroundings, &photon, r, n, &trace, farthest)
        } else {
            straight(surroundings.kerr, &photon, r, n, &trace, farthest)
        };
        (trace, path)
    }

    /// Order of the image: whole half-turns about the hole up to what is seen first. None where
    /// nothing is seen.
    #[must_use]
    pub fn order(&self, trace: &Trace) -> Option<u32> {
        let seen = trace.outcome == Outcome::Sky || trace.hits[0].is_some();
        seen.then(|| ((self.turn - WHOLE_TURN) / PI).max(0.0) as u32)
    }
}

fn bent(
    surroundings: Surroundings,
    photon: &Photon,
    r: f64,
    n: DVec3,
    trace: &Trace,
    farthest: f64,
) -> Path {
    let Surroundings { kerr, .. } = surroundings;
    let (constants, start) = Constants::of_photon(kerr, photon, r, n);
    let mut path = Path {
        places: Vec::new(),
        closest_r: r,
        turn: 0.0,
        delays: [None; 2],
        constants: Some(invariants(&constants)),
    };
    let (mut turn, mut delay, mut found) = (0.0, 0.0, 0);
    let swept = |expansion: &Expansion, end: f64| {
        integral(0.0, end, &|t| constants.sweep(&expansion.at(t)))
    };
    let duration = |expansion: &Expansion, end: f64| {
        integral(0.0, end, &|t| constants.pace(kerr, &expansion.at(t)))
    };
    surroundings.follow(&constants, start, |_, expansion, end| {
        path.closest_r = path.closest_r.min(closest(expansion, end));
        // The step that meets the next hit is the one that crosses the disk's plane at the hit's
        // radius.
        let hit = trace.hits.get(found).copied().flatten();
        let meeting = hit.and_then(|hit| meeting(expansion, end, 1.0 / hit.r));
        if let Some(time) = meeting {
            if found == 0 {
                path.turn = turn + swept(expansion, time);
            }
            path.delays[found] = (!constants.ingoing).then(|| delay + duration(expansion, time));
            found += 1;
        }
        turn += swept(expansion, end);
        // Only as long as there is a hit to come: at the end of the ray the time is infinite.
        if trace.hits.get(found).is_some_and(Option::is_some) {
            delay += duration(expansion, end);
        }
    });
    if trace.hits[0].is_none() {
        path.turn = turn;
    }
    if trace.outcome == Outcome::Captured {
        path.closest_r = kerr.horizon().min(r);
    }
    path.places = places(surroundings, &constants, start, farthest);
    path
}

/// Places along a ray to its very end, also where the trace knows the outcome earlier.
fn places(
    surroundings: Surroundings,
    constants: &Constants,
    start: State,
    farthest: f64,
) -> Vec<DVec3> {
    let u_end = (1.0 - HORIZON_MARGIN) / surroundings.kerr.horizon();
    // A path that begins inside the horizon, or next to it, ends there only if it comes back. Light
    // from the horizon's other branch never was outside, and its path ends where that branch is.
    let mut outside = start.u < u_end;
    let u_horizon = 1.0 / surroundings.kerr.horizon();
    let kept_inside = constants.kept_inside(&start, u_horizon);
    let least = 1.0 / farthest;
    let place = |state: &State| DMat3::from_rotation_z(state.chi) * state.n / state.u;
    let mut places = vec![place(&start)];
    let mut state = start;
    while places.len() < MAX_PLACES {
        let expansion = constants.expand(&state);
        let reach = constants.reach(&expansion);
        for i in 1..=PLACES {
            let next = expansion.at(reach * i as f64 / PLACES as f64);
            let ended = !next.u.is_finite()
                || !next.n.is_finite()
                || (outside && next.u >= u_end && next.du > 0.0);
            outside |= next.u < u_end;
            if ended || next.u <= least && next.du < 0.0 || kept_inside && next.u <= u_horizon {
                return places;
            }
            places.push(place(&next));
        }
        let next = expansion.at(reach);
        if reach <= 0.0 || (!outside && next.du > 0.0) {
            return places;
        }
        state = next;
    }
    places
}

fn straight(kerr: Kerr, photon: &Photon, r: f64, n: DVec3, trace: &Trace, farthest: f64) -> Path {
    let start = r * n;
    let direction = (-photon.radial * n - photon.w).normalize();
    let nearest = (start - start.dot(direction) * direction).length();
    let captured = trace.outcome == Outcome::Captured;
    let closest_r = match captured {
        true => kerr.horizon(),
        false if start.dot(direction) < 0.0 => nearest,
        false => r,
    };
    // To the horizon, or as far out as is asked for.
    let radius = if captured {
        kerr.horizon()
    } else {
        farthest.max(r)
    };
    let half_chord = (radius * radius - nearest * nearest).max(0.0).sqrt();
    let length = if captured {
        -start.dot(direction) - half_chord
    } else {
        -start.dot(direction) + half_chord
    };
    let hit =
        trace.hits[0].map(|hit| DVec3::new(hit.r * hit.phi.cos(), hit.r * hit.phi.sin(), 0.0));
    let turn = hit.map_or(n.angle_between(direction), |hit| n.angle_between(hit));
    let delays = [hit.map(|hit| hit.distance(start)), None];
    let places = (0..=PLACES)
        .map(|i| start + direction * (length * i as f64 / PLACES as f64))
        .collect();
    Path {
        places,
        closest_r,
        turn,
        delays,
        constants: None,
    }
}

fn invariants(constants: &Constants) -> Invariants {
    let energy = constants.energy;
    Invariants {
        impact_parameter: constants.k.max(0.0).sqrt() / energy,
        lambda: constants.angular_momentum / energy,
        eta: constants.carter_q() / energy.powi(2),
    }
}

impl Constants {
    /// |n'|, the angle swept per Mino time.
    fn sweep(&self, state: &State) -> f64 {
        (self.k + (self.a * self.energy * state.n.z).powi(2))
            .max(0.0)
            .sqrt()
    }

    /// dt / dtau, in r_s^2; outside the horizon.
    fn pace(&self, kerr: Kerr, state: &State) -> f64 {
        let (a, r) = (self.a, 1.0 / state.u);
        let wide = r * r + a * a;
        let sin2 = 1.0 - state.n.z * state.n.z;
        wide * (self.energy * wide - a * self.angular_momentum) / kerr.delta(r)
            + a * self.angular_momentum
            - a * a * self.energy * sin2
    }
}

/// The smallest r of a step.
fn closest(expansion: &Expansion, end: f64) -> f64 {
    let (first, last) = (expansion.at(0.0), expansion.at(end));
    let mut u = first.u.max(last.u);
    if first.du > 0.0 && last.du < 0.0 {
        let (mut low, mut high) = (0.0, end);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if expansion.at(middle).du > 0.0 {
                low = middle
            } else {
                high = middle
            }
        }
        u = u.max(expansion.at(low).u);
    }
    1.0 / u
}

/// The Mino time within a step at which it crosses the disk's plane, if it does so at this u.
fn meeting(expansion: &Expansion, end: f64, u: f64) -> Option<f64> {
    let (before, after) = (expansion.at(0.0).n.z, expansion.at(end).n.z);
    let crosses = before > 0.0 && after <= 0.0 || before < 0.0 && after >= 0.0;
    let time = crosses.then(|| expansion.n[2].root(end))?;
    ((expansion.at(time).u - u).abs() <= 1e-9 * u).then_some(time)
}

/// Nodes and weights of Gauss and Legendre's rule of seven points on [-1, 1]: the node at zero and
/// three pairs.
const NODES: [[f64; 2]; 4] = [
    [0.0, 0.417_959_183_673_469_4],
    [0.405_845_151_377_397_2, 0.381_830_050_505_118_9],
    [0.741_531_185_599_394_4, 0.279_705_391_489_276_7],
    [0.949_107_912_342_758_5, 0.129_484_966_168_869_7],
];

fn rule(from: f64, to: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let pair = |[node, weight]: [f64; 2]| {
        let values = if node == 0.0 {
            f(middle)
        } else {
            f(middle - half * node) + f(middle + half * node)
        };
        weight * values
    };
    half * NODES.into_iter().map(pair).sum::<f64>()
}

/// The integral of a smooth function, to some 1e-12 of itself: halved until the halves agree with
/// the whole.
fn integral(from: f64, to: f64, f: &impl Fn(f64) -> f64) -> f64 {
    fn part(from: f64, to: f64, whole: f64, depth: u32, f: &impl Fn(f64) -> f64) -> f64 {
        let middle = 0.5 * (from + to);
        let halves = [rule(from, middle, f), rule(middle, to, f)];
        let sum = halves[0] + halves[1];
        if depth == 0 || (sum - whole).abs() <= 1e-12 * sum.abs() {
            return sum;
        }
        part(from, middle, halves[0], depth - 1, f) + part(middle, to, halves[1], depth - 1, f)
    }
    part(from, to, rule(from, to, f), 24, f)
}
