//! The stops of a journey, at which it waits: going on, going back, and what they have switched.

use super::{APPROACH, Flight, JourneyPlayer};
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::{Stop, Switches};

/// The first stops of a flight, so many of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShownStops {
    /// The number of the flight.
    flight: u32,
    /// How many stops.
    pub stops: usize,
}

impl JourneyPlayer {
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

    /// The next stop that is not left behind.
    pub(super) fn next_stop(&self) -> Option<&Stop> {
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

    /// The scene that is shown beside the present one after these switches: the one in which this flight
    /// began, with what the stops before the comparison had led to. None where nothing is compared, and
    /// before the first frame.
    #[must_use]
    pub fn beside(&self, switches: &Switches) -> Option<Scene> {
        let fields = switches.beside.as_ref()?;
        let began = self.flight.as_ref()?.began.as_ref()?;
        let mut beside = began.clone();
        self.journey
            .switch(fields, self.base().unwrap_or(began), &mut beside);
        Some(beside)
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

    /// The scene without what the stops have switched and what keyframes have set. None if there is no such
    /// field.
    pub fn unswitched(&mut self, mut scene: Scene) -> Option<Scene> {
        let base = self.switched.take()?;
        let none = Switches::default().fields;
        self.journey.switch(&none, &base, &mut scene);
        self.journey.put_back(&base, &mut scene);
        let changes = !self.journey.stops.is_empty() || self.journey.sets_fields();
        changes.then_some(scene)
    }

    /// Notes where the hands have the camera while the journey waits at a stop.
    pub fn follow(&mut self, scene: &Scene) {
        if let Some(flight) = &mut self.flight {
            (flight.last, flight.clock) = (Some(scene.camera), self.time);
        }
    }
}
