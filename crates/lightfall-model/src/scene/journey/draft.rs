//! A lesson under construction: the scenes that were chosen as its stops, and its text.

use super::ease::Ease;
use super::keyframe::{Keyframe, Values};
use super::save::Said;
use super::stop::{InspectorView, SideBySide, Stop, is_switched};
use super::{Journey, JourneyError, load};
use crate::geometry::sphere::wrap_degrees;
use crate::scene::presets::Preset;
use crate::scene::{Changes, FIELDS, ObserverKind, Scene, Value, field};

/// Seconds from one stop to the next where the camera moves, and where it does not.
const TRAVEL: f64 = 6.0;
const NO_TRAVEL: f64 = 1.0;
/// Seconds after a stop, or before the next one, at which the kind of observer changes.
const CHANGE: f64 = 0.5;

/// What was shown when a stop was added.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// The scene.
    pub scene: Scene,
    /// What the stop says.
    pub caption: String,
    /// Whether the guides were shown.
    pub guides: bool,
    /// Whether and how two scenes were shown side by side.
    pub side_by_side: SideBySide,
    /// What the ray inspector showed.
    pub inspector: InspectorView,
}

/// A lesson under construction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    /// One line that says what the lesson shows.
    pub title: String,
    stops: Vec<Shown>,
}

impl Draft {
    /// The number of stops.
    pub fn len(&self) -> usize {
        self.stops.len()
    }

    /// Whether there is no stop yet.
    pub fn is_empty(&self) -> bool {
        self.stops.is_empty()
    }

    /// Adds what is shown as the next stop.
    ///
    /// # Errors
    /// The lesson cannot lead there, and why. The draft is as it was.
    pub fn add(&mut self, shown: Shown) -> Result<(), JourneyError> {
        self.stops.push(shown);
        let journey = self.journey();
        if journey.is_err() {
            self.stops.pop();
        }
        journey.map(drop)
    }

    /// The lesson as a journey: it begins in the built-in preset after which the first scene is
    /// named, and its first stop switches what differs from there.
    ///
    /// # Errors
    /// The stops are too many, or no journey leads through them.
    pub fn journey(&self) -> Result<Journey, JourneyError> {
        let origin = "the lesson";
        let mut keyframes = self.keyframes();
        let read = |keyframes: &[Keyframe]| {
            load(origin, &self.text(keyframes)).map_err(JourneyError::without_lines)
        };
        let journey = read(&keyframes)?;
        // In free fall around a hole that spins, a keyframe's azimuth is another one than a scene's.
        let mut leads = Vec::new();
        for (shown, stop) in self.stops.iter().zip(&journey.stops) {
            let mut there = shown.scene.clone();
            journey.lead(stop.time, &mut there);
            leads.push((
                stop.at,
                wrap_degrees(shown.scene.camera.phi_deg - there.camera.phi_deg),
            ));
        }
        for frame in &mut keyframes {
            let lead = leads.iter().find(|(at, _)| *at == frame.time);
            if let (Some((_, lead)), Some(Value::Float(phi))) =
                (lead, frame.values.get_mut("phi_deg"))
            {
                *phi += lead;
            }
        }
        read(&keyframes)
    }

    fn text(&self, keyframes: &[Keyframe]) -> String {
        Said {
            title: &self.title,
            teaches: "",
            ending: "",
            preset: self.preset(),
            keyframes,
            captions: &[],
            stops: &self.stops(),
        }
        .to_toml()
    }

    /// The built-in preset in which the lesson is flown: that after which its first scene is named.
    fn preset(&self) -> Option<&'static Preset> {
        let first = self.stops.first()?;
        Some(Changes::of(&first.scene).preset)
    }

    /// The time of each stop.
    fn times(&self) -> Vec<f64> {
        let mut times: Vec<f64> = Vec::with_capacity(self.stops.len());
        for (index, shown) in self.stops.iter().enumerate() {
            let before = index.checked_sub(1).map(|before| &self.stops[before].scene);
            let travels = |before: &Scene| {
                (before.camera, before.observer) != (shown.scene.camera, shown.scene.observer)
            };
            let time = match before {
                None => 0.0,
                Some(before) if travels(before) => times[index - 1] + TRAVEL,
                Some(_) => times[index - 1] + NO_TRAVEL,
            };
            times.push(time);
        }
        times
    }

    fn keyframes(&self) -> Vec<Keyframe> {
        let names = self.led_by_choice();
        let mut frames: Vec<Keyframe> = Vec::new();
        let mut turned = [0.0; 5];
        for (shown, time) in self.stops.iter().zip(self.times()) {
            let (camera, disk) = (&shown.scene.camera, &shown.scene.disk);
            let angles = [
                camera.phi_deg,
                camera.yaw_deg,
                camera.pitch_deg,
                camera.roll_deg,
                disk.node_deg,
            ];
            // Along the shorter turn of each angle.
            let is_first = frames.is_empty();
            for (turned, angle) in turned.iter_mut().zip(angles) {
                let turn = if is_first {
                    angle
                } else {
                    wrap_degrees(angle - *turned)
                };
                *turned += turn;
            }
            let [phi, yaw, pitch, roll, node] = turned.map(Value::Float);
            let mut values = Values::from([
                ("r", Value::Float(camera.r)),
                ("theta_deg", Value::Float(camera.theta_deg)),
                ("fov_deg", Value::Float(camera.fov_deg)),
                ("phi_deg", phi),
                ("yaw_deg", yaw),
                ("pitch_deg", pitch),
                ("roll_deg", roll),
                ("observer", Value::Word(shown.scene.observer.kind.word())),
                ("velocity", Value::Velocity(shown.scene.observer.velocity)),
                ("disk_tilt_deg", Value::Float(disk.tilt_deg)),
                ("disk_node_deg", node),
                ("disk_rate", Value::Float(disk.rate)),
            ]);
            values.retain(|name, _| names.contains(name));
            frames.extend(self.change_of_observer(&frames, time, shown.scene.observer.kind));
            frames.push(keyframe(time, values));
        }
        // A journey has two keyframes at least.
        if let [only] = frames.as_slice() {
            frames.push(keyframe(only.time + NO_TRAVEL, Values::new()));
        }
        frames
    }

    /// What keyframes name: the camera and the kind of observer always, and the rest where it is not
    /// as in the preset at some stop.
    fn led_by_choice(&self) -> Vec<&'static str> {
        let mut names = vec![
            "r",
            "theta_deg",
            "phi_deg",
            "yaw_deg",
            "pitch_deg",
            "roll_deg",
            "fov_deg",
            "observer",
        ];
        let fields = [
            ("velocity", "observer.velocity"),
            ("disk_tilt_deg", "disk.tilt_deg"),
            ("disk_node_deg", "disk.node_deg"),
            ("disk_rate", "disk.rate"),
        ];
        let plain = self.preset().map(Preset::plain_scene);
        let value = |scene: &Scene, key: &str| field(key).map(|field| field.get(scene));
        let differ = |(_, key): &(&str, &str)| {
            let plain = plain.and_then(|plain| value(plain, key));
            self.stops
                .iter()
                .any(|shown| value(&shown.scene, key) != plain)
        };
        names.extend(fields.into_iter().filter(differ).map(|(name, _)| name));
        names
    }

    /// A keyframe on the way to a stop at which the observer is of another kind. Free fall exists on
    /// the way wherever the camera goes, and an orbit only where it began.
    fn change_of_observer(
        &self,
        frames: &[Keyframe],
        time: f64,
        next: ObserverKind,
    ) -> Option<Keyframe> {
        let last = frames.last()?;
        let Some(Value::Word(before)) = last.values.get("observer") else {
            return None;
        };
        let at_once = next == ObserverKind::Rain || *before == ObserverKind::Orbit.word();
        let changes = *before != next.word() && at_once && time - last.time > CHANGE;
        changes.then(|| {
            let kind = Value::Word(next.word());
            keyframe(last.time + CHANGE, Values::from([("observer", kind)]))
        })
    }

    /// The stops, each with what it switches.
    fn stops(&self) -> Vec<Stop> {
        let mut stops = Vec::with_capacity(self.stops.len());
        let plain = self.preset().map(Preset::plain_scene);
        let mut before: Option<&Shown> = None;
        for (shown, at) in self.stops.iter().zip(self.times()) {
            let scene = before.map(|before| &before.scene).or(plain);
            let is_new =
                |same: fn(&Shown, &Shown) -> bool| before.is_none_or(|before| !same(before, shown));
            let guides = is_new(|a, b| a.guides == b.guides);
            let side_by_side = is_new(|a, b| a.side_by_side == b.side_by_side);
            let inspector = is_new(|a, b| a.inspector == b.inspector);
            stops.push(Stop {
                time: at,
                at,
                caption: shown.caption.clone(),
                fields: scene.map_or_else(Vec::new, |scene| switched(scene, &shown.scene)),
                guides: guides.then_some(shown.guides),
                side_by_side: side_by_side.then_some(shown.side_by_side),
                inspector: inspector.then_some(shown.inspector),
                question: None,
            });
            before = Some(shown);
        }
        stops
    }
}

fn keyframe(time: f64, values: Values) -> Keyframe {
    Keyframe {
        time,
        ease: Ease::Smooth,
        values,
        set: Values::new(),
        in_rain: Values::new(),
    }
}

/// The fields that stops may switch and in which `after` differs, with their values there. A metered
/// exposure is left out.
fn switched(before: &Scene, after: &Scene) -> Vec<(&'static str, Value)> {
    let differs = FIELDS.iter().filter(|field| {
        let metered = after.picture.automatic_exposure && field.key == "picture.exposure_ev";
        is_switched(field) && !metered && field.get(before) != field.get(after)
    });
    differs.map(|field| (field.key, field.get(after))).collect()
}
