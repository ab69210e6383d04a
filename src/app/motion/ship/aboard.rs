//! A ship with a pilot: what holds and turns it, and how fast its time passes.

use super::flown::Flown;
use super::head::Head;
use super::nose::Nose;
use super::pace::{Engine, far_rate, own_time_rate};
use super::ship_flight::HoldKind;
use super::stick::Stick;
use super::track::Track;
use crate::app::motion::pose::{Pose, pose_of};
use lightfall_core::geometry::ship::Ship;
use lightfall_core::optics::ship::{Hold, Thrust};
use lightfall_core::scene::Scene;
use lightfall_core::scene::mission::{Mission, Quantity};

/// The thrust that is set at first, as a share of the engine's. Short burns do what an ideal transfer
/// does.
const FIRST_THRUST: f64 = 1.0;

/// What a flight goes back to: the ship, and what held and turned it then.
#[derive(Clone, Debug)]
pub(super) struct Checkpoint {
    flown: Flown,
    hold: Option<Hold>,
    nose: Nose,
}

/// A ship with a pilot.
#[derive(Clone, Debug)]
pub(super) struct Aboard {
    pub(super) flown: Flown,
    /// The path so far.
    pub(super) track: Track,
    /// The flight at the last goal, if one was reached.
    goal: Option<Checkpoint>,
    /// Whether the flight went back to that goal and nothing has pushed the ship since: the same path would
    /// lead to the same end.
    repeats: bool,
    /// The flight at its start.
    start: Checkpoint,
    /// Whether the flight has come to its end, so that its time stands still.
    pub(super) has_ended: bool,
    /// Whether the ship's time passed in the last frame.
    pub(super) moves: bool,
    /// Where the camera was left, by which the ship notices that something else moves it.
    pub(super) last: Pose,
    /// The thrust that is set, as a share of the engine's.
    pub(super) thrust: f64,
    /// How fast own time passes, as a multiple of the usual pace.
    pub(super) pace: f64,
    /// Whether the ship comes away so fast that time runs more slowly than the pace says.
    pub(super) is_far: bool,
    pub(super) hold: Option<Hold>,
    pub(super) nose: Nose,
    /// Whether faster time has ended at a turning point, so that asking for it again passes them.
    pub(super) stopped_at_apsis: bool,
    /// Whether faster time goes on through turning points.
    pub(super) passes_apsides: bool,
    /// Where the pilot looks.
    pub(super) head: Head,
    /// The hand's input in the last frame.
    pub(super) stick: Stick,
    /// The time of a turn of the clocks' dials, in r_s/c.
    pub(super) dial: f64,
}

/// Where the nose points at the start of a mission. The autopilot keeps it there, unless the mission
/// counts by how much the ship is turned.
pub(super) fn first_nose(mission: &Mission) -> Nose {
    let goals = mission.goals.iter().flat_map(|goal| &goal.all);
    let fails = mission.fails.iter().flat_map(|fail| &fail.all);
    let counts_turns = goals
        .chain(fails)
        .any(|condition| condition.quantity == Quantity::RotationUsedDeg);
    let following = Nose::following(&mission.start);
    if counts_turns {
        following.released()
    } else {
        following
    }
}

/// The hold of a kind at the ship's place.
pub(super) fn hold_here(kind: HoldKind, ship: &Ship) -> Hold {
    let place = ship.place();
    match kind {
        HoldKind::Orbit => Hold::Orbit(place.r),
        HoldKind::Still if place.r <= place.kerr.static_limit(place.n.z) => Hold::Zamo(place.r),
        HoldKind::Still => Hold::Hover(place.r),
    }
}

impl Aboard {
    /// A pilot who takes the controls of a ship in this scene.
    pub(super) fn new(flown: Flown, scene: &Scene, nose: Nose, head: Head) -> Self {
        let time_scale = scene.camera.r.powf(1.5);
        Self {
            goal: None,
            repeats: false,
            start: Checkpoint {
                flown: flown.clone(),
                hold: None,
                nose,
            },
            stopped_at_apsis: false,
            passes_apsides: false,
            has_ended: false,
            moves: false,
            track: Track::new(flown.ship()),
            flown,
            last: pose_of(scene),
            thrust: FIRST_THRUST,
            pace: 1.0,
            is_far: false,
            hold: None,
            head,
            nose,
            stick: Stick::NEUTRAL,
            dial: 10f64.powf(time_scale.log10().floor()),
        }
    }

    /// Goes back to the start.
    pub(super) fn begin_again(&mut self) {
        (self.goal, self.repeats) = (None, false);
        self.return_to(self.start.clone());
    }

    /// Goes back to the last goal, or to the start: without a goal, and where the last way back led to that
    /// goal and nothing pushed the ship since. Returns whether it is the goal.
    pub(super) fn go_back(&mut self) -> bool {
        match self.goal.clone().filter(|_| !self.repeats) {
            Some(goal) => {
                self.return_to(goal);
                self.repeats = true;
                true
            }
            None => {
                self.begin_again();
                false
            }
        }
    }

    /// Keeps the flight at a goal that was reached in this frame.
    pub(super) fn keep_goal(&mut self) {
        self.repeats = false;
        self.goal = Some(Checkpoint {
            flown: self.flown.clone(),
            hold: self.hold,
            nose: self.nose,
        });
    }

    /// Notes that something pushes the ship, so that its path is another one and turning points ahead are
    /// news.
    pub(super) fn note_push(&mut self) {
        self.repeats = false;
        self.end_passing();
    }

    /// Lets faster time end at the next turning point again.
    pub(super) fn end_passing(&mut self) {
        (self.stopped_at_apsis, self.passes_apsides) = (false, false);
    }

    /// Puts an earlier state of the flight in place.
    fn return_to(&mut self, earlier: Checkpoint) {
        let Checkpoint { flown, hold, nose } = earlier;
        self.track.cut(flown.ship().proper_time());
        (self.flown, self.hold, self.nose) = (flown, hold, nose);
        self.end_passing();
        (self.pace, self.is_far, self.has_ended) = (1.0, false, false);
    }

    pub(super) fn engine_off(&mut self) {
        self.hold = None;
        self.nose.release();
    }

    /// Whether the engine can push: there is one, and fuel.
    pub(super) fn can_push(&self) -> bool {
        self.flown.voyage().flight.rocket.max_acceleration() > 0.0
    }

    /// What the engine does.
    pub(super) fn engine(&self) -> Engine {
        match self.flown.voyage().flight.orders().thrust {
            Thrust::Off => Engine::Off,
            Thrust::Axes(_) | Thrust::Along(..) => Engine::Hand,
            Thrust::Hold(..) => Engine::Hold,
        }
    }

    /// Own time that passes in a second.
    pub(super) fn rate(&self) -> f64 {
        let rate = self.wanted_rate();
        far_rate(self.flown.ship()).map_or(rate, |far| rate.min(far))
    }

    /// The same without the limit far from the hole.
    pub(super) fn wanted_rate(&self) -> f64 {
        let flight = &self.flown.voyage().flight;
        let r = flight.ship.place().r;
        own_time_rate(r, self.pace, self.engine(), &flight.rocket)
    }
}
