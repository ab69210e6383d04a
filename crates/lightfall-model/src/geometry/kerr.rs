//! The Kerr geometry: special radii and metric functions, in units of r_s.

/// The hole's mass, in units of r_s.
pub const MASS: f64 = 0.5;

/// A Kerr hole. *Prograde* means toward growing phi, in which direction the disk rotates, whatever
/// the sign of the spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kerr {
    /// chi = a/M, in (-1, 1); positive where the hole rotates with the disk.
    pub spin: f64,
}

impl Kerr {
    /// a = chi M, in r_s.
    pub fn a(self) -> f64 {
        self.spin * MASS
    }

    /// The outer horizon: r_+ = M (1 + sqrt(1 - chi^2)). Bardeen, Press & Teukolsky 1972, section
    /// II.
    pub fn horizon(self) -> f64 {
        MASS * (1.0 + ((1.0 - self.spin) * (1.0 + self.spin)).sqrt())
    }

    /// The inner horizon, from r_+ r_- = a^2, which has no cancellation at small spin.
    pub fn inner_horizon(self) -> f64 {
        self.a().powi(2) / self.horizon()
    }

    /// The static limit: r = M (1 + sqrt(1 - chi^2 cos^2 theta)), where -g_tt = 0. Bardeen, Press &
    /// Teukolsky 1972, section II.
    pub fn static_limit(self, cos_theta: f64) -> f64 {
        let c = self.spin * cos_theta;
        MASS * (1.0 + ((1.0 - c) * (1.0 + c)).sqrt())
    }

    /// Delta = (r - r_+)(r - r_-), in r_s^2.
    pub fn delta(self, r: f64) -> f64 {
        (r - self.horizon()) * (r - self.inner_horizon())
    }

    /// Sigma = r^2 + a^2 cos^2 theta, in r_s^2.
    pub fn sigma(self, r: f64, cos_theta: f64) -> f64 {
        r * r + (self.a() * cos_theta).powi(2)
    }

    /// A = (r^2 + a^2)^2 - a^2 Delta sin^2 theta = Sigma (r^2 + a^2) + 2 M r a^2 sin^2 theta, in
    /// r_s^4. Bardeen, Press & Teukolsky 1972 eq. 2.5; the second form has no cancellation.
    pub fn area(self, r: f64, (sin_theta, cos_theta): (f64, f64)) -> f64 {
        let a2 = self.a().powi(2);
        self.sigma(r, cos_theta) * (r * r + a2) + 2.0 * MASS * r * a2 * sin_theta * sin_theta
    }

    /// Kerr's ingoing azimuth minus Boyer-Lindquist's: the integral of a/Delta dr, (a / (r_+ -
    /// r_-)) ln|(r - r_+) / (r - r_-)|, zero at infinity. Misner, Thorne & Wheeler 1973 box 33.2.
    pub fn ingoing_azimuth_lead(self, r: f64) -> f64 {
        let (outer, inner) = (self.horizon(), self.inner_horizon());
        self.a() / (outer - inner) * ((r - outer) / (r - inner)).abs().ln()
    }

    /// Kerr's ingoing time v minus Boyer-Lindquist's t: the integral of (r^2 + a^2)/Delta dr, r +
    /// (r_+ ln|r - r_+| - r_- ln|r - r_-|) / (r_+ - r_-) with 2M = 1. Misner, Thorne & Wheeler 1973
    /// box 33.2.
    pub fn ingoing_time_lead(self, r: f64) -> f64 {
        let (outer, inner) = (self.horizon(), self.inner_horizon());
        // Without spin the inner horizon is at zero and its term vanishes.
        let inner_term = if inner > 0.0 {
            inner * (r - inner).abs().ln()
        } else {
            0.0
        };
        r + (outer * (r - outer).abs().ln() - inner_term) / (outer - inner)
    }

    /// The lead of Kerr's ingoing azimuth over that of a camera at `r`, which is Boyer-Lindquist's
    /// outside the horizon, and the ingoing one itself at and inside it.
    pub fn camera_azimuth_lead(self, r: f64) -> f64 {
        if r > self.horizon() {
            self.ingoing_azimuth_lead(r)
        } else {
            0.0
        }
    }

    /// The same of the time: the lead of Kerr's ingoing time over that of a camera at `r`.
    pub fn camera_time_lead(self, r: f64) -> f64 {
        if r > self.horizon() {
            self.ingoing_time_lead(r)
        } else {
            0.0
        }
    }

    /// The prograde equatorial photon orbit: r = 2M (1 + cos((2/3) arccos(-chi))), written as a
    /// square. Bardeen, Press & Teukolsky 1972 eq. 2.18.
    pub fn photon_orbit_prograde(self) -> f64 {
        4.0 * MASS * ((-self.spin).acos() / 3.0).cos().powi(2)
    }

    /// The retrograde equatorial photon orbit: the prograde one of the hole with the opposite spin.
    pub fn photon_orbit_retrograde(self) -> f64 {
        Kerr { spin: -self.spin }.photon_orbit_prograde()
    }

    /// The photon orbit with L = 0, which passes over both poles: r = M (1 + 2 sqrt(1 - chi^2/3)
    /// cos((1/3) arccos((1 - chi^2) / (1 - chi^2/3)^(3/2)))). Derived by setting the angular
    /// momentum of the spherical photon orbits (Teo 2003) to zero.
    pub fn photon_orbit_polar(self) -> f64 {
        let third = 1.0 - self.spin.powi(2) / 3.0;
        let cosine = (1.0 - self.spin) * (1.0 + self.spin) / third.powf(1.5);
        MASS * (1.0 + 2.0 * third.sqrt() * (cosine.min(1.0).acos() / 3.0).cos())
    }

    /// The innermost stable circular orbit of matter that rotates with the disk. Bardeen, Press &
    /// Teukolsky 1972 eq. 2.21, with p = (1 + chi)^(1/3), q = (1 - chi)^(1/3):
    ///
    /// Z1 = 1 + p q (p + q),  Z2 = sqrt(3 chi^2 + Z1^2),  r = M (3 + Z2 - s),  s = +-sqrt((3 -
    /// Z1)(3 + Z1 + 2 Z2)).
    ///
    /// Since p^3 + q^3 = 2, 3 - Z1 = (p + q)(p - q)^2, which has no cancellation at small spin and
    /// gives s the sign of the spin. Since (3 + Z2)^2 - s^2 = (Z1 + Z2)^2, the difference can be
    /// written as a quotient for positive spin.
    pub fn isco(self) -> f64 {
        let (p, q) = ((1.0 + self.spin).cbrt(), (1.0 - self.spin).cbrt());
        let z1 = 1.0 + p * q * (p + q);
        let z2 = (3.0 * self.spin.powi(2) + z1 * z1).sqrt();
        let p_minus_q = 2.0 * self.spin / (p * p + p * q + q * q);
        let s = p_minus_q * ((p + q) * (3.0 + z1 + 2.0 * z2)).sqrt();
        if s > 0.0 {
            MASS * (z1 + z2).powi(2) / (3.0 + z2 + s)
        } else {
            MASS * (3.0 + z2 - s)
        }
    }

    /// The prograde circular geodesic of radius `r` in the equatorial plane. `None` at and inside
    /// the photon orbit, where it is not timelike.
    pub fn circular_orbit(self, r: f64) -> Option<CircularOrbit> {
        let (chi, y) = (self.spin, (MASS / r).sqrt());
        // 1 - 3 y^2 + 2 chi y^3, in a form without cancellation for chi -> 1, r -> M.
        let one_minus_y = (r - MASS) / r / (1.0 + y);
        let square = one_minus_y.powi(2) * (1.0 + 2.0 * y) - 2.0 * (1.0 - chi) * y.powi(3);
        if !(r > self.photon_orbit_prograde() && square > 0.0) {
            return None;
        }
        let (norm, y3) = (square.sqrt(), y.powi(3));
        Some(CircularOrbit {
            angular_velocity: y3 / (MASS * (1.0 + chi * y3)),
            u_t: (1.0 + chi * y3) / norm,
            energy: (1.0 - 2.0 * y * y + chi * y3) / norm,
            angular_momentum: MASS / y * (1.0 - 2.0 * chi * y3 + (chi * y * y).powi(2)) / norm,
        })
    }
}

/// A prograde circular geodesic in the equatorial plane, per unit rest mass. With y = sqrt(M/r),
/// Bardeen, Press & Teukolsky 1972 eqs. 2.12, 2.13 and 2.16.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircularOrbit {
    /// Omega = dphi/dt = y^3 / (M (1 + chi y^3)), in 1/r_s.
    pub angular_velocity: f64,
    /// u^t = (1 + chi y^3) / sqrt(1 - 3 y^2 + 2 chi y^3).
    pub u_t: f64,
    /// E = -u_t (covariant) = (1 - 2 y^2 + chi y^3) / sqrt(1 - 3 y^2 + 2 chi y^3).
    pub energy: f64,
    /// L = u_phi = (M/y) (1 - 2 chi y^3 + chi^2 y^4) / sqrt(1 - 3 y^2 + 2 chi y^3), in r_s.
    pub angular_momentum: f64,
}
