//! The equations of a ship's motion.

use super::vectors::axes;
use super::{Controls, Place, VectorConstants};
use crate::geometry::kerr::Kerr;
use glam::{DMat4, DVec3, DVec4, Vec4Swizzles};

/// How many numbers a [`State`] has.
pub(super) const NUMBERS: usize = 23;

/// The numbers of a state that belong to the place: T, then x, y and z.
pub(super) const PLACE: std::ops::Range<usize> = 1..4;

/// The numbers of a state that belong to the axes.
pub(super) const AXES: std::ops::Range<usize> = 4..20;

/// Place, axes and the work of the engine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State {
    /// T and x, y, z, in r_s.
    pub(super) place: DVec4,
    /// The four-velocity and the three axes on the Kerr-Schild frame, one per column.
    pub(super) frame: DMat4,
    /// What the engine added to E, L and K'.
    pub(super) work: DVec3,
}

impl State {
    /// The state as numbers.
    pub(super) fn numbers(&self) -> [f64; NUMBERS] {
        let mut numbers = [0.0; NUMBERS];
        self.place.write_to_slice(&mut numbers);
        self.frame.write_cols_to_slice(&mut numbers[AXES]);
        self.work.write_to_slice(&mut numbers[AXES.end..]);
        numbers
    }

    /// The state of these numbers.
    pub(super) fn of_numbers(numbers: &[f64; NUMBERS]) -> Self {
        Self {
            place: DVec4::from_slice(numbers),
            frame: DMat4::from_cols_slice(&numbers[AXES]),
            work: DVec3::from_slice(&numbers[AXES.end..]),
        }
    }

    /// The derivative by the ship's proper time.
    ///
    /// With phi_b = H l_b (l.u) and F_bc = d_b phi_c - d_c phi_b, u held fixed, gravity acts on the
    /// axes like an electromagnetic field: dLambda = eta F Lambda + Lambda Omega, where Omega has
    /// the acceleration and the rotation that the pilot sets (Misner, Thorne & Wheeler 1973 eq.
    /// 6.14 for the latter: Fermi-Walker transport and rotation). dX^mu = u^mu - H (l.u) l^mu. The
    /// former is the spin connection of a Kerr-Schild metric (Debney, Kerr & Schild 1969).
    ///
    /// The field's electric part is g = (l.u) dH + H d(l.u), and its magnetic part g x l + H (l.u)
    /// curl l. Since l depends on the place also through r, d_c l_j = s_j d_c r + K_cj with s the
    /// derivative by r alone.
    pub(super) fn rate(&self, kerr: Kerr, controls: &Controls) -> Self {
        let place = Place::new(kerr, self.place.yzw());
        let [u, e1, e2, e3] = axes(&self.frame);
        let (electric, magnetic) = field(&place, u);
        let carried = |p: DVec4| {
            let space = p.yzw();
            DVec4::from((electric.dot(space), p.x * electric + space.cross(magnetic)))
        };
        let (push, turn) = (controls.acceleration, controls.rotation);
        let thrust = push.x * e1 + push.y * e2 + push.z * e3;
        let frame = DMat4::from_cols(
            carried(u) + thrust,
            carried(e1) + push.x * u + turn.z * e2 - turn.y * e3,
            carried(e2) + push.y * u + turn.x * e3 - turn.z * e1,
            carried(e3) + push.z * u + turn.y * e1 - turn.x * e2,
        );
        Self {
            place: place.contravariant(u),
            frame,
            work: if push == DVec3::ZERO {
                DVec3::ZERO
            } else {
                power(&place, u, thrust)
            },
        }
    }
}

/// The electric and the magnetic part of gravity's field for the four-velocity `u`.
fn field(place: &Place, u: DVec4) -> (DVec3, DVec3) {
    let (a, r, l, rho2) = (place.kerr.a(), place.r, place.n, place.rho2());
    let DVec3 { x, y, z } = place.position;
    let (grad_r, velocity) = (place.gradient_of_r(), u.yzw());
    let along = place.along_null(u);
    let denominator = r * r * place.sigma();
    // dH/H = (3/r - 4 r^3/(r^4 + a^2 z^2)) dr - 2 a^2 z/(r^4 + a^2 z^2) dz.
    let grad_h = (3.0 / r - 4.0 * r.powi(3) / denominator) * grad_r
        - 2.0 * a * a * z / denominator * DVec3::Z;
    let s = DVec3::new(
        (x - 2.0 * r * l.x) / rho2,
        (y - 2.0 * r * l.y) / rho2,
        -z / (r * r),
    );
    let explicit = DVec3::new(
        (r * velocity.x - a * velocity.y) / rho2,
        (a * velocity.x + r * velocity.y) / rho2,
        velocity.z / r,
    );
    let grad_along = velocity.dot(s) * grad_r + explicit;
    let electric = place.h * (along * grad_h + grad_along);
    let curl = grad_r.cross(s) - 2.0 * a / rho2 * DVec3::Z;
    (electric, electric.cross(l) + place.h * along * curl)
}

/// What the acceleration alpha adds to E, L and K' per proper time: E(alpha), L(alpha) and 2
/// c(u).c(alpha). Derived: the first two are Killing's symmetries, and K' is the square of c.
fn power(place: &Place, u: DVec4, alpha: DVec4) -> DVec3 {
    let (of_u, of_alpha) = (
        VectorConstants::new(place, u),
        VectorConstants::new(place, alpha),
    );
    let carter = of_u.carter_vector(place).dot(of_alpha.carter_vector(place));
    // The part of the mass does not change: u.alpha = 0.
    DVec3::new(of_alpha.energy, of_alpha.angular_momentum, 2.0 * carter)
}
