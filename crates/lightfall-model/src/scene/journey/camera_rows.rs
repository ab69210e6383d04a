//! A camera path as a journey: its rows, from the first to the last.

use super::Journey;
use super::clock::Clock;
use super::field_tracks::FieldTracks;
use super::row::Row;
use super::tracks::Tracks;
use crate::scene::{Camera, ObserverKind};

/// What a journey keeps of the rows of a camera path, apart from its tracks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CameraRows {
    /// The time of each row, in seconds, and its line.
    rows: Vec<(f64, usize)>,
    /// Whether quaternions say where the camera looks, with the tilt of its picture in them.
    by_quaternion: bool,
}

impl CameraRows {
    /// The time of each row, in seconds.
    pub(super) fn times(&self) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|(time, _)| *time)
    }

    /// The line of the row with this number, counted from 0.
    pub(super) fn line(&self, row: usize) -> usize {
        self.rows[row].1
    }

    /// Takes the tilt of the picture out of the direction in which the camera looks, if the path includes it:
    /// drawing adds the tilt again.
    pub(super) fn finish(&self, camera: &mut Camera) {
        let tilt_deg = camera.tilt_deg;
        if self.by_quaternion && tilt_deg != 0.0 {
            camera.tilt_deg = -tilt_deg;
            let heading = camera.tetrad_from_camera();
            camera.tilt_deg = tilt_deg;
            camera.set_orientation(heading);
        }
    }
}

/// The journey along these rows, of which there are at least two. It begins at the time 0 even if the first
/// row is later, so that a row with the number of a frame is the camera of this frame.
pub(super) fn journey_along(rows: &[Row], by_quaternion: bool) -> Journey {
    let points = |value: &dyn Fn(&Row) -> Option<f64>| -> Vec<(f64, f64)> {
        let points = rows.iter().map(|row| Some((row.time, value(row)?)));
        points.flatten().collect()
    };
    let tracks = Tracks::along(|name, component| match name {
        "r" => points(&|row| Some(row.r)),
        "theta_deg" => points(&|row| Some(row.theta_deg)),
        "phi_deg" => points(&|row| Some(row.phi_deg)),
        "yaw_deg" => points(&|row| Some(row.angles[0])),
        "pitch_deg" => points(&|row| Some(row.angles[1])),
        "roll_deg" => points(&|row| Some(row.angles[2])),
        "fov_deg" => points(&|row| row.fov_deg),
        "velocity" => points(&|row| Some(row.velocity?[component])),
        _ => Vec::new(),
    });
    let mut kinds: Vec<(f64, ObserverKind)> = Vec::new();
    for row in rows {
        let Some(kind) = row.kind else {
            continue;
        };
        if kinds.last().is_none_or(|(_, last)| *last != kind) {
            kinds.push((row.time, kind));
        }
    }
    Journey {
        duration: rows.last().map_or(0.0, |row| row.time),
        tracks_in_rain: tracks.clone(),
        tracks,
        fields: FieldTracks::of_exposure(&points(&|row| row.exposure_ev)),
        path: Some(CameraRows {
            rows: rows.iter().map(|row| (row.time, row.line)).collect(),
            by_quaternion,
        }),
        kinds,
        clock: Clock {
            rates: Vec::new(),
            times: points(&|row| row.disk_time),
        },
        ..Journey::empty()
    }
}
