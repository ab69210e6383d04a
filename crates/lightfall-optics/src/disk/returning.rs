//! Returning radiation: light of the disk that gravity bends back to the disk (Cunningham 1976).
//!
//! The disk absorbs what falls on it and emits it again as thermal light, so the flux at a radius is
//! that of the accretion and that of the light which falls on it. Light is the same on both faces,
//! and the disk is opaque, so only the upper one counts.

use super::returning_table::{DEPTHS, RADII};
use super::{PageThorne, redshift};
use crate::limb::electron_scattering;
use crate::reference::HoleAndDisk;
use crate::trace::Outcome;
use glam::DVec3;
use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::geometry::mino::PhotonConstants;
use lightfall_model::geometry::observer::{ObserverError, ObserverKind, observer_matrix};
use lightfall_model::geometry::quadrature::gauss_legendre;
use lightfall_model::scene::LimbDarkening;
use std::f64::consts::{FRAC_PI_2, PI};

/// Impact parameters, in r_s, between which the sky of a place in the disk is divided into panels:
/// the angle from the hole's direction is this over the radius. They lie close where the images of
/// the inner disk are.
const PANELS: [f64; 9] = [0.8, 1.3, 1.8, 2.2, 2.6, 3.0, 4.0, 6.0, 10.0];

/// How finely the sky of a place in the disk is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Gauss-Legendre nodes in each panel of the angle from the hole's direction.
    pub nodes: usize,
    /// Azimuths about the hole's direction, evenly spaced over half a turn.
    pub azimuths: u32,
}

/// Light that comes down on the disk from one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// The part of the sky that the direction stands for, in steradians.
    pub solid_angle: f64,
    /// Cosine of the angle between the direction and the normal.
    pub cosine: f64,
    /// Where the light comes from.
    pub source: Source,
    /// E = -p_t of the light, per unit frequency for the matter on which it falls.
    pub energy: f64,
    /// L = p_phi of the light, in r_s, per unit frequency for the same matter.
    pub angular_momentum: f64,
}

/// Where light comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// The upper face of the disk.
    Disk {
        /// The radius, in r_s.
        r: f64,
        /// Received over emitted frequency.
        g: f64,
        /// Cosine of the angle of emission.
        mu: f64,
    },
    /// The hole's horizon.
    Hole,
    /// Infinity.
    Sky,
}

/// The light that falls on the disk around a hole of spin `spin` at radius `r` (r_s), from the half
/// of the sky above it. The disk reaches from `inner` (r_s) outward; without one (`None`) nothing
/// is between the sky and the hole.
///
/// The directions are those of an observer with zero angular momentum (ZAMO), who sees the hole
/// straight inward: the angle psi from there and the azimuth xi about it, which is 0 along the orbit
/// and 90 degrees upward. The matter moves along the orbit, so of light that has the frequency w for
/// the matter and 1 for the ZAMO it sees the solid angle sin(psi) dpsi dxi / w^2, and the cosine is
/// sin(psi) sin(xi) / w.
///
/// # Errors
/// No matter can orbit at `r`.
pub fn upper_sky(
    spin: f64,
    inner: Option<f64>,
    r: f64,
    sampling: Sampling,
) -> Result<Vec<Arrival>, ObserverError> {
    let kerr = Kerr { spin };
    let zamo = observer_matrix(spin, ObserverKind::Zamo, [0.0; 3], r, FRAC_PI_2, 0.0)?;
    let orbit = kerr.circular_orbit(r).ok_or_else(|| ObserverError::Orbit {
        r,
        photon_orbit: kerr.photon_orbit_prograde(),
    })?;
    let hole_and_disk = HoleAndDisk {
        kerr,
        annulus: inner.map(|inner| [inner, f64::INFINITY]),
    };
    let width = PI / f64::from(sampling.azimuths);
    let gauss = gauss_legendre(sampling.nodes);
    let ends = PANELS.map(|impact| (impact / r).min(PI));
    let starts = std::iter::once(0.0).chain(ends);
    let panels = starts.zip(ends.into_iter().chain([PI]));
    let mut arrivals = Vec::new();
    for (from, to) in panels.filter(|(from, to)| to > from) {
        for &(node, weight) in &gauss {
            let psi = from + (to - from) * node;
            for i in 0..sampling.azimuths {
                let (up, along) = (width * (f64::from(i) + 0.5)).sin_cos();
                let direction = DVec3::new(-psi.cos(), -psi.sin() * up, psi.sin() * along);
                let photon = zamo.photon(direction);
                let (constants, start) = PhotonConstants::of_photon(kerr, &photon, r, DVec3::X);
                let trace = hole_and_disk.trace(&constants, start);
                let frequency =
                    1.0 / redshift(&orbit, constants.energy, constants.angular_momentum);
                let source = match (trace.hits[0], trace.outcome) {
                    (Some(hit), _) => Source::Disk {
                        r: hit.r,
                        // The trace has the frequency of the ZAMO in the place of the matter's.
                        g: frequency * hit.g,
                        mu: emission_cosine(&constants, hit.r, hit.g),
                    },
                    (None, Outcome::Sky) => Source::Sky,
                    (None, Outcome::Captured | Outcome::Unfinished) => Source::Hole,
                };
                arrivals.push(Arrival {
                    solid_angle: (to - from) * weight * width * psi.sin() / frequency.powi(2),
                    cosine: psi.sin() * up / frequency,
                    source,
                    energy: constants.energy / frequency,
                    angular_momentum: constants.angular_momentum / frequency,
                });
            }
        }
    }
    Ok(arrivals)
}

/// Cosine of the angle of emission: mu = g sqrt(Q)/r (Cunningham 1975).
fn emission_cosine(constants: &PhotonConstants, r: f64, g: f64) -> f64 {
    (g * constants.carter_q().max(0.0).sqrt() / r).min(1.0)
}

impl Arrival {
    /// The arrival's part of the flux on a disk under a sky of the same brightness everywhere:
    /// cos(alpha) dOmega / pi, all of which add up to one.
    pub fn share(&self) -> f64 {
        self.solid_angle * self.cosine / PI
    }

    /// The flux that arrives per unit of flux where the light was emitted, with the radius of that
    /// place; `None` if it does not come from the disk. An intensity F/pi times the `limb` law is
    /// seen with the factor g^4.
    pub fn flux_from_disk(&self, limb: LimbDarkening) -> Option<(f64, f64)> {
        let Source::Disk { r, g, mu } = self.source else {
            return None;
        };
        let darkening = match limb {
            LimbDarkening::None => 1.0,
            LimbDarkening::ElectronScattering => electron_scattering(mu),
        };
        Some((r, self.share() * g.powi(4) * darkening))
    }
}

/// How a disk's light falls back on it.
///
/// All numbers are in units of the flux that the disk would have if its torque did not vanish at the
/// inner edge, N (r_in/r)^3 in the words of [`PageThorne`]. So they are finite at the edge, where the
/// disk's own flux vanishes, and far out they tend to the ratio of the two fluxes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Return {
    /// The disk's own light that falls on each radius of the table.
    own: [f64; RADII],
    /// The light that falls on each radius (row) per unit of light that fell before on the disk about
    /// each radius (column).
    fallen: [[f64; RADII]; RADII],
}

impl Return {
    /// Follows the light that falls on `disk`, for each of the limb `laws`.
    ///
    /// # Errors
    /// No matter can orbit at one of the radii.
    pub fn on_disk<const LAWS: usize>(
        disk: &PageThorne,
        laws: [LimbDarkening; LAWS],
        sampling: Sampling,
    ) -> Result<[Self; LAWS], ObserverError> {
        let inner = disk.inner();
        let mut returns = [Self {
            own: [0.0; RADII],
            fallen: [[0.0; RADII]; RADII],
        }; LAWS];
        for (i, depth) in DEPTHS.nodes.into_iter().enumerate() {
            let x = 1.0 - depth;
            for arrival in upper_sky(disk.spin(), Some(inner), inner / (x * x), sampling)? {
                for (returned, law) in returns.iter_mut().zip(laws) {
                    if let Some((r, flux)) = arrival.flux_from_disk(law) {
                        let source_x = (inner / r).sqrt();
                        returned.own[i] += flux * disk.flux(r) / (disk.scale() * x.powi(6));
                        let ratio = flux * (source_x / x).powi(6);
                        let shares = DEPTHS.shares(1.0 - source_x);
                        for (entry, share) in returned.fallen[i].iter_mut().zip(shares) {
                            *entry += ratio * share;
                        }
                    }
                }
            }
        }
        Ok(returns)
    }

    /// The light that falls on the radii of the table, of which every part fell on the disk `orders`
    /// times at most: F_in = K (F + K (F + ...)), where K takes a flux to the one that falls back.
    pub fn light(&self, orders: u32) -> [f64; RADII] {
        let once_more = |light: [f64; RADII]| {
            std::array::from_fn(|i| {
                let fallen = self.fallen[i].iter().zip(light);
                self.own[i] + fallen.map(|(share, light)| share * light).sum::<f64>()
            })
        };
        (0..orders).fold([0.0; RADII], |light, _| once_more(light))
    }
}
