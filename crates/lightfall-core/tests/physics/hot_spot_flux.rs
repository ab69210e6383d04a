//! The light of a hot spot in f64. The twin in WGSL is shaders/disk/hot_spot/spot.wgsl.

use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::geometry::sphere::wrap_angle;
use lightfall_core::optics::hot_spot::{FINEST_SHEARED, HotSpot};
use lightfall_core::scene::{self, HotSpotKind, Scene};
use std::f64::consts::{PI, TAU};
use std::ops::Deref;

/// A hot spot with its flux.
pub(crate) struct HotSpotFlux {
    spot: HotSpot,
    fields: scene::HotSpot,
    kerr: Kerr,
}

impl Deref for HotSpotFlux {
    type Target = HotSpot;

    fn deref(&self) -> &HotSpot {
        &self.spot
    }
}

impl HotSpotFlux {
    /// That of the scene, which has one.
    pub(crate) fn new(scene: &Scene) -> Self {
        Self {
            spot: HotSpot::new(scene).unwrap(),
            fields: scene.hot_spot,
            kerr: scene.kerr(),
        }
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
    pub(crate) fn factor(&self, r: f64, phi: f64, t: f64) -> f64 {
        let scene::HotSpot { size, duration, .. } = self.fields;
        let since = t - self.fields.time;
        let x = (r / self.fields.r).ln();
        let (omega, v) = match self.fields.kind {
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
            HotSpotKind::Rigid | HotSpotKind::None => (self.spot.angular_velocity(), size * size),
        };
        let psi = wrap_angle(phi - self.fields.phi_deg.to_radians() - omega * since);
        let along = size / v.sqrt() * gaussian_on_circle(psi, v);
        let across = (-0.5 * (x / size).powi(2)).exp();
        let envelope = if duration > 0.0 {
            (-0.5 * (since / duration).powi(2)).exp()
        } else {
            1.0
        };
        1.0 + self.fields.strength * envelope * across * along
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
