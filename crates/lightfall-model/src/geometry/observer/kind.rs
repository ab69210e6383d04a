//! The kinds of observer, and where each of them can be.

use super::ObserverError;
use crate::geometry::kerr::Kerr;
use crate::geometry::sphere::polar_sin_cos;
use std::f64::consts::FRAC_PI_2;

/// Largest angle from the equatorial plane at which a place counts as in it, in radians: rounding
/// of degrees stays well below, and no picture shows it.
const IN_PLANE: f64 = 1e-9;

crate::words! {
    /// The kinds of observer. Of those that exist off the equatorial plane, each reaches closer to
    /// the hole than the previous one.
    pub enum ObserverKind {
        /// Hovers at one place; not possible very near a spinning hole.
        Static = "static": "At rest",
        /// Hovers at one distance, and is carried round by the hole's spin.
        Zamo = "zamo": "Zero angular momentum",
        /// Circles freely in the plane of the disk.
        Orbit = "orbit": "Circular orbit",
        /// Falls freely from far away; the only one inside the horizon.
        Rain = "rain": "Free fall",
    }
}

/// The properties of a kind of observer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObserverProperties {
    /// How it moves, in two or three words.
    pub motion: &'static str,
    /// The same where there is room for more.
    pub motion_in_full: &'static str,
    /// Whether no force holds it.
    pub falls_freely: bool,
    /// Whether it exists in the equatorial plane only.
    pub equatorial: bool,
    /// The surface outside which it exists.
    pub limit: Limit,
}

/// A surface around the hole, outside of which an observer of some kind exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The edge of the ergosphere: nothing is at rest inside.
    StaticLimit,
    /// The outer horizon: nothing stays outside once inside.
    Horizon,
    /// The prograde photon orbit: a circular orbit inside would be faster than light.
    PhotonOrbit,
    /// The inner horizon, as far as the free fall from infinity is followed.
    InnerHorizon,
}

impl Limit {
    /// The radius of the surface, in r_s, at a place whose angle from the axis has this cosine.
    pub fn radius(self, kerr: Kerr, cos_theta: f64) -> f64 {
        match self {
            Self::StaticLimit => kerr.static_limit(cos_theta),
            Self::Horizon => kerr.horizon(),
            Self::PhotonOrbit => kerr.photon_orbit_prograde(),
            Self::InnerHorizon => kerr.inner_horizon(),
        }
    }
}

impl ObserverKind {
    /// The properties of this kind: a new kind is a new row.
    pub const fn properties(self) -> ObserverProperties {
        match self {
            Self::Static => ObserverProperties {
                motion: "hovering at rest",
                motion_in_full: "hovering at rest",
                falls_freely: false,
                equatorial: false,
                limit: Limit::StaticLimit,
            },
            Self::Zamo => ObserverProperties {
                motion: "zero angular momentum",
                motion_in_full: "zero angular momentum",
                falls_freely: false,
                equatorial: false,
                limit: Limit::Horizon,
            },
            Self::Orbit => ObserverProperties {
                motion: "in orbit",
                motion_in_full: "circular orbit",
                falls_freely: true,
                equatorial: true,
                limit: Limit::PhotonOrbit,
            },
            Self::Rain => ObserverProperties {
                motion: "falling freely",
                motion_in_full: "free fall from far away",
                falls_freely: true,
                equatorial: false,
                limit: Limit::InnerHorizon,
            },
        }
    }

    /// Checks that an observer of this kind exists at radius `r` (r_s) and polar angle `theta`
    /// (radians).
    ///
    /// # Errors
    /// The place is at or within the inner horizon, which without spin is the centre; or at or within
    /// the kind's own limit; or off the plane of an equatorial kind.
    pub fn check_place(self, kerr: Kerr, r: f64, theta: f64) -> Result<(), ObserverError> {
        let ObserverProperties {
            limit, equatorial, ..
        } = self.properties();
        let inner = Limit::InnerHorizon.radius(kerr, 0.0);
        if r <= inner {
            return Err(ObserverError::TooDeep { r, inner });
        }
        let radius = limit.radius(kerr, polar_sin_cos(theta).1);
        if r > radius {
            if equatorial && (theta - FRAC_PI_2).abs() > IN_PLANE {
                return Err(ObserverError::OffPlane {
                    theta_deg: theta.to_degrees(),
                });
            }
            return Ok(());
        }
        Err(match limit {
            Limit::StaticLimit => ObserverError::Static { r, limit: radius },
            Limit::Horizon => ObserverError::Zamo { r, horizon: radius },
            Limit::PhotonOrbit => ObserverError::Orbit {
                r,
                photon_orbit: radius,
            },
            Limit::InnerHorizon => ObserverError::TooDeep { r, inner: radius },
        })
    }
}

/// The smallest radius that motion reaches, in r_s: nine tenths of the way from the outer horizon
/// to the inner one, which without spin is the centre. Farther in, the tide grows without bound.
/// With spin, the blueshift of matter that falls in with the hole's rotation grows too, as
/// 1/|Delta|. The inner horizon of a real hole is not that of a vacuum (Poisson & Israel 1990).
pub fn min_infall_radius(kerr: Kerr) -> f64 {
    0.9 * kerr.inner_horizon() + 0.1 * kerr.horizon()
}
