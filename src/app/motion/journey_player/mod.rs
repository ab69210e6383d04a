//! A journey and how far it has been flown: it starts, waits at its stops, stops, starts again, and ends
//! when something else moves the camera.

mod answers;
mod stops;
mod words;

pub use answers::NotedAnswer;
pub use stops::ShownStops;

use self::answers::Tries;
use super::flight_step::FlightStep;
use crate::app::state::MAX_FRAME_SECONDS;
use bevy::prelude::Resource;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::{Journey, Unflyable, between};
use lightfall_core::scene::presets::Preset;
use lightfall_core::scene::{Camera, Scene};
use std::collections::BTreeMap;

/// Seconds in which the camera comes from where it is to where the journey is.
const APPROACH: f64 = 4.0;

/// A journey, and how far it has been flown.
#[derive(Resource, Clone, Debug)]
pub struct JourneyPlayer {
    journey: Journey,
    /// Seconds along the journey.
    time: f64,
    /// How many of its stops were left behind. It waits at the next one when it is there.
    left: usize,
    flight: Option<Flight>,
    /// How many flights have begun.
    flights: u32,
    /// The loaded scene in which the journey began. None before it has.
    home: Option<Scene>,
    /// The scene as it was before the stops of the last flight switched its fields.
    switched: Option<Scene>,
    /// How the questions of its stops were answered since the beginning, by the stops' numbers.
    answers: BTreeMap<usize, Tries>,
}

/// A journey under way.
#[derive(Clone, Debug)]
struct Flight {
    /// The camera at the start, which the flight leaves within [`APPROACH`] seconds.
    from: Camera,
    /// Seconds since the start.
    since: f64,
    /// Seconds along the journey at which the scene's disk has its time.
    clock: f64,
    /// The camera as it was left. None before the first frame.
    last: Option<Camera>,
    /// How many stops have switched what is shown. None before the first frame.
    shown: Option<usize>,
    /// The scene of the first frame, which stops compare with. It belongs to the flight, so that no
    /// journey is compared with the scene of another one.
    began: Option<Scene>,
}

impl Flight {
    /// A flight that shows the journey at once.
    fn there(clock: f64) -> Self {
        Self {
            from: Camera::default(),
            since: APPROACH,
            clock,
            last: None,
            shown: None,
            began: None,
        }
    }
}

impl JourneyPlayer {
    /// A journey that has not begun.
    #[must_use]
    pub fn new(journey: Journey) -> Self {
        Self {
            journey,
            time: 0.0,
            left: 0,
            flight: None,
            flights: 0,
            home: None,
            switched: None,
            answers: BTreeMap::new(),
        }
    }

    /// Goes to the beginning of the journey, where nothing was flown and answered.
    fn begin(&mut self) {
        (self.time, self.left) = (0.0, 0);
        self.answers.clear();
    }

    /// Takes another journey in place of this one. What this one has switched is still to be put back.
    pub fn take(&mut self, journey: Journey) {
        self.flight = None;
        self.journey = journey;
        self.home = None;
        self.begin();
    }

    /// The journey.
    #[must_use]
    pub fn journey(&self) -> &Journey {
        &self.journey
    }

    /// The scene of the preset that the journey names, if it names one.
    #[must_use]
    pub fn stage(&self) -> Option<&'static Scene> {
        self.journey.preset.map(Preset::plain_scene)
    }

    /// Whether a start begins at the beginning: the journey has not begun, is over, or began in
    /// another scene than the one that is `loaded` now.
    #[must_use]
    pub fn begins_anew(&self, loaded: &Scene) -> bool {
        !self.is_at_home(loaded) || self.is_over()
    }

    /// Whether the journey began in the scene that is `loaded` now.
    #[must_use]
    pub fn is_at_home(&self, loaded: &Scene) -> bool {
        self.home.as_ref() == Some(loaded)
    }

    fn is_over(&self) -> bool {
        self.time >= self.journey.duration && self.next_stop().is_none()
    }

    /// Returns to the beginning, in the scene that was `loaded`.
    pub fn rewind(&mut self, loaded: &Scene) {
        self.begin();
        self.home = Some(loaded.clone());
    }

    /// Whether the journey is being flown.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        self.flight.is_some()
    }

    /// Whether the camera is where the journey has it now.
    #[must_use]
    pub fn is_there(&self, scene: &Scene) -> bool {
        let mut there = scene.clone();
        self.journey.lead(self.time, &mut there);
        there.camera == scene.camera
    }

    /// The scene with the fields that no stop has switched yet. None before the first frame.
    #[must_use]
    pub fn base(&self) -> Option<&Scene> {
        self.switched.as_ref()
    }

    /// Seconds along the journey.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// How far the journey has been flown, in words.
    #[must_use]
    pub fn progress(&self) -> String {
        format!("{:.0} of {:.0} s", self.time.floor(), self.journey.duration)
    }

    /// The share of the journey that has been flown, from 0 to 1.
    #[must_use]
    pub fn share(&self) -> f64 {
        (self.time / self.journey.duration).clamp(0.0, 1.0)
    }

    /// Checks whether the rest of the journey can be flown in this scene; after its end, whether
    /// all of it can.
    ///
    /// # Errors
    /// The first moment that cannot be flown, and why.
    pub fn check(&self, scene: &Scene) -> Result<(), Unflyable> {
        self.journey.check(scene, self.time, Drawable::new)
    }

    /// Goes on from where the journey was left, and approaches that place gently from where the
    /// camera is. After the end, starts again from the beginning.
    pub fn start(&mut self, scene: &Scene) {
        if self.is_over() {
            self.begin();
        }
        self.flights += 1;
        self.flight = Some(Flight {
            from: scene.camera,
            since: 0.0,
            ..Flight::there(self.time)
        });
    }

    /// Starts from the beginning, with the camera there at once.
    pub fn restart(&mut self) {
        self.begin();
        // In a scene of its own nothing is switched yet.
        if self.journey.preset.is_some() {
            self.switched = None;
        }
        self.flights += 1;
        self.flight = Some(Flight::there(0.0));
    }

    /// Leaves the camera where it is.
    pub fn stop(&mut self) {
        self.flight = None;
    }

    /// Lets `seconds` pass, but no more than one frame may: a machine that slept did not fly
    /// meanwhile. A camera that is not where it was left was moved by something else, which ends
    /// the flight. A calm flight does not roll.
    pub fn advance(&mut self, seconds: f64, scene: &Scene, calm: bool) -> FlightStep {
        let (next_stop, is_last) = match self.next_stop() {
            Some(stop) => (stop.time, false),
            None => (f64::INFINITY, true),
        };
        let Some(flight) = &mut self.flight else {
            return FlightStep::Idle;
        };
        if flight.last.is_some_and(|last| last != scene.camera) {
            self.flight = None;
            return FlightStep::Idle;
        }
        // The first frame shows the start itself.
        if flight.last.is_some() {
            let seconds = seconds.min(MAX_FRAME_SECONDS);
            self.time = (self.time + seconds).min(next_stop);
            flight.since += seconds;
        }
        let mut next = scene.clone();
        let reached = self.journey.stops_until(self.time);
        if flight.shown != Some(reached) {
            flight.shown = Some(reached);
            let base = self.switched.get_or_insert_with(|| scene.clone());
            let fields = self.journey.switches_of(reached).fields;
            self.journey.switch(&fields, base, &mut next);
        }
        self.journey.lead(self.time, &mut next);
        if calm {
            next.camera.roll_deg = scene.camera.roll_deg;
        }
        next.camera = between(&flight.from, &next.camera, flight.since / APPROACH);
        let mut before = scene.clone();
        // A journey from its beginning begins there at the scene's own time.
        if flight.last.is_none() && flight.since >= APPROACH {
            before.camera = next.camera;
        }
        self.journey
            .drive_clock([flight.clock, self.time], &before, &mut next);
        (flight.clock, flight.last) = (self.time, Some(next.camera));
        flight.began.get_or_insert_with(|| next.clone());
        let step = FlightStep::to(next, is_last && self.time >= self.journey.duration);
        if !matches!(step, FlightStep::Moved(_)) {
            self.flight = None;
        }
        step
    }
}
