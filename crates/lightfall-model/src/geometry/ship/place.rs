//! Places in ingoing Kerr-Schild coordinates.

use crate::geometry::kerr::{Kerr, MASS};
use glam::{DVec3, DVec4, Vec4Swizzles};

/// A place in ingoing Kerr-Schild coordinates, with the metric there: g = eta + 2 H l l.
///
/// With rho^2 = r^2 + a^2, l_mu = (1, (r x + a y)/rho^2, (r y - a x)/rho^2, z/r). Its spatial part
/// is n, the place on the celestial sphere whose azimuth is Kerr's ingoing one, since
/// x + i y = (r + i a) (n_x + i n_y) and z = r n_z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The hole.
    pub kerr: Kerr,
    /// x, y, z, in r_s.
    pub position: DVec3,
    /// Boyer-Lindquist radius, in r_s.
    pub r: f64,
    /// Unit vector on the celestial sphere, toward theta and Kerr's ingoing azimuth; the spatial
    /// part of l.
    pub n: DVec3,
    /// H = M r^3/(r^4 + a^2 z^2) = M r/Sigma.
    pub h: f64,
}

impl Place {
    /// The place with these coordinates: r^2 = (b + sqrt(b^2 + 4 a^2 z^2))/2 with b = x^2 + y^2 +
    /// z^2 - a^2, where a negative b is taken without cancellation.
    pub fn new(kerr: Kerr, position: DVec3) -> Self {
        let a = kerr.a();
        let az = a * position.z;
        let b = position.length_squared() - a * a;
        let root = b.hypot(2.0 * az);
        let r2 = if b >= 0.0 {
            0.5 * (b + root)
        } else {
            2.0 * az * az / (root - b)
        };
        let r = r2.sqrt();
        let DVec3 { x, y, z } = position;
        let rho2 = r2 + a * a;
        let n = DVec3::new((r * x + a * y) / rho2, (r * y - a * x) / rho2, z / r);
        Self {
            kerr,
            position,
            r,
            n,
            h: MASS * r / (r2 + (a * n.z).powi(2)),
        }
    }

    /// The place at radius `r` (r_s) and the unit vector `n` on the celestial sphere.
    pub fn at(kerr: Kerr, r: f64, n: DVec3) -> Self {
        Self {
            kerr,
            position: spread(kerr.a(), r, n),
            r,
            n,
            h: MASS * r / kerr.sigma(r, n.z),
        }
    }

    /// Sigma, in r_s^2.
    pub fn sigma(&self) -> f64 {
        self.kerr.sigma(self.r, self.n.z)
    }

    /// r^2 + a^2, in r_s^2.
    pub fn rho2(&self) -> f64 {
        self.r * self.r + self.kerr.a().powi(2)
    }

    /// The area of [`Kerr::area`], in r_s^4.
    pub fn area(&self) -> f64 {
        self.kerr.area(self.r, (self.sin_theta(), self.n.z))
    }

    /// The sine of the polar angle.
    pub fn sin_theta(&self) -> f64 {
        self.n.truncate().length()
    }

    /// The polar angle, in radians.
    pub fn theta(&self) -> f64 {
        self.sin_theta().atan2(self.n.z)
    }

    /// Kerr's ingoing azimuth, in radians; `None` on the axis.
    pub fn azimuth(&self) -> Option<f64> {
        (self.n.x != 0.0 || self.n.y != 0.0).then(|| self.n.y.atan2(self.n.x))
    }

    /// z^ x n, which is sin(theta) times the unit vector toward growing azimuth.
    pub fn around(&self) -> DVec3 {
        DVec3::new(-self.n.y, self.n.x, 0.0)
    }

    /// l.p, of a vector with components on the frame. It is the same for coordinate components.
    pub fn along_null(&self, p: DVec4) -> f64 {
        p.x + self.n.dot(p.yzw())
    }

    /// l with its index raised.
    fn raised_null(&self) -> DVec4 {
        DVec4::new(-1.0, self.n.x, self.n.y, self.n.z)
    }

    /// The components on the frame of a vector with these coordinate components (T, x, y, z).
    pub fn on_frame(&self, q: DVec4) -> DVec4 {
        q + self.h * self.along_null(q) * self.raised_null()
    }

    /// The coordinate components (T, x, y, z) of a vector on the frame.
    pub fn contravariant(&self, p: DVec4) -> DVec4 {
        p - self.h * self.along_null(p) * self.raised_null()
    }

    /// The covariant coordinate components (T, x, y, z) of a vector on the frame.
    pub fn covariant(&self, p: DVec4) -> DVec4 {
        let l = DVec4::new(1.0, self.n.x, self.n.y, self.n.z);
        DVec4::new(-p.x, p.y, p.z, p.w) + self.h * self.along_null(p) * l
    }

    /// The gradient of r: (x r^3, y r^3, z r (r^2 + a^2))/(r^4 + a^2 z^2).
    pub fn gradient_of_r(&self) -> DVec3 {
        let DVec3 { x, y, z } = self.position;
        let r2 = self.r * self.r;
        DVec3::new(x * r2, y * r2, z * self.rho2()) / (self.r * self.sigma())
    }

    /// The coordinate vector (x, y, z) of a vector of the celestial sphere: B = R D, the rotation
    /// about z by atan2(a, r) times diag(rho, rho, r).
    pub fn spread(&self, v: DVec3) -> DVec3 {
        spread(self.kerr.a(), self.r, v)
    }

    /// The transpose of [`spread`](Self::spread), which takes a covector (p_x, p_y, p_z) to the
    /// celestial sphere.
    pub fn gather(&self, p: DVec3) -> DVec3 {
        let (a, r) = (self.kerr.a(), self.r);
        DVec3::new(r * p.x + a * p.y, r * p.y - a * p.x, r * p.z)
    }
}

fn spread(a: f64, r: f64, v: DVec3) -> DVec3 {
    DVec3::new(r * v.x - a * v.y, a * v.x + r * v.y, r * v.z)
}
