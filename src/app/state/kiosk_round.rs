//! The round of a window for visitors: its journeys one after another, and back to the first one when a
//! visitor has left.

use std::time::Duration;

/// How long the card at the end of a journey stays before the next journey begins.
pub const END_PAUSE: Duration = Duration::from_secs(10);
/// The shortest time at a stop, and the characters that are read in a second.
const MIN_READING: Duration = Duration::from_secs(5);
const CHARACTERS_PER_SECOND: f32 = 15.0;

/// What visitors did in a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VisitorInput {
    /// Nothing.
    #[default]
    Nothing,
    /// The mouse or a finger moved, or something is still held: a visitor who is there stays there.
    Moves,
    /// A key, a button, the wheel, a finger or a gamepad: somebody is there.
    Acts,
}

/// Where the present journey is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JourneyNow {
    /// Under way.
    Flies,
    /// At a stop whose caption takes so long to read.
    Waits(Duration),
    /// Left, or at its end.
    Rests,
}

/// What the round does next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoundStep {
    /// Nothing.
    Stay,
    /// Goes on from the stop.
    GoOn,
    /// Begins the journey at this place in the list, with everything as it was at the start.
    Begin(usize),
}

/// How far the round is. Times are since the program's start.
#[derive(Clone, Debug)]
pub struct KioskRound {
    /// The number of journeys.
    journeys: usize,
    /// How long nobody may do anything before the round begins anew.
    idle: Duration,
    /// The journey that was begun last. None before the first one.
    at: Option<usize>,
    /// When the visitor who is there last did something. None while nobody is there.
    visitor: Option<Duration>,
    /// Since when the journey waits or rests.
    waits_since: Option<Duration>,
    /// Whether the journey was under way, or at a stop, in the last frame.
    was_flown: bool,
}

impl KioskRound {
    /// A round of so many journeys that has not begun. It begins anew when a visitor has done nothing for
    /// `idle`.
    #[must_use]
    pub fn new(journeys: usize, idle: Duration) -> Self {
        Self {
            journeys,
            idle,
            at: None,
            visitor: None,
            waits_since: None,
            was_flown: false,
        }
    }

    /// Whether a visitor is there.
    #[must_use]
    pub fn has_visitor(&self) -> bool {
        self.visitor.is_some()
    }

    /// What to do in a frame at the time `now`.
    pub fn step(&mut self, now: Duration, input: VisitorInput, journey: JourneyNow) -> RoundStep {
        let is_flown = journey != JourneyNow::Rests;
        // A visitor who begins a journey leaves the window to it.
        if is_flown && !self.was_flown {
            self.visitor = None;
        }
        self.was_flown = is_flown;
        match (input, &mut self.visitor) {
            (VisitorInput::Acts, visitor) => *visitor = Some(now),
            (VisitorInput::Moves, Some(last)) => *last = now,
            (VisitorInput::Moves, None) | (VisitorInput::Nothing, _) => {}
        }
        let Some(at) = self.at else {
            return self.begin(0);
        };
        if let Some(last) = self.visitor {
            self.waits_since = None;
            return match now.saturating_sub(last) >= self.idle {
                true => self.begin(0),
                false => RoundStep::Stay,
            };
        }
        let patience = match journey {
            JourneyNow::Flies => {
                self.waits_since = None;
                return RoundStep::Stay;
            }
            JourneyNow::Waits(reading) => reading,
            JourneyNow::Rests => END_PAUSE,
        };
        let since = *self.waits_since.get_or_insert(now);
        if now.saturating_sub(since) < patience {
            return RoundStep::Stay;
        }
        self.waits_since = None;
        match journey {
            JourneyNow::Rests => self.begin((at + 1) % self.journeys.max(1)),
            JourneyNow::Flies | JourneyNow::Waits(_) => RoundStep::GoOn,
        }
    }

    /// Begins the journey at this place in the list.
    fn begin(&mut self, journey: usize) -> RoundStep {
        self.at = Some(journey);
        (self.visitor, self.waits_since) = (None, None);
        RoundStep::Begin(journey)
    }
}

/// How long a stop with this caption waits where nobody is there to go on.
#[must_use]
pub fn stop_reading_time(caption: &str) -> Duration {
    let seconds = caption.chars().count() as f32 / CHARACTERS_PER_SECOND;
    MIN_READING + Duration::from_secs_f32(seconds)
}
