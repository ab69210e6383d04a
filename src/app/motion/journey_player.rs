//! A journey and how far it has been flown: it starts, waits at its stops, stops, starts again, and ends
//! when something else moves the camera.

use super::flight_step::FlightStep;
use crate::app::state::MAX_FRAME_SECONDS;
use bevy::prelude::Resource;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::{Journey, Stop, Switches, Unflyable, between};
use lightfall_core::scene::presets::Preset;
use lightfall_core::scene::{Camera, Scene};

/// Seconds in which the camera comes from where it is to where the journey is.
const APPROACH: f64 = 4.0;
/// Seconds for which the title is shown at the beginning.
const TITLE_SECONDS: f64 = 4.5;

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
}

/// The first stops of a flight, so many of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShownStops {
    /// The number of the flight.
    flight: u32,
    /// How many stops.
    pub stops: usize,
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
        }
    }

    /// Takes another journey in place of this one. What this one has switched is still to be put back.
    pub fn take(&mut self, journey: Journey) {
        self.flight = None;
        self.journey = journey;
        (self.time, self.left, self.home) = (0.0, 0, None);
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
        (self.time, self.left) = (0.0, 0);
        self.home = Some(loaded.clone());
    }

    /// Whether the journey is being flown.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        self.flight.is_some()
    }

    /// Whether a journey with stops is being flown.
    #[must_use]
    pub fn has_lesson(&self) -> bool {
        self.is_playing() && !self.journey.stops.is_empty()
    }

    /// The stop at which the journey waits, and its number, counted from 1.
    #[must_use]
    pub fn waits_at(&self) -> Option<(&Stop, usize)> {
        self.flight.as_ref()?;
        let stop = self.next_stop().filter(|stop| self.time >= stop.time)?;
        Some((stop, self.left + 1))
    }

    fn next_stop(&self) -> Option<&Stop> {
        self.journey.stops.get(self.left)
    }

    /// Whether the journey waits at a stop and the camera has come there, so that the hands have it.
    #[must_use]
    pub fn rests(&self) -> bool {
        let came = |flight: &Flight| {
            flight.since >= APPROACH && flight.shown == Some(self.left + 1) && flight.last.is_some()
        };
        self.waits_at().is_some() && self.flight.as_ref().is_some_and(came)
    }

    /// Which stops have switched what is shown. None without a flight, and before its first frame.
    #[must_use]
    pub fn shown_stops(&self) -> Option<ShownStops> {
        let stops = self.flight.as_ref()?.shown?;
        Some(ShownStops {
            flight: self.flights,
            stops,
        })
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

    /// The title and the text of the card at the end.
    #[must_use]
    pub fn last_words(&self) -> [&str; 2] {
        let title = match self.journey.title.trim() {
            "" => "The journey ends here",
            title => title,
        };
        [title, &self.journey.ending]
    }

    /// What to show over the picture now: the title at the beginning, then the captions, with the
    /// seconds since it appeared and until it goes. None without a flight, and at a stop, which has words
    /// of its own.
    #[must_use]
    pub fn words(&self) -> Option<Words<'_>> {
        self.flight.as_ref()?;
        if self.waits_at().is_some() {
            return None;
        }
        let title = self.journey.title.trim();
        if let Some(caption) = self.journey.caption_at(self.time) {
            let since = self.time - caption.time;
            Some(Words {
                text: &caption.text,
                is_title: false,
                since,
                left: caption.seconds - since,
            })
        } else if self.time < TITLE_SECONDS && !title.is_empty() && self.left == 0 {
            Some(Words {
                text: title,
                is_title: true,
                since: self.time,
                left: TITLE_SECONDS - self.time,
            })
        } else {
            None
        }
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
            (self.time, self.left) = (0.0, 0);
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
        (self.time, self.left) = (0.0, 0);
        // In a scene of its own nothing is switched yet.
        if self.journey.preset.is_some() {
            self.switched = None;
        }
        self.flights += 1;
        self.flight = Some(Flight::there(0.0));
    }

    /// Goes ahead by `seconds`, or back by a negative number, within the journey and no farther than
    /// to the next stop. The next step shows that place at once.
    pub fn skip(&mut self, seconds: f64) {
        if !self.is_playing() {
            return;
        }
        if seconds > 0.0 && self.waits_at().is_some() {
            self.left += 1;
        }
        let next = self
            .next_stop()
            .map_or(self.journey.duration, |stop| stop.time);
        self.show_at((self.time + seconds).clamp(0.0, next));
        if seconds < 0.0 {
            self.left = self.stops_before(self.time);
        }
    }

    fn stops_before(&self, time: f64) -> usize {
        self.journey.stops.partition_point(|stop| stop.time < time)
    }

    /// Shows the journey at this time at once, from the next step on.
    fn show_at(&mut self, time: f64) {
        self.time = time;
        if let Some(flight) = &mut self.flight {
            flight.since = APPROACH;
        }
    }

    /// Goes on from the stop at which the journey waits, from where the camera is; on the way, shows the
    /// next stop at once.
    pub fn go_on(&mut self, scene: &Scene) {
        if self.waits_at().is_none() {
            let next = self
                .next_stop()
                .map_or(self.journey.duration, |stop| stop.time);
            return self.show_at(next);
        }
        let is_there = self.is_there(scene);
        self.left += 1;
        if let Some(flight) = self.flight.as_mut().filter(|_| !is_there) {
            (flight.from, flight.since, flight.last) = (scene.camera, 0.0, Some(scene.camera));
        }
    }

    /// Goes back to the stop before, or to the beginning.
    pub fn go_back(&mut self) {
        let before = self.left.checked_sub(1);
        self.left = before.unwrap_or(0);
        let stop = before.and_then(|before| self.journey.stops.get(before));
        self.show_at(stop.map_or(0.0, |stop| stop.time));
    }

    /// Leaves the camera where it is.
    pub fn stop(&mut self) {
        self.flight = None;
    }

    /// The scene without what the stops have switched. None if they have switched nothing.
    pub fn unswitched(&mut self, mut scene: Scene) -> Option<Scene> {
        let base = self.switched.take()?;
        let none = Switches::default().fields;
        self.journey.switch(&none, &base, &mut scene);
        (!self.journey.stops.is_empty()).then_some(scene)
    }

    /// Notes where the hands have the camera while the journey waits at a stop.
    pub fn follow(&mut self, scene: &Scene) {
        if let Some(flight) = &mut self.flight {
            (flight.last, flight.clock) = (Some(scene.camera), self.time);
        }
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
        let step = FlightStep::to(next, is_last && self.time >= self.journey.duration);
        if !matches!(step, FlightStep::Moved(_)) {
            self.flight = None;
        }
        step
    }
}

/// Words over the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Words<'a> {
    /// One line.
    pub text: &'a str,
    /// Whether this is the journey's title.
    pub is_title: bool,
    /// Seconds since it appeared.
    pub since: f64,
    /// Seconds until it goes.
    pub left: f64,
}
