//! Why an observer cannot exist, each in one sentence.

use thiserror::Error;

/// Why there is no such observer.
#[derive(Clone, Debug, Error, PartialEq)]
#[expect(missing_docs, reason = "the messages say what the fields are")]
pub enum ObserverError {
    /// The spin is not that of a black hole.
    #[error("hole.spin is {0}; it must lie between -1 and 1, both excluded")]
    Spin(f64),
    /// A coordinate of the camera is not a finite number.
    #[error("camera.{field} is {value}; it must be a finite number")]
    Place { field: &'static str, value: f64 },
    /// No observer of any kind is supported so deep inside.
    #[error("camera.r is {r}; it must be greater than {inner:.6}, the inner horizon")]
    TooDeep { r: f64, inner: f64 },
    /// Some effects are defined for an observer outside the horizon only.
    #[error(
        "camera.r is {r}; it must be greater than {horizon:.6}, the horizon, where effects.lensing, aberration, doppler or \
         gravitational_shift is false"
    )]
    Inside { r: f64, horizon: f64 },
    /// Nothing can stand still here.
    #[error(
        "camera.r is {r} with observer.kind = \"static\"; it must be greater than {limit:.6}, the static limit at this \
         camera.theta_deg (\"zamo\" and \"rain\" may go deeper)"
    )]
    Static { r: f64, limit: f64 },
    /// Nothing can stay outside here.
    #[error(
        "camera.r is {r} with observer.kind = \"zamo\"; it must be greater than {horizon:.6}, the horizon (\"rain\" may go \
         deeper)"
    )]
    Zamo { r: f64, horizon: f64 },
    /// There is no timelike circular orbit of this radius.
    #[error(
        "camera.r is {r} with observer.kind = \"orbit\"; it must be greater than {photon_orbit:.6}, the photon orbit"
    )]
    Orbit { r: f64, photon_orbit: f64 },
    /// Circular orbits are in the disk's plane.
    #[error(
        "camera.theta_deg is {theta_deg} with observer.kind = \"orbit\"; it must be 90, the plane of the disk"
    )]
    OffPlane { theta_deg: f64 },
    /// Nothing moves as fast as light.
    #[error(
        "observer.velocity is {velocity:?}; its length must be less than 1, the speed of light"
    )]
    Velocity { velocity: [f64; 3] },
}
