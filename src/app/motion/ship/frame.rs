//! A frame of the ship's flight.

use super::aboard::Aboard;
use super::pace::{Stop, far_time, first_stop};
use super::ship_flight::ShipFlight;
use super::stick::Stick;
use crate::app::motion::flight_step::FlightStep;
use crate::app::motion::pose::pose_of;
use crate::app::state::MAX_FRAME_SECONDS;
use glam::DVec3;
use lightfall_core::geometry::ship::ShipError;
use lightfall_core::optics::ship::{HoldRefusal, Orders, Thrust, disk_clock, write_scene};
use lightfall_core::scene::Scene;

/// The share of a full tank below which the pilot is warned.
pub(crate) const LITTLE_FUEL: f64 = 0.2;

/// What a frame is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShipFrame {
    /// Seconds for which the ship's time passes: none while it stands still.
    pub seconds: f64,
    /// Seconds for which the ship turns.
    pub turn_seconds: f64,
    /// The hand.
    pub stick: Stick,
    /// Whether turns to a heading, and those of the head, are made at once.
    pub reduced_motion: bool,
}

/// What happened in a frame that is worth a sentence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum News {
    /// The hold is not possible any more.
    Refused(HoldRefusal),
    /// Faster time has ended.
    Slowed(Stop),
    /// The ship comes away so fast that time does not run as fast as it is set.
    Far,
    /// Less than a fifth of the tank is left.
    LittleFuel,
    /// The tank is empty.
    Empty,
    /// The hand begins to push, and the engine cannot.
    NoPush,
}

impl ShipFlight {
    /// Lets a frame pass. A camera that is not where it was left was moved by something else, which
    /// leaves the controls; turning the camera does not.
    pub fn advance(&mut self, frame: &ShipFrame, scene: &Scene) -> (FlightStep, Option<News>) {
        let Some(aboard) = &mut self.aboard else {
            return (FlightStep::Idle, None);
        };
        if aboard.last != pose_of(scene) {
            self.aboard = None;
            return (FlightStep::Idle, None);
        }
        let (step, news) = aboard
            .advance(frame, scene)
            .unwrap_or_else(|reason| (FlightStep::Refused(reason), None));
        if matches!(step, FlightStep::Refused(_)) {
            self.aboard = None;
        }
        (step, news)
    }

    /// Whether the hand, which did not push in the last frame, pushes now.
    pub(super) fn begins_push(&self, stick: Stick) -> bool {
        let aboard = self.aboard.as_ref();
        aboard.is_some_and(|aboard| aboard.begins_push(stick))
    }
}

impl Aboard {
    fn begins_push(&self, stick: Stick) -> bool {
        stick.thrust != DVec3::ZERO && self.stick.thrust == DVec3::ZERO
    }

    fn advance(
        &mut self,
        frame: &ShipFrame,
        scene: &Scene,
    ) -> Result<(FlightStep, Option<News>), String> {
        let clock = disk_clock(self.flown.ship());
        let (ends, news) = self.move_on(frame).map_err(|error| error.to_string())?;
        self.head.turn(frame.turn_seconds, frame.reduced_motion);
        let ship = self.flown.ship();
        let mut next = scene.clone();
        write_scene(ship, &self.head.mount(ship), &mut next).map_err(|error| error.to_string())?;
        if next.disk_moves() {
            next.disk.time += disk_clock(ship) - clock;
        }
        self.last = pose_of(&next);
        Ok((FlightStep::to(next, ends), news))
    }

    /// Moves the ship. Returns whether it has come to a limit of its flight, and what happened.
    fn move_on(&mut self, frame: &ShipFrame) -> Result<(bool, Option<News>), ShipError> {
        let begins_push = self.begins_push(frame.stick);
        self.steer(frame);
        let seconds = if self.has_ended { 0.0 } else { frame.seconds };
        let pushes_in_vain = begins_push && !self.can_push() && seconds > 0.0;
        self.moves = seconds > 0.0;
        let seconds = seconds.min(MAX_FRAME_SECONDS);
        let (rate, was_far) = (self.wanted_rate(), self.is_far);
        let far = far_time(self.flown.voyage(), rate, seconds);
        if seconds > 0.0 {
            self.is_far = far.is_some();
        }
        let wanted = far.unwrap_or(rate * seconds);
        let stop = (self.pace > 1.0)
            .then(|| {
                let radii = self.flown.radii();
                first_stop(self.flown.voyage(), wanted, &radii, self.passes_apsides)
            })
            .flatten();
        let time = stop.map_or(wanted, |(time, _)| time);
        let fuel = self.flown.voyage().flight.rocket;
        let before = self.flown.ship().proper_time();
        let goals = self.flown.goals_reached();
        self.flown.advance(time, &mut self.track)?;
        if self.flown.goals_reached() > goals && !self.flown.is_over() {
            self.keep_goal();
        }
        let mut news = pushes_in_vain.then_some(News::NoPush);
        if self.is_far && !was_far {
            news = Some(News::Far);
        }
        if let Some((_, stop)) = stop {
            self.pace = 1.0;
            self.stopped_at_apsis = matches!(stop, Stop::Low | Stop::High);
            news = Some(News::Slowed(stop));
        }
        let flight = &self.flown.voyage().flight;
        let left = flight.rocket.left();
        let little = LITTLE_FUEL * (left + flight.rocket.used());
        if (little..).contains(&fuel.left()) && left < little {
            news = Some(News::LittleFuel);
        }
        if fuel.left() > 0.0 && left == 0.0 {
            self.hold = None;
            news = Some(News::Empty);
        }
        if let (Some(hold), Thrust::Off) = (self.hold, flight.orders().thrust) {
            self.hold = None;
            let refusal = hold.acceleration(&flight.ship, 0.0).err();
            return Ok((false, refusal.map(News::Refused).or(news)));
        }
        // Only a limit of the flight stops the ship's clock.
        let passed = self.flown.ship().proper_time() - before;
        self.has_ended |= passed < 0.999_999 * time;
        Ok((self.has_ended && seconds > 0.0, news))
    }

    /// Turns the ship, and gives the orders of this frame.
    fn steer(&mut self, frame: &ShipFrame) {
        let stick = frame.stick;
        self.stick = stick;
        if stick.turn != DVec3::ZERO {
            self.nose.release();
        }
        // A key of an engine that cannot push changes nothing.
        if stick.thrust != DVec3::ZERO && self.can_push() {
            self.hold = None;
            self.pace = self.pace.min(1.0);
            self.note_push();
        }
        let seconds = frame.turn_seconds.min(MAX_FRAME_SECONDS);
        let turn = stick.turn
            + self
                .nose
                .turn(self.flown.ship(), seconds, frame.reduced_motion);
        self.flown.turn(turn);
        let orders = self.orders(stick);
        self.flown.order(orders);
        self.pace = self.pace.min(self.engine().fastest());
    }

    fn orders(&self, stick: Stick) -> Orders {
        let most = self.flown.voyage().flight.rocket.max_acceleration();
        let by_hand = stick.thrust * (self.thrust * stick.gear).min(1.0) * most;
        let thrust = match self.hold {
            _ if by_hand != DVec3::ZERO => Thrust::Axes(by_hand),
            Some(hold) => Thrust::Hold(hold, most),
            None => Thrust::Off,
        };
        Orders {
            thrust,
            face: self.nose.followed(),
            ..Orders::COAST
        }
    }
}
