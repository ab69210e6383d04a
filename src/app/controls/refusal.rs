//! Why a change of the scene cannot be drawn, in the words of a player: short, with rounded
//! numbers. The command line has its own sentences, with names of fields and all digits.

use lightfall_core::geometry::observer::ObserverError;
use lightfall_core::gpu::{Drawable, GpuError, Undrawable};
use lightfall_core::numbers::{four_digits, spin_digits, with_short_numbers};
use lightfall_core::optics::sky_picture::SkyPictureError;
use lightfall_core::scene::{ObserverKind, Refusal, Scene, field};
use std::ops::Bound;

/// Makes a changed scene drawable.
///
/// # Errors
/// Why it cannot be drawn, in one clause without a full stop. Where fields contradict each other,
/// the clause is about the one that was changed, and not the one that stayed.
pub fn checked_change(before: &Scene, changed: Scene) -> Result<Drawable, String> {
    Drawable::new(changed.clone()).map_err(|reason| {
        match before.with(changed.differences(before)) {
            Err(refusal) => refused(&refusal, &changed),
            Ok(_) => undrawable(&reason, &changed),
        }
    })
}

/// Why `scene` cannot be drawn, in one clause.
#[must_use]
pub fn undrawable(reason: &Undrawable, scene: &Scene) -> String {
    match reason {
        Undrawable::Refused(refusal) => refused(refusal, scene),
        Undrawable::Gpu(GpuError::Observer(error)) => no_observer(error, scene),
        Undrawable::Gpu(GpuError::Inside { .. }) => {
            format!(
                "inside the horizon the method {} traces no light",
                scene.method.word()
            )
        }
        Undrawable::Gpu(GpuError::Spin(_)) => {
            format!("the method {} traces no spin", scene.method.word())
        }
        Undrawable::Gpu(other) => with_short_numbers(&other.to_string()),
        Undrawable::Sky(SkyPictureError::NoFile) => "the sky's picture has no file yet".into(),
        Undrawable::Sky(SkyPictureError::Refused { path, fault }) => {
            format!("{path} is no picture of the sky: {fault}")
        }
    }
}

/// Why the scene has no observer of its kind, in one clause.
#[must_use]
pub fn no_observer(error: &ObserverError, scene: &Scene) -> String {
    match error {
        ObserverError::OffPlane { theta_deg } => format!(
            "an orbit is offered in {} only (you are {}° off)",
            // The camera's orbit stays in the equator when the disk is tilted out of it.
            if scene.disk.is_tilted() {
                "the plane theta = 90°"
            } else {
                "the disk's plane"
            },
            four_digits((10.0 * (90.0 - theta_deg).abs()).round() / 10.0)
        ),
        ObserverError::TooDeep { inner, .. } => too_deep(scene.hole.spin, *inner),
        ObserverError::Inside { horizon, .. } => format!(
            "inside the horizon every effect is needed (r must be above {} r_s)",
            limit(*horizon)
        ),
        ObserverError::Static { limit: edge, .. } => format!(
            "nothing can hover here (r must be above {} r_s)",
            limit(*edge)
        ),
        ObserverError::Zamo { horizon, .. } => format!(
            "zero angular momentum needs a place outside the horizon (r above {} r_s)",
            limit(*horizon)
        ),
        ObserverError::Orbit { photon_orbit, .. } => format!(
            "an orbit is possible outside the photon orbit only (r above {} r_s)",
            limit(*photon_orbit)
        ),
        ObserverError::Velocity { .. } => {
            "nothing is as fast as light (the velocity's length must be below 1)".into()
        }
        ObserverError::Spin(_) | ObserverError::Place { .. } => {
            with_short_numbers(&error.to_string())
        }
    }
}

/// Why a field cannot have its value, in one clause.
fn refused(refusal: &Refusal, scene: &Scene) -> String {
    let lowest = field(refusal.key).map(|field| scene.range(field).0.low);
    match (refusal.key, lowest) {
        ("camera.r", Some(Bound::Included(low) | Bound::Excluded(low)))
            if scene.camera.r <= low =>
        {
            let (r, limit, horizon, photon_orbit) = (scene.camera.r, low, low, low);
            let error = match scene.observer.kind {
                ObserverKind::Rain => return too_deep(scene.hole.spin, low),
                ObserverKind::Static => ObserverError::Static { r, limit },
                ObserverKind::Zamo => ObserverError::Zamo { r, horizon },
                ObserverKind::Orbit => ObserverError::Orbit { r, photon_orbit },
            };
            no_observer(&error, scene)
        }
        ("disk.tilt_deg", _) if scene.hole.spin != 0.0 => format!(
            "around a hole that spins the disk must lie in the equator (its tilt is {}° and must be 0)",
            four_digits(scene.disk.tilt_deg)
        ),
        _ => with_short_numbers(&refusal.to_string()),
    }
}

fn too_deep(spin: f64, low: f64) -> String {
    format!(
        "too deep for spin {} (r must be above {} r_s)",
        spin_digits(spin),
        limit(low)
    )
}

/// A lower limit of r with two decimals, rounded up, so that every larger r is allowed.
fn limit(r: f64) -> String {
    four_digits((100.0 * r - LIMIT_ROUNDING).ceil() / 100.0)
}

/// A limit that differs from two decimals by rounding alone, as 1.5, is not rounded up.
const LIMIT_ROUNDING: f64 = 1e-9;
