//! An attempt at a mission.

use super::flight::{Event, Flight, Orders};
use super::heading::{Heading, turn_to};
use super::pose::{BoardError, Mount, board};
use super::quantities::Voyage;
use super::rocket::{Rocket, RocketError};
use crate::readout::si::HoleMass;
use glam::DVec3;
use lightfall_model::geometry::ship::ShipError;
use lightfall_model::geometry::sphere::celestial_frame;
use lightfall_model::scene::mission::{Course, Face, Goal, Mission, Start};
use thiserror::Error;

/// Why an attempt cannot begin.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StartError {
    /// The observer of the start does not exist.
    #[error(transparent)]
    Board(#[from] BoardError),
    /// There is no such rocket.
    #[error(transparent)]
    Rocket(#[from] RocketError),
    /// Where the nose is to point has no direction.
    #[error("the ship stands still at the start, so it cannot face {0}")]
    Face(&'static str),
    /// The star that the nose is to point to is hidden.
    #[error("the star of start.star_deg is not seen at the start: it is behind the hole")]
    Star,
}

/// How an attempt stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Under way: so many goals are reached.
    UnderWay(usize),
    /// All goals are reached.
    Success,
    /// The mission's table `[[fail]]` of this index holds.
    Failed(usize),
    /// The flight came to its end before.
    Ended(Event),
}

/// An attempt at a mission. Goals are reached at moments that do not depend on the lengths of frames:
/// they are found by bisection.
#[derive(Clone, Debug, PartialEq)]
pub struct Attempt {
    /// The mission.
    pub mission: Mission,
    voyage: Voyage,
    /// When each goal so far was reached, in own time.
    reached: Vec<f64>,
    /// Since when the conditions of the next goal hold, in own time.
    held_since: Option<f64>,
    outcome: Outcome,
    /// The flight at the moment when the attempt was decided.
    end: Option<Voyage>,
}

impl From<Course> for Heading {
    fn from(course: Course) -> Self {
        match course {
            Course::Hole => Self::Hole,
            Course::Outward => Self::Outward,
            Course::Prograde => Self::Prograde,
            Course::Retrograde => Self::Retrograde,
        }
    }
}

impl Heading {
    /// Where the nose points at the start of a mission.
    pub fn at_start(start: &Start) -> Self {
        match start.face {
            Face::Hole => Self::Hole,
            Face::Outward => Self::Outward,
            Face::Prograde => Self::Prograde,
            Face::Retrograde => Self::Retrograde,
            Face::Star => {
                let [theta, phi] = start.star_place_deg().map(f64::to_radians);
                let [star, ..] = celestial_frame(theta, phi);
                Self::Star(star)
            }
        }
    }
}

impl Attempt {
    /// Begins an attempt.
    ///
    /// # Errors
    /// The mission's start does not exist.
    pub fn new(mission: &Mission) -> Result<Self, StartError> {
        let mut ship = board(mission.scene(), &Mount::NOSE)?;
        let start = &mission.start;
        let direction = Heading::at_start(start).direction(&ship);
        let direction = direction.ok_or(match start.face {
            Face::Star => StartError::Star,
            face => StartError::Face(face.word()),
        })?;
        ship.turn(turn_to(DVec3::X, direction));
        let ship_of_mission = &mission.ship;
        let rocket = Rocket::new(
            ship_of_mission.rapidity,
            ship_of_mission.acceleration,
            ship_of_mission.exhaust,
        )?;
        let mass = HoleMass::of_suns(mission.hole.mass_suns);
        let voyage = Voyage::new(Flight::new(ship, rocket), mass, &mission.scene().disk);
        let goal = &mission.goals[0];
        Ok(Self {
            held_since: voyage.meets(&goal.all).then_some(0.0),
            mission: mission.clone(),
            voyage,
            reached: Vec::new(),
            outcome: Outcome::UnderWay(0),
            end: None,
        })
    }

    /// The flight and its quantities.
    pub fn voyage(&self) -> &Voyage {
        &self.voyage
    }

    /// The flight as it is scored: at the moment of success or failure or, while the attempt is under way,
    /// now.
    pub fn scored(&self) -> &Voyage {
        self.end.as_ref().unwrap_or(&self.voyage)
    }

    /// How the attempt stands.
    pub fn outcome(&self) -> Outcome {
        self.outcome
    }

    /// Whether the attempt has come to its end, with success or without.
    pub fn is_over(&self) -> bool {
        !matches!(self.outcome, Outcome::UnderWay(_))
    }

    /// When each goal so far was reached, in own time.
    pub fn reached(&self) -> &[f64] {
        &self.reached
    }

    /// Since when the conditions of the next goal hold, in own time. `None` while they do not.
    pub fn held_since(&self) -> Option<f64> {
        self.held_since
    }

    /// Gives the ship other orders.
    pub fn order(&mut self, orders: Orders) {
        self.voyage.flight.order(orders);
    }

    /// Turns the ship at once, by hand, as [`Flight::turn`] does.
    pub fn turn(&mut self, rotation: DVec3) {
        self.voyage.flight.turn(rotation);
    }

    /// Lets own time pass, or less if the attempt ends before. What happens in an attempt that is
    /// over changes nothing of its outcome.
    ///
    /// # Errors
    /// As those of a ship's advance.
    pub fn advance(&mut self, proper_time: f64) -> Result<Outcome, ShipError> {
        let mut left = proper_time;
        while left > 0.0 {
            let length = left.min(self.voyage.longest_piece());
            let mut voyage = self.voyage;
            let event = voyage.advance(length)?;
            self.go_on_to(voyage, event)?;
            if event.is_some() {
                break;
            }
            left -= length;
        }
        Ok(self.outcome)
    }

    /// Goes on to `voyage`, at most [`Voyage::longest_piece`] after the present one, where `event`
    /// happened.
    pub(super) fn go_on_to(
        &mut self,
        voyage: Voyage,
        event: Option<Event>,
    ) -> Result<(), ShipError> {
        let before = std::mem::replace(&mut self.voyage, voyage);
        self.watch(before)?;
        if let (Outcome::UnderWay(_), Some(event @ Event::Limit(_))) = (self.outcome, event) {
            (self.outcome, self.end) = (Outcome::Ended(event), Some(voyage));
        }
        Ok(())
    }

    /// Looks for what happened since `before`.
    fn watch(&mut self, before: Voyage) -> Result<(), ShipError> {
        let end = self.voyage.flight.ship.proper_time();
        let failure = self.failure(&before, end);
        let until = failure.map_or(end, |(time, _)| time);
        let mut from = before;
        while let Outcome::UnderWay(next) = self.outcome {
            let goal = self.mission.goals[next].clone();
            let Some(time) = self.goal_reached(&from, &goal, until)? else {
                break;
            };
            self.reached.push(time);
            from = from.on_to(time)?;
            let after = self.mission.goals.get(next + 1);
            self.outcome = after.map_or(Outcome::Success, |_| Outcome::UnderWay(next + 1));
            if self.outcome == Outcome::Success {
                self.end = Some(from);
            }
            let holds = after.is_some_and(|goal| from.meets(&goal.all));
            self.held_since = holds.then_some(time);
        }
        if let (Outcome::UnderWay(_), Some((time, index))) = (self.outcome, failure) {
            (self.outcome, self.end) = (Outcome::Failed(index), Some(from.on_to(time)?));
        }
        Ok(())
    }

    /// The first failure since `before`: when, and which.
    fn failure(&self, before: &Voyage, end: f64) -> Option<(f64, usize)> {
        let fails = self.mission.fails.iter().enumerate();
        fails
            .filter(|(_, fail)| self.voyage.meets(&fail.all))
            .map(|(index, fail)| {
                let time = if before.meets(&fail.all) {
                    before.flight.ship.proper_time()
                } else {
                    before.moment(end, |voyage| voyage.meets(&fail.all))
                };
                (time, index)
            })
            .min_by(|one, other| one.0.total_cmp(&other.0))
    }

    /// When a goal is reached between `from` and the own time `until`; and since when its conditions
    /// hold then, if it is not.
    fn goal_reached(
        &mut self,
        from: &Voyage,
        goal: &Goal,
        until: f64,
    ) -> Result<Option<f64>, ShipError> {
        let holds_at_end = from.at(until)?.meets(&goal.all);
        let since = match self.held_since {
            Some(since) => since,
            None if holds_at_end => from.moment(until, |voyage| voyage.meets(&goal.all)),
            None => return Ok(None),
        };
        let last = if holds_at_end {
            until
        } else {
            from.moment(until, |voyage| !voyage.meets(&goal.all))
        };
        let reached = since + goal.hold;
        if reached <= last {
            return Ok(Some(reached.max(from.flight.ship.proper_time())));
        }
        self.held_since = holds_at_end.then_some(since);
        Ok(None)
    }
}
