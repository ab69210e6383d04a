//! A journey and how far it has been flown: it starts, stops, starts again, and ends when something
//! else moves the camera.

use super::flight_step::FlightStep;
use crate::app::state::MAX_FRAME_SECONDS;
use bevy::prelude::Resource;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::{Journey, Unflyable, between};
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
    flight: Option<Flight>,
    /// The loaded scene in which the journey began. None before it has.
    home: Option<Scene>,
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
}

impl JourneyPlayer {
    /// A journey that has not begun.
    #[must_use]
    pub fn new(journey: Journey) -> Self {
        Self {
            journey,
            time: 0.0,
            flight: None,
            home: None,
        }
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
        self.home.as_ref() != Some(loaded) || self.time >= self.journey.duration
    }

    /// Returns to the beginning, in the scene that was `loaded`.
    pub fn rewind(&mut self, loaded: &Scene) {
        self.time = 0.0;
        self.home = Some(loaded.clone());
    }

    /// Whether the journey is being flown.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        self.flight.is_some()
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
    /// seconds since it appeared and until it goes. None without a flight.
    #[must_use]
    pub fn words(&self) -> Option<Words<'_>> {
        self.flight.as_ref()?;
        let title = self.journey.title.trim();
        if let Some(caption) = self.journey.caption_at(self.time) {
            let since = self.time - caption.time;
            Some(Words {
                text: &caption.text,
                is_title: false,
                since,
                left: caption.seconds - since,
            })
        } else if self.time < TITLE_SECONDS && !title.is_empty() {
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
        if self.time >= self.journey.duration {
            self.time = 0.0;
        }
        self.flight = Some(Flight {
            from: scene.camera,
            since: 0.0,
            clock: self.time,
            last: None,
        });
    }

    /// Starts from the beginning, with the camera there at once.
    pub fn restart(&mut self) {
        self.time = 0.0;
        self.flight = Some(Flight {
            from: Camera::default(),
            since: APPROACH,
            clock: 0.0,
            last: None,
        });
    }

    /// Goes ahead by `seconds`, or back by a negative number, within the journey. The next step
    /// shows that place at once.
    pub fn skip(&mut self, seconds: f64) {
        let last = self.journey.duration;
        if let Some(flight) = &mut self.flight {
            self.time = (self.time + seconds).clamp(0.0, last);
            flight.since = APPROACH;
        }
    }

    /// Leaves the camera where it is.
    pub fn stop(&mut self) {
        self.flight = None;
    }

    /// Lets `seconds` pass, but no more than one frame may: a machine that slept did not fly
    /// meanwhile. A camera that is not where it was left was moved by something else, which ends
    /// the flight. A calm flight does not roll.
    pub fn advance(&mut self, seconds: f64, scene: &Scene, calm: bool) -> FlightStep {
        let Some(flight) = &mut self.flight else {
            return FlightStep::Idle;
        };
        if flight.last.is_some_and(|last| last != scene.camera) {
            self.flight = None;
            return FlightStep::Idle;
        }
        // The first frame shows the start itself.
        if flight.last.is_some() {
            self.time += seconds.min(MAX_FRAME_SECONDS);
            flight.since += seconds.min(MAX_FRAME_SECONDS);
        }
        let mut next = scene.clone();
        self.journey.apply(self.time, &mut next);
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
        let step = FlightStep::to(next, self.time >= self.journey.duration);
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
