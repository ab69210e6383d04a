//! Backward rays that are aimed: at a place, or at a star.

use crate::reference::HoleAndDisk;
use glam::{DMat2, DMat3, DVec2, DVec3};
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::{PhotonConstants, PhotonSeries};
use lightfall_model::geometry::observer::ObserverMatrix;
use lightfall_model::geometry::sphere::angle_between;
use std::f64::consts::PI;

/// The largest angle about the hole that light of a primary image sweeps, with some rounding: what is
/// exactly behind the hole has one.
const MAX_SWEPT: f64 = PI + 1e-6;
/// A ray is aimed when its last correction, in radians, is below this. What is left is its square, or a
/// millionth of it by the differences.
const TOLERANCE: f64 = 1e-7;
/// Half of a digit of f64 of the direction, over which rays are compared.
const DIFFERENCE: f64 = 1e-6;
/// Largest correction, in radians.
const MAX_CORRECTION: f64 = 0.2;
/// Maximum number of corrections.
const MAX_CORRECTIONS: u32 = 12;
/// A ray that stays farther from a place than this share of the place's radius does not meet it.
const MEETS: f64 = 1e-5;
/// Maximum number of steps of a ray.
const MAX_STEPS: u32 = 200;
/// Number of pieces of a step in which the nearest approach is looked for.
const PIECES: u32 = 8;
/// A ray is followed outward to so many times the larger of the two radii.
const FARTHEST: f64 = 1.5;
/// Maximum number of corrections of the moment of the nearest approach.
const MAX_REFINEMENTS: u32 = 12;

/// An observer, and its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Eye {
    pub(super) kerr: Kerr,
    /// The radius, in r_s.
    pub(super) r: f64,
    /// The unit vector on the celestial sphere, with the azimuth of a scene's camera.
    pub(super) n: DVec3,
    pub(super) frame: ObserverMatrix,
}

/// By what a ray misses its target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Miss {
    /// From the target to the ray, where they are nearest.
    by: DVec3,
    /// The unit vector along the ray there.
    along: DVec3,
    /// The angle that the ray sweeps about the hole on the way.
    swept: f64,
}

/// The direction near `guess` whose ray meets a target: Newton's method on the two components of the miss
/// across the ray, with differences for derivatives. `None` without a primary image there.
pub(super) fn aim(guess: DVec3, missed: impl Fn(DVec3) -> Option<Miss>) -> Option<DVec3> {
    let mut direction = guess;
    for _ in 0..MAX_CORRECTIONS {
        let axes = direction.any_orthonormal_pair();
        let here = missed(direction)?;
        let across = here.along.any_orthonormal_pair();
        let components = |miss: &Miss| DVec2::new(miss.by.dot(across.0), miss.by.dot(across.1));
        let miss = components(&here);
        let rate = |axis: DVec3| {
            let beside = missed((direction + DIFFERENCE * axis).normalize())?;
            Some((components(&beside) - miss) / DIFFERENCE)
        };
        let jacobian = DMat2::from_cols(rate(axes.0)?, rate(axes.1)?);
        let correction = -(jacobian.inverse() * miss);
        if !correction.is_finite() {
            return None;
        }
        let DVec2 { x, y } = correction.clamp_length_max(MAX_CORRECTION);
        direction = (direction + x * axes.0 + y * axes.1).normalize();
        if correction.length() < TOLERANCE {
            return (here.swept <= MAX_SWEPT).then_some(direction);
        }
    }
    None
}

impl Eye {
    /// By what the ray from `direction`, on the observer's axes, misses a place: r times the direction
    /// of theta and the azimuth of a camera outside the horizon. The nearest approach is in flat space
    /// with these as spherical coordinates, which does not matter where it is zero. `None` if the ray
    /// comes nearest at one of its ends.
    pub(super) fn miss_of_place(&self, direction: DVec3, place: DVec3) -> Option<Miss> {
        let photon = self.frame.photon(direction);
        let (constants, mut state) = PhotonConstants::of_photon(self.kerr, &photon, self.r, self.n);
        let u_far = 1.0 / (FARTHEST * self.r.max(place.length()));
        let u_horizon = 1.0 / self.kerr.horizon();
        let mut nearest: Option<Miss> = None;
        let mut swept = 0.0;
        for _ in 0..MAX_STEPS {
            let expansion = constants.expand(&state);
            let piece = constants.reach(&expansion) / f64::from(PIECES);
            if !(piece > 0.0 && piece.is_finite()) {
                break;
            }
            let mut from = RayPoint::at(&expansion, 0.0);
            for index in 1..=PIECES {
                let start = piece * f64::from(index - 1);
                let to = RayPoint::at(&expansion, start + piece);
                if !(to.u > 0.0 && to.place.is_finite()) {
                    return nearest;
                }
                if from.recedes(place) < 0.0 && to.recedes(place) >= 0.0 {
                    let point = nearest_point(&expansion, [start, start + piece], place);
                    let by = point.place - place;
                    if nearest.is_none_or(|miss| by.length() < miss.by.length()) {
                        nearest = Some(Miss {
                            by,
                            along: point.velocity.normalize(),
                            swept: swept + angle_between(from.n, point.n),
                        });
                    }
                }
                swept += angle_between(from.n, to.n);
                let ends = to.u <= u_far && to.du < 0.0 || to.u >= u_horizon && to.du > 0.0;
                if ends || swept > MAX_SWEPT + 1.0 {
                    return nearest;
                }
                from = to;
            }
            state = expansion.at(piece * f64::from(PIECES));
        }
        nearest
    }

    /// The direction near `guess` in which a place is seen, as [`aim`] and
    /// [`miss_of_place`](Self::miss_of_place) say.
    pub(super) fn aim_at_place(&self, guess: DVec3, place: DVec3) -> Option<DVec3> {
        let direction = aim(guess, |direction| self.miss_of_place(direction, place))?;
        let miss = self.miss_of_place(direction, place)?;
        (miss.by.length() < MEETS * place.length()).then_some(direction)
    }

    /// Where the ray from `direction` comes from on the sky, and the angle that it sweeps about the hole.
    /// `None` for one that comes from the hole.
    pub(super) fn sky(&self, direction: DVec3) -> Option<(DVec3, f64)> {
        let photon = self.frame.photon(direction);
        let (constants, start) = PhotonConstants::of_photon(self.kerr, &photon, self.r, self.n);
        let hole = HoleAndDisk {
            kerr: self.kerr,
            annulus: None,
        };
        let mut swept = 0.0;
        let trace = hole.follow(&constants, start, |step| {
            let [from, to] = [0.0, step.length].map(|time| step.expansion.at(time).n);
            swept += angle_between(from, to);
        });
        Some((trace.sky?, swept))
    }

    /// By what the ray from `direction` misses a star in the unit direction `star`.
    pub(super) fn miss_of_star(&self, direction: DVec3, star: DVec3) -> Option<Miss> {
        let (sky, swept) = self.sky(direction)?;
        (sky.dot(star) > 0.0).then_some(Miss {
            by: sky - star,
            along: star,
            swept,
        })
    }
}

/// A point of a ray.
struct RayPoint {
    u: f64,
    du: f64,
    n: DVec3,
    place: DVec3,
    /// The derivative of the place by Mino time.
    velocity: DVec3,
}

impl RayPoint {
    fn at(expansion: &PhotonSeries, time: f64) -> Self {
        let state = expansion.at(time);
        let turn = DMat3::from_rotation_z(state.chi);
        let drag = expansion.chi.at(time).1;
        let place = turn * state.n / state.u;
        let velocity = (turn * state.dn - state.du * place) / state.u;
        Self {
            u: state.u,
            du: state.du,
            n: state.n,
            place,
            velocity: velocity + drag * DVec3::Z.cross(place),
        }
    }

    /// Half of the rate of the squared distance from a place.
    fn recedes(&self, place: DVec3) -> f64 {
        (self.place - place).dot(self.velocity)
    }
}

/// The nearest point of a ray to a place between two times, by corrections that are exact for a straight
/// ray and the better the nearer the ray comes.
fn nearest_point(expansion: &PhotonSeries, [from, to]: [f64; 2], place: DVec3) -> RayPoint {
    let mut time = 0.5 * (from + to);
    let mut point = RayPoint::at(expansion, time);
    for _ in 0..MAX_REFINEMENTS {
        let correction = point.recedes(place) / point.velocity.length_squared();
        let next = (time - correction).clamp(from, to);
        let moved = (next - time).abs();
        time = next;
        point = RayPoint::at(expansion, time);
        if moved <= f64::EPSILON * (to - from) {
            break;
        }
    }
    point
}
