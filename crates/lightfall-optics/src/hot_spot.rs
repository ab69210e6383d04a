//! A hot spot in the disk: its place at a time, and its effect on the flux. The twin in WGSL is
//! shaders/disk/hot_spot/spot.wgsl.

use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::sphere::wrap_angle;
use lightfall_model::scene::{self, HotSpotKind, Scene};
use std::f64::consts::{PI, TAU};

/// The finest structure of a sheared spot, as a share of the radius.
///
/// A sheared spot becomes an arc that winds up and gets ever thinner. In a real disk turbulence
/// mixes thin windings, and neither a picture nor f32 could resolve them. So orbits within this
/// share of the radius are mixed: the arc gets no thinner, its windings fade into each other, and
/// after some ten orbits a ring is left. The mean along each orbit does not change.
pub const FINEST_SHEARED: f64 = 0.02;

/// The scene's hot spot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HotSpot {
    kerr: Kerr,
    spot: scene::HotSpot,
    angular_velocity: f64,
}

impl HotSpot {
    /// The scene's hot spot; `None` if it has none, or if no matter can orbit there.
    pub fn new(scene: &Scene) -> Option<Self> {
        let kerr = scene.kerr();
        let there = scene.disk.enabled && scene.hot_spot.kind != HotSpotKind::None;
        let orbit = there
            .then(|| kerr.circular_orbit(scene.hot_spot.r))
            .flatten()?;
        Some(Self {
            kerr,
            spot: scene.hot_spot,
            angular_velocity: orbit.angular_velocity,
        })
    }

    /// Radius of the spot's middle, in r_s.
    pub fn r(&self) -> f64 {
        self.spot.r
    }

    /// Angular velocity of the spot's middle, in radians per r_s/c.
    pub fn angular_velocity(&self) -> f64 {
        self.angular_velocity
    }

    /// The period of the spot's middle, in r_s/c.
    pub fn period(&self) -> f64 {
        TAU / self.angular_velocity
    }

    /// Boyer-Lindquist azimuth of the spot's middle at the Boyer-Lindquist time `t` (r_s/c), in
    /// (-pi, pi].
    pub fn azimuth(&self, t: f64) -> f64 {
        let turned = self.angular_velocity * (t - self.spot.time);
        wrap_angle(self.spot.phi_deg.to_radians() + turned)
    }

    /// The ratio of the flux of matter at (`r`, `phi`) to that of the disk alone, at the time `t`
    /// (r_s/c):
    ///
    /// 1 + strength exp(-(t - t_s)^2 / (2 d^2)) exp(-x^2 / (2 w^2)) exp(-psi^2 / (2 w^2)),
    /// x = ln(r / r_s), psi = phi - phi_s - Omega (t - t_s) less whole turns,
    ///
    /// with Omega of the spot's middle. A sheared spot has Omega(r) instead, averaged over orbits
    /// within [`FINEST_SHEARED`]: the last factor is then a Gaussian with the variance v = w^2 +
    /// (`FINEST_SHEARED` (t - t_s) dOmega/dx)^2 and the height w / sqrt(v), summed over all turns.
    pub fn factor(&self, r: f64, phi: f64, t: f64) -> f64 {
        let scene::HotSpot { size, duration, .. } = self.spot;
        let since = t - self.spot.time;
        let x = (r / self.spot.r).ln();
        let (omega, v) = match self.spot.kind {
            HotSpotKind::Sheared => {
                let omega = self
                    .kerr
                    .circular_orbit(r)
                    .map_or(0.0, |orbit| orbit.angular_velocity);
                // dOmega/dx = -(3/2) Omega / (1 + chi y^3), and 1 / (1 + chi y^3) = 1 - a Omega.
                let shear = 1.5 * omega * (1.0 - self.kerr.a() * omega);
                (
                    omega,
                    size * size + (FINEST_SHEARED * shear * since).powi(2),
                )
            }
            HotSpotKind::Rigid | HotSpotKind::None => (self.angular_velocity, size * size),
        };
        let psi = wrap_angle(phi - self.spot.phi_deg.to_radians() - omega * since);
        let along = size / v.sqrt() * gaussian_on_circle(psi, v);
        let across = (-0.5 * (x / size).powi(2)).exp();
        let envelope = if duration > 0.0 {
            (-0.5 * (since / duration).powi(2)).exp()
        } else {
            1.0
        };
        1.0 + self.spot.strength * envelope * across * along
    }
}

/// The sum of exp(-psi^2 / (2 v)) over all turns of `psi`, which is in (-pi, pi]: over turns where
/// they are narrow, else over waves, by Poisson's formula.
fn gaussian_on_circle(psi: f64, v: f64) -> f64 {
    if v < PI {
        let turn = |n: i32| (-0.5 * (psi + TAU * f64::from(n)).powi(2) / v).exp();
        (-4..=4).map(turn).sum()
    } else {
        let wave = |m: i32| {
            let m = f64::from(m);
            2.0 * (-0.5 * m * m * v).exp() * (m * psi).cos()
        };
        (v / TAU).sqrt() * (1.0 + (1..=4).map(wave).sum::<f64>())
    }
}
