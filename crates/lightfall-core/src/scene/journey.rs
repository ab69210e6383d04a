//! A journey: a guided flight as keyframes in time, and what they make of a scene. Plain data and
//! its interpolation.
//!
//! Every quantity has a track of its own, through the keyframes that name it: monotone cubics
//! (Fritsch & Carlson 1980), so that positions and speeds are continuous, nothing overshoots, and
//! the flight begins and ends at rest. Radii are interpolated in their logarithm. What no keyframe
//! names stays what it is in the scene.

mod check;
mod error;
mod format;
mod keyframe;
mod load;
mod track;

pub use check::Unflyable;
pub use error::JourneyError;
pub use load::load;
pub use track::Track;

use super::{Camera, ObserverKind, Scene};
use crate::geometry::kerr::Kerr;
use crate::geometry::sphere::wrap_degrees;

/// The built-in journey, part of the program itself.
pub const DEFAULT: &str = include_str!("../../../../assets/journeys/default.toml");

/// A guided flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Journey {
    /// One line that says where it leads.
    pub title: String,
    /// Seconds from the first keyframe to the last.
    pub duration: f64,
    /// When each keyframe is, in the seconds of its text.
    times: Vec<f64>,
    tracks: Tracks,
    /// For observers that fall from rest at infinity.
    tracks_in_rain: Tracks,
    /// From when on the observer is of which kind.
    kinds: Vec<(f64, ObserverKind)>,
}

/// What is led along.
#[derive(Clone, Debug, PartialEq)]
struct Tracks {
    /// ln r.
    radius: Option<Track>,
    angles: [Option<Track>; ANGLES.len()],
    field_of_view: Option<Track>,
    velocity: [Option<Track>; 3],
}

/// An angle of the camera: its name in a keyframe, and its field.
type Angle = (&'static str, fn(&mut Camera) -> &mut f64);

const ANGLES: [Angle; 5] = [
    ("theta_deg", |camera| &mut camera.theta_deg),
    ("phi_deg", |camera| &mut camera.phi_deg),
    ("yaw_deg", |camera| &mut camera.yaw_deg),
    ("pitch_deg", |camera| &mut camera.pitch_deg),
    ("roll_deg", |camera| &mut camera.roll_deg),
];

impl Journey {
    /// Writes to `scene` where the flight is after `time` seconds; before the first keyframe as at
    /// it, after the last as there.
    ///
    /// A circular orbit cannot be led away from its plane: unless the journey itself says what the
    /// observer is, `orbit` becomes `static`, as under the hand. The scene is not checked.
    ///
    /// While the observer is `rain`, keyframes tell Kerr's ingoing azimuth, counted so that it is
    /// Boyer-Lindquist's where that begins: the other would wind without end toward the horizon of
    /// a hole that spins.
    pub fn apply(&self, time: f64, scene: &mut Scene) {
        let kind = self
            .kinds
            .iter()
            .rev()
            .find(|(from, _)| *from <= time)
            .or(self.kinds.first());
        match kind {
            Some((_, kind)) => scene.observer.kind = *kind,
            None if scene.observer.kind == ObserverKind::Orbit => {
                scene.observer.kind = ObserverKind::Static
            }
            None => {}
        }
        let rain = scene.observer.kind == ObserverKind::Rain;
        let tracks = if rain {
            &self.tracks_in_rain
        } else {
            &self.tracks
        };
        tracks.apply(time, scene);
        if tracks.leads("phi_deg") {
            let phi = scene.camera.phi_deg
                - self
                    .azimuth_lead(
                        time,
                        rain,
                        Kerr {
                            spin: scene.hole.spin,
                        },
                    )
                    .to_degrees();
            scene.camera.phi_deg = wrap_degrees(phi);
        }
    }

    /// By how much Kerr's ingoing azimuth has grown beyond Boyer-Lindquist's in all the times of
    /// `rain` up to now, in radians; inside the horizon, where `camera.phi_deg` is the ingoing one,
    /// less that one's own lead.
    fn azimuth_lead(&self, time: f64, rain: bool, kerr: Kerr) -> f64 {
        let Some(radius) = self
            .tracks_in_rain
            .radius
            .as_ref()
            .filter(|_| kerr.spin != 0.0)
        else {
            return 0.0;
        };
        let lead = |time: f64| {
            let r = radius.at(time).exp();
            if r > kerr.horizon() {
                kerr.ingoing_azimuth_lead(r)
            } else {
                0.0
            }
        };
        // What the observer is before the first keyframe that says it.
        let first = self
            .kinds
            .first()
            .map_or(rain, |(_, kind)| *kind == ObserverKind::Rain);
        let later = self
            .kinds
            .iter()
            .skip(1)
            .map(|(from, kind)| (*from, *kind == ObserverKind::Rain));
        let starts: Vec<_> = std::iter::once((0.0, first)).chain(later).collect();
        let ends = starts
            .iter()
            .skip(1)
            .map(|(from, _)| *from)
            .chain([f64::INFINITY]);
        let times = starts
            .iter()
            .zip(ends)
            .filter(|((from, rain), _)| *rain && *from <= time);
        times
            .map(|((from, _), end)| lead(time.min(end)) - lead(*from))
            .sum()
    }
}

impl Tracks {
    /// Whether any keyframe names this angle.
    fn leads(&self, name: &str) -> bool {
        ANGLES
            .iter()
            .zip(&self.angles)
            .any(|((angle, _), track)| *angle == name && track.is_some())
    }

    fn apply(&self, time: f64, scene: &mut Scene) {
        if let Some(radius) = &self.radius {
            scene.camera.r = radius.at(time).exp();
        }
        for ((name, field), track) in ANGLES.iter().zip(&self.angles) {
            if let Some(track) = track {
                let angle = track.at(time);
                *field(&mut scene.camera) = if *name == "theta_deg" {
                    angle
                } else {
                    wrap_degrees(angle)
                };
            }
        }
        if let Some(track) = &self.field_of_view {
            scene.camera.fov_deg = track.at(time);
        }
        for (component, track) in scene.observer.velocity.iter_mut().zip(&self.velocity) {
            if let Some(track) = track {
                *component = track.at(time);
            }
        }
    }
}

/// The camera a share of the way, from 0 to 1, from one to another: gently at both ends, in the
/// logarithm of the radius, and the short way round.
#[must_use]
pub fn between(from: &Camera, to: &Camera, share: f64) -> Camera {
    let share = share.clamp(0.0, 1.0);
    let gently = share * share * (3.0 - 2.0 * share);
    let mix = |a: f64, b: f64| a + (b - a) * gently;
    let (mut from, mut camera) = (*from, *to);
    // The very numbers at the end.
    if share < 1.0 {
        camera.r = mix(from.r.ln(), to.r.ln()).exp();
        camera.fov_deg = mix(from.fov_deg, to.fov_deg);
        for (name, field) in ANGLES {
            let (start, end) = (*field(&mut from), *field(&mut camera));
            let turn = if name == "theta_deg" {
                end - start
            } else {
                wrap_degrees(end - start)
            };
            *field(&mut camera) = start + turn * gently;
        }
        for field in [ANGLES[1].1, ANGLES[2].1, ANGLES[3].1, ANGLES[4].1] {
            *field(&mut camera) = wrap_degrees(*field(&mut camera));
        }
    }
    camera
}
