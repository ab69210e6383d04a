//! Constants of the motion of vectors, and vectors from their constants.

use super::Place;
use super::vectors::minkowski;
use crate::geometry::observer::Photon;
use glam::{DVec3, DVec4, Vec4Swizzles};

/// What the symmetries of Kerr's spacetime make of a vector p at a place: its constants, if the
/// vector is carried along a geodesic with itself as the tangent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VectorConstants {
    /// E = -p_T.
    pub energy: f64,
    /// L = x p_y - y p_x, in r_s.
    pub angular_momentum: f64,
    /// V = Sigma p^r, in r_s^2.
    pub radial: f64,
    /// r w: p_theta theta^ + p_phi/sin(theta) phi^ as a Cartesian vector that is tangent to the
    /// celestial sphere, in r_s.
    pub w: DVec3,
    /// -p.p: the mass squared of a momentum.
    pub mass2: f64,
}

impl VectorConstants {
    /// The constants of a vector on the frame. With J = D R^T (p_x, p_y, p_z), r w = J - n (n.J).
    pub fn new(place: &Place, p: DVec4) -> Self {
        let covariant = place.covariant(p);
        let momentum = covariant.yzw();
        let j = place.gather(momentum);
        let DVec3 { x, y, .. } = place.position;
        let velocity = place.contravariant(p).yzw();
        Self {
            energy: -covariant.x,
            angular_momentum: x * momentum.y - y * momentum.x,
            radial: place.sigma() * velocity.dot(place.gradient_of_r()),
            w: j - place.n.dot(j) * place.n,
            mass2: -minkowski(p, p),
        }
    }

    /// c = r w - a E z^ x n, whose square is Carter's constant without the part of the mass.
    pub fn carter_vector(&self, place: &Place) -> DVec3 {
        self.w - place.kerr.a() * self.energy * place.around()
    }

    /// K' = |c|^2 + a^2 n_z^2 m^2, in r_s^2 (Carter 1968).
    pub fn k_prime(&self, place: &Place) -> f64 {
        let height = place.kerr.a() * place.n.z;
        self.carter_vector(place).length_squared() + height * height * self.mass2
    }

    /// Carter's Q = K' - (L - a E)^2, in r_s^2.
    pub fn carter_q(&self, place: &Place) -> f64 {
        let difference = self.angular_momentum - place.kerr.a() * self.energy;
        self.k_prime(place) - difference * difference
    }

    /// P = E (r^2 + a^2) - a L, in r_s^2.
    pub fn p(&self, place: &Place) -> f64 {
        self.energy * place.rho2() - place.kerr.a() * self.angular_momentum
    }

    /// The vector in the form of a photon, at the place's n.
    pub fn photon(&self, place: &Place) -> Photon {
        let r = place.r;
        Photon {
            energy: self.energy,
            radial: self.radial / (r * r),
            w: self.w / r,
        }
    }

    /// h = (P + V)/Delta, the rate of Kerr's ingoing time without its part of the rotation. For
    /// vectors that point inward it is (K' + r^2 m^2)/(P - V), which is regular at the horizon.
    fn ingoing_rate(&self, place: &Place) -> f64 {
        let (p, v) = (self.p(place), self.radial);
        if v <= 0.0 {
            (self.k_prime(place) + place.r * place.r * self.mass2) / (p - v)
        } else {
            (p + v) / place.kerr.delta(place.r)
        }
    }

    /// The vector on the frame. Outward vectors do not exist at the horizon.
    pub fn vector(&self, place: &Place) -> DVec4 {
        let h = self.ingoing_rate(place);
        vector(
            place,
            self.energy,
            self.angular_momentum,
            self.radial,
            self.w,
            h,
        )
    }
}

/// The vector on the frame whose coordinate components (T, x, y, z) are ((r^2 + a^2) h + a (L - a E
/// sin^2) - V, n V + B (r w + a (h - E) z^ x n))/Sigma.
pub(super) fn vector(
    place: &Place,
    energy: f64,
    angular_momentum: f64,
    radial: f64,
    w: DVec3,
    h: f64,
) -> DVec4 {
    let a = place.kerr.a();
    let sin = place.sin_theta();
    let time = place.rho2() * h + a * (angular_momentum - a * energy * sin * sin) - radial;
    let space = radial * place.n + place.spread(w + a * (h - energy) * place.around());
    place.on_frame(DVec4::from((time, space)) / place.sigma())
}
