//! The fields of the scene that the tables `set` of keyframes lead.

use super::ease::Ease;
use super::keyframe::Values;
use super::stop::write;
use super::track::Track;
use crate::scene::{Scene, Value};
use std::collections::BTreeMap;

/// The exposure, which the light meter chooses unless it is switched off.
const EXPOSURE: &str = "picture.exposure_ev";
const AUTOMATIC_EXPOSURE: &str = "picture.automatic_exposure";

/// The courses of fields through the keyframes that set them, by the fields' keys.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct FieldTracks(BTreeMap<&'static str, FieldTrack>);

/// The course of one field.
#[derive(Clone, Debug, PartialEq)]
enum FieldTrack {
    /// A number.
    Number(Track),
    /// Two numbers.
    Pair([Track; 2]),
    /// What has nothing in between: a whole number such as a seed, a switch or a word. Each value holds
    /// from its time.
    Steps(Vec<(f64, Value)>),
}

impl FieldTracks {
    /// The courses through keyframes, each with its time in seconds after the beginning.
    pub(super) fn through(keyframes: &[(f64, Ease, &Values)]) -> Self {
        let mut points: BTreeMap<&'static str, Vec<(f64, Ease, &Value)>> = BTreeMap::new();
        for (time, ease, values) in keyframes {
            for (key, value) in *values {
                points.entry(*key).or_default().push((*time, *ease, value));
            }
        }
        let tracks = points.into_iter();
        Self(
            tracks
                .filter_map(|(key, points)| Some((key, FieldTrack::through(&points)?)))
                .collect(),
        )
    }

    /// The course of the exposure along a camera path, through points in time.
    pub(super) fn of_exposure(points: &[(f64, f64)]) -> Self {
        let track = Track::along(points).map(FieldTrack::Number);
        Self(track.into_iter().map(|track| (EXPOSURE, track)).collect())
    }

    /// The keys of the fields.
    pub(super) fn keys(&self) -> impl Iterator<Item = &'static str> {
        self.0.keys().copied()
    }

    /// The keys of all fields that [`apply`](Self::apply) writes.
    pub(super) fn written(&self) -> impl Iterator<Item = &'static str> {
        let switched_off = self.0.contains_key(EXPOSURE).then_some(AUTOMATIC_EXPOSURE);
        self.keys().chain(switched_off)
    }

    /// Writes the fields after `time` seconds into a scene. As on the command line, an exposure that is
    /// set switches the automatic one off, unless the keyframes set that, too.
    pub(super) fn apply(&self, time: f64, scene: &mut Scene) {
        if self.0.contains_key(EXPOSURE) {
            scene.picture.automatic_exposure = false;
        }
        for (key, track) in &self.0 {
            if let Some(value) = track.at(time) {
                write(scene, (*key, &value));
            }
        }
    }
}

impl FieldTrack {
    fn through(points: &[(f64, Ease, &Value)]) -> Option<Self> {
        let track = |number: fn(&Value) -> Option<f64>| {
            let numbers = points
                .iter()
                .map(|(time, _, value)| Some((*time, number(value)?)));
            let numbers: Option<Vec<(f64, f64)>> = numbers.collect();
            Track::eased(&numbers?, |i| points[i].1)
        };
        match points.first()?.2 {
            Value::Float(_) => track(Value::number).map(Self::Number),
            Value::Pair(_) => Some(Self::Pair([
                track(|value| part(value, 0))?,
                track(|value| part(value, 1))?,
            ])),
            _ => {
                let steps = points.iter();
                Some(Self::Steps(
                    steps
                        .map(|(time, _, value)| (*time, Value::clone(value)))
                        .collect(),
                ))
            }
        }
    }

    /// The value at a time. Before the first keyframe that sets it, it is that keyframe's.
    fn at(&self, time: f64) -> Option<Value> {
        match self {
            Self::Number(track) => Some(Value::Float(track.at(time))),
            Self::Pair(tracks) => Some(Value::Pair(tracks.each_ref().map(|track| track.at(time)))),
            Self::Steps(steps) => {
                let passed = steps.partition_point(|(from, _)| *from <= time);
                let (_, value) = steps.get(passed.saturating_sub(1))?;
                Some(value.clone())
            }
        }
    }
}

/// A number of a pair.
fn part(value: &Value, index: usize) -> Option<f64> {
    match value {
        Value::Pair(numbers) => numbers.get(index).copied(),
        _ => None,
    }
}
