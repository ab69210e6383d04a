//! What the stops of a journey have switched at some time.

use super::stop::{InspectorView, SideBySide, write};
use super::{Journey, Stop};
use crate::scene::{Scene, Value};
use std::collections::BTreeMap;

/// What the stops up to some time have switched, each by the last stop that names it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Switches {
    /// Fields of the scene.
    pub fields: BTreeMap<&'static str, Value>,
    /// The fields of the scene that is shown beside the present one; none where nothing is compared.
    pub beside: Option<BTreeMap<&'static str, Value>>,
    /// Whether and how scenes are compared; none where no stop says it.
    pub side_by_side: Option<SideBySide>,
    /// Whether the guides are shown.
    pub guides: Option<bool>,
    /// What the ray inspector shows.
    pub inspector: Option<InspectorView>,
}

impl Switches {
    fn add(&mut self, stop: &Stop) {
        if let Some(compares) = stop.side_by_side {
            // A comparison that is shown in another way keeps its other scene.
            let goes_on = self.beside.is_some() && self.side_by_side != Some(compares);
            self.side_by_side = Some(compares);
            if compares == SideBySide::Off {
                self.beside = None;
            } else if !goes_on {
                self.beside = Some(self.fields.clone());
            }
        }
        self.fields.extend(stop.fields.iter().cloned());
        self.guides = stop.guides.or(self.guides);
        self.inspector = stop.inspector.or(self.inspector);
    }
}

impl Journey {
    /// What the first stops, so many of them, have switched.
    pub fn switches_of(&self, stops: usize) -> Switches {
        let mut switches = Switches::default();
        for stop in self.stops.iter().take(stops) {
            switches.add(stop);
        }
        switches
    }

    /// The number of stops that a journey has reached after `time` seconds.
    pub fn stops_until(&self, time: f64) -> usize {
        self.stops.partition_point(|stop| stop.time <= time)
    }

    /// Whether keyframes set fields of the scene.
    pub fn sets_fields(&self) -> bool {
        self.fields.keys().next().is_some()
    }

    /// Gives every field that keyframes set its value of `base`.
    pub fn put_back(&self, base: &Scene, scene: &mut Scene) {
        for key in self.fields.written() {
            if let Some(field) = crate::scene::field(key) {
                write(scene, (field.key, &field.get(base)));
            }
        }
    }

    /// Gives every field that some stop switches its value of `base`, and then its value of
    /// `fields`, if these have it.
    pub fn switch(&self, fields: &BTreeMap<&'static str, Value>, base: &Scene, scene: &mut Scene) {
        let all = self.stops.iter().flat_map(|stop| &stop.fields);
        for (key, _) in all {
            let value = fields.get(key).cloned();
            let value = value.or_else(|| Some(crate::scene::field(key)?.get(base)));
            if let Some(value) = value {
                write(scene, (key, &value));
            }
        }
    }
}
