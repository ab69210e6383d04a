//! Null geodesics of Kerr in closed form, with real arithmetic, for cameras outside the horizon.
//!
//! In Mino time the motions in u = 1/r and in latitude are independent (see
//! `geometry::mino`), and the right-hand side of each is a quartic. [`Radial`] gives
//! the time at which the ray is at infinity as one or two of Carlson's R_F, and u at any time by
//! Weierstrass's function; [`Polar`] gives the place on the sphere. The dragging of the azimuth by
//! the radial motion is the one integral that is left. Its value at the turning point, or at the
//! point that the ray lingers at, is taken out, so that it does not grow next to the critical curve.

use super::polar::Polar;
use super::radial::{Centre, Radial};
use glam::{DMat3, DVec3};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::mino::{PhotonConstants, PhotonState};
use lightfall_core::geometry::quadrature::integral_on_scale;

/// A leg of a ray: the stretch between two square roots of the distance from a centre.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Leg {
    centre: Centre,
    from: f64,
    to: f64,
}

/// A backward ray in closed form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ClosedRay {
    start: PhotonState,
    /// The motion in u.
    pub(super) radial: Radial,
    /// The motion in latitude.
    pub(super) polar: Polar,
}

impl ClosedRay {
    /// The ray with these constants from `start` on.
    pub(super) fn new(kerr: Kerr, constants: &PhotonConstants, start: PhotonState) -> Self {
        Self {
            start,
            radial: Radial::new(kerr, constants, [start.u, start.du]),
            polar: Polar::new(constants, &start),
        }
    }

    /// Whether the ray reaches infinity, for a camera outside the horizon.
    pub(super) fn escapes(&self) -> bool {
        match self.radial.barrier {
            Some(top) => self.start.u < top,
            None => self.start.du < 0.0,
        }
    }

    /// The Mino time to infinity, of a ray that escapes.
    pub(super) fn time_to_infinity(&self) -> f64 {
        let (u, du) = (self.start.u, self.start.du);
        let direct = || {
            self.radial
                .time_between([u, -du], [0.0, self.radial.energy])
        };
        if self.radial.barrier.is_none() {
            return direct();
        }
        let turn = self.radial.turning_point();
        let near = self.distance(&turn);
        let time_to = |y| self.radial.time_from_turn(&turn, y);
        if du > 0.0 {
            time_to(near) + time_to(turn.u)
        } else if near < 0.25 * turn.u {
            // Next to the turning point the direct form is a small difference.
            time_to(turn.u) - time_to(near)
        } else {
            direct()
        }
    }

    /// The camera's distance from a turning point, from its speed.
    fn distance(&self, turn: &Centre) -> f64 {
        let [_, c1, c2, c3, c4] = turn.c;
        let mut y = (turn.u - self.start.u).max(0.0);
        if y < 0.25 * turn.u {
            let f = self.start.du * self.start.du;
            for _ in 0..3 {
                let value = y * (c1 + y * (c2 + y * (c3 + y * c4))) - f;
                y -= value / (c1 + y * (2.0 * c2 + y * (3.0 * c3 + 4.0 * y * c4)));
            }
        }
        y.max(f64::MIN_POSITIVE)
    }

    /// The u at which the ray moves slowest, and the legs to infinity.
    fn legs_to_infinity(&self) -> (f64, Vec<Leg>) {
        let (u, du) = (self.start.u, self.start.du);
        let leg = |centre: Centre, from: f64, to: f64| Leg {
            centre,
            from: from.sqrt(),
            to: to.sqrt(),
        };
        if self.radial.barrier.is_some() {
            let turn = self.radial.turning_point();
            let near = self.distance(&turn);
            let legs = if du > 0.0 {
                vec![leg(turn, 0.0, near), leg(turn, 0.0, turn.u)]
            } else {
                vec![leg(turn, near, turn.u)]
            };
            return (turn.u, legs);
        }
        let base = self.radial.base;
        let outer = self.radial.critical_point(1.0);
        let legs = if u > base {
            let inner = self.radial.critical_point(-1.0);
            vec![leg(inner, 0.0, u - base), leg(outer, 0.0, base)]
        } else {
            vec![leg(outer, base - u, base)]
        };
        // The dragging at the critical point has no bound where that is next to the horizon.
        (base.min(u), legs)
    }

    /// The dragging of the azimuth on the way to infinity, which takes the Mino time `t`.
    fn dragging_to_infinity(&self, t: f64) -> f64 {
        let (centre, legs) = self.legs_to_infinity();
        let at_centre = self.radial.dragging(centre);
        legs.iter().fold(at_centre * t, |sum, leg| {
            let rate = |x: f64| {
                let u = leg.centre.u - leg.centre.side * x * x;
                (self.radial.dragging(u) - at_centre) * leg.centre.weight(x)
            };
            sum + integral_on_scale(1e-3, leg.from, leg.to, &rate)
        })
    }

    /// The unit vector toward the place at infinity that the ray comes from.
    pub(super) fn sky(&self) -> Option<DVec3> {
        if !self.escapes() || self.radial.energy <= 0.0 {
            return None;
        }
        let t = self.time_to_infinity();
        let turn = self.start.chi + self.dragging_to_infinity(t);
        Some(DMat3::from_rotation_z(turn) * self.polar.at(t))
    }

    /// u at the ray's crossing of the plane number `index`, on the way to infinity.
    pub(super) fn crossing(&self, index: u32) -> Option<f64> {
        let [first, period] = self.polar.crossing_times()?;
        let (t, end) = (first + f64::from(index) * period, self.time_to_infinity());
        (t < end).then(|| {
            if t < 0.5 * end {
                self.radial.u_after(t, [self.start.u, self.start.du])
            } else {
                self.radial.u_after(end - t, [0.0, self.radial.energy])
            }
        })
    }
}
