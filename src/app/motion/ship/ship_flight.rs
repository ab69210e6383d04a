//! The flight of the ship with its pilot: who has the controls, what holds and turns the ship, and how
//! fast its time passes.

use super::aboard::{Aboard, first_nose, hold_here};
use super::flown::Flown;
use super::head::Head;
use super::nose::Nose;
use super::pace::{Engine, PACE_STEP, SLOWEST};
use super::track::Track;
use crate::app::state::settings::Settings;
use bevy::prelude::Resource;
use lightfall_core::optics::readout::si::HoleMass;
use lightfall_core::optics::readout::units::Units;
use lightfall_core::optics::ship::{
    Attempt, BoardError, Flight, Heading, Hold, HoldRefusal, Mount, Rocket, StartError, Voyage,
    board,
};
use lightfall_core::scene::Scene;
use lightfall_core::scene::mission::{Look, Mission};

/// The rocket of a ship without a mission: its rapidity, its largest acceleration in c^2/r_s, and the
/// speed of its exhaust in c.
const FREE_ROCKET: [f64; 3] = [3.0, 1.0, 1.0];

/// One notch of the wheel changes the thrust by this factor, within a range.
const THRUST_NOTCH: f64 = 1.15;
const LEAST_THRUST: f64 = 0.002;

/// What the engine can hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoldKind {
    /// The circle at this radius.
    Orbit,
    /// The place. In an ergosphere it is the one without angular momentum.
    Still,
}

/// The ship, if someone is aboard.
#[derive(Resource, Clone, Debug, Default)]
pub struct ShipFlight {
    pub(super) aboard: Option<Aboard>,
}

impl ShipFlight {
    /// Takes the controls of a ship that moves as the scene's observer, with a full tank. Without a
    /// mission its hole has this mass.
    ///
    /// # Errors
    /// There is no such ship.
    pub fn board(&mut self, scene: &Scene, mass: HoleMass) -> Result<(), BoardError> {
        let ship = board(scene, &Mount::NOSE)?;
        let [rapidity, acceleration, exhaust] = FREE_ROCKET;
        let rocket = Rocket::new(rapidity, acceleration, exhaust)
            .expect("the constants are those of a rocket");
        let voyage = Voyage::new(Flight::new(ship, rocket), mass, &scene.disk);
        let head = Head::looking(Look::Nose);
        self.begin(Flown::Free(Box::new(voyage)), scene, Nose::FREE, head);
        Ok(())
    }

    /// Begins an attempt at a mission, in its own scene or one that looks otherwise.
    ///
    /// # Errors
    /// The mission's start does not exist.
    pub fn start(&mut self, mission: &Mission, scene: &Scene) -> Result<(), StartError> {
        let attempt = Attempt::new(mission)?;
        let nose = first_nose(mission);
        let head = Head::looking(mission.start.look);
        self.begin(Flown::Mission(Box::new(attempt)), scene, nose, head);
        Ok(())
    }

    fn begin(&mut self, flown: Flown, scene: &Scene, nose: Nose, head: Head) {
        self.aboard = Some(Aboard::new(flown, scene, nose, head));
    }

    /// Leaves the controls.
    pub fn leave(&mut self) {
        self.aboard = None;
    }

    /// Goes back to the last goal, with what held and turned the ship there, or to the start: without a
    /// goal, and where the last way back led to that goal and nothing pushed the ship since. Returns whether
    /// it is the goal.
    pub fn go_back(&mut self) -> bool {
        self.aboard.as_mut().is_some_and(Aboard::go_back)
    }

    /// Goes back to the start.
    pub fn begin_again(&mut self) {
        if let Some(aboard) = &mut self.aboard {
            aboard.begin_again();
        }
    }

    /// Whether someone has the controls.
    #[must_use]
    pub fn is_flown(&self) -> bool {
        self.aboard.is_some()
    }

    /// Whether the ship's time passed in the last frame.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.aboard.as_ref().is_some_and(|aboard| aboard.moves)
    }

    /// The voyage, if someone has the controls.
    #[must_use]
    pub fn voyage(&self) -> Option<&Voyage> {
        self.aboard.as_ref().map(|aboard| aboard.flown.voyage())
    }

    /// The attempt at a mission that is under way or over.
    #[must_use]
    pub fn attempt(&self) -> Option<&Attempt> {
        match self.aboard.as_ref().map(|aboard| &aboard.flown) {
            Some(Flown::Mission(attempt)) => Some(attempt),
            _ => None,
        }
    }

    /// The mass of a mission's hole.
    #[must_use]
    pub fn mass(&self) -> Option<HoleMass> {
        let attempt = self.attempt()?;
        Some(HoleMass::of_suns(attempt.mission.hole.mass_suns))
    }

    /// What holds the ship.
    #[must_use]
    pub fn hold(&self) -> Option<Hold> {
        self.aboard.as_ref().and_then(|aboard| aboard.hold)
    }

    /// The heading that the nose turns to or follows.
    #[must_use]
    pub fn heading(&self) -> Option<Heading> {
        self.aboard
            .as_ref()
            .and_then(|aboard| aboard.nose.heading())
    }

    /// What the pilot looks at.
    #[must_use]
    pub fn look(&self) -> Look {
        self.aboard
            .as_ref()
            .map_or(Look::Nose, |aboard| aboard.head.look())
    }

    /// Lets the pilot look along the nose, or at the hole. Returns what the pilot looks at now.
    pub fn switch_look(&mut self) -> Look {
        if let Some(aboard) = &mut self.aboard {
            aboard.head.switch();
        }
        self.look()
    }

    /// How the camera that sees what the pilot sees is mounted on the ship.
    #[must_use]
    pub fn mount(&self) -> Mount {
        self.aboard
            .as_ref()
            .map_or(Mount::NOSE, |aboard| aboard.head.mount(aboard.flown.ship()))
    }

    /// The thrust that is set, as a share of the engine's.
    #[must_use]
    pub fn thrust(&self) -> f64 {
        self.aboard.as_ref().map_or(0.0, |aboard| aboard.thrust)
    }

    /// How fast own time passes, as a multiple of the usual pace.
    #[must_use]
    pub fn pace(&self) -> f64 {
        self.aboard.as_ref().map_or(0.0, |aboard| aboard.pace)
    }

    /// Own time, in r_s/c, that passes in a second.
    #[must_use]
    pub fn rate(&self) -> f64 {
        self.aboard.as_ref().map_or(0.0, Aboard::rate)
    }

    /// Whether the ship comes away so fast that time runs more slowly than the pace says.
    #[must_use]
    pub fn is_far(&self) -> bool {
        self.aboard.as_ref().is_some_and(|aboard| aboard.is_far)
    }

    /// The path that was flown so far.
    #[must_use]
    pub fn track(&self) -> Option<&Track> {
        self.aboard.as_ref().map(|aboard| &aboard.track)
    }

    /// The radii in the conditions of a mission's next goal, those of the lowest and the highest point of
    /// the path, too, in r_s.
    #[must_use]
    pub fn goal_radii(&self) -> Vec<f64> {
        self.aboard
            .as_ref()
            .map_or_else(Vec::new, |aboard| aboard.flown.goal_radii())
    }

    /// The units of texts: with simple words, those of everyday life for the hole's mass, which is a
    /// mission's own.
    pub(crate) fn units(&self, settings: &Settings) -> Units {
        settings.units().for_mass(self.hole_mass(settings))
    }

    /// The hole's mass for texts: a mission's own, and otherwise that of the settings.
    pub(crate) fn hole_mass(&self, settings: &Settings) -> HoleMass {
        self.mass().unwrap_or_else(|| settings.mass())
    }

    /// The time of a turn of the clocks' dials, in r_s/c.
    #[must_use]
    pub fn dial(&self) -> f64 {
        self.aboard.as_ref().map_or(1.0, |aboard| aboard.dial)
    }

    /// Changes the thrust by so many notches of the wheel.
    pub fn change_thrust(&mut self, notches: f64) {
        if let Some(aboard) = &mut self.aboard {
            let thrust = aboard.thrust * THRUST_NOTCH.powf(notches);
            aboard.thrust = thrust.clamp(LEAST_THRUST, 1.0);
        }
    }

    /// Doubles the pace this many times; a negative number halves it. Where time runs more slowly than
    /// the pace says, it is not doubled. Where faster time has ended at a turning point, the next faster time
    /// passes such points until something pushes the ship or the pace is halved.
    pub fn change_pace(&mut self, steps: i32) {
        if let Some(aboard) = &mut self.aboard {
            let steps = if aboard.is_far { steps.min(0) } else { steps };
            match steps {
                1.. => aboard.passes_apsides |= std::mem::take(&mut aboard.stopped_at_apsis),
                ..0 => aboard.end_passing(),
                0 => {}
            }
            let fastest = aboard.engine().fastest();
            let pace = aboard.pace.min(fastest) * PACE_STEP.powi(steps);
            aboard.pace = pace.clamp(SLOWEST, fastest);
        }
    }

    /// Turns the nose to the next heading. `None` if the gyroscopes hold it from now on.
    pub fn face_next(&mut self) -> Option<Heading> {
        let aboard = self.aboard.as_mut()?;
        aboard.nose.step(aboard.flown.ship())
    }

    /// Turns the nose to the heading before. `None` if the gyroscopes hold it from now on.
    pub fn face_back(&mut self) -> Option<Heading> {
        let aboard = self.aboard.as_mut()?;
        aboard.nose.step_back(aboard.flown.ship())
    }

    /// Switches the engine off, and ends what holds and turns the ship.
    pub fn engine_off(&mut self) {
        if let Some(aboard) = &mut self.aboard {
            aboard.engine_off();
        }
    }

    /// Holds the ship at its present radius, or ends this hold. Returns whether it is held.
    ///
    /// # Errors
    /// There is no such hold here.
    pub fn switch_hold(&mut self, kind: HoldKind) -> Result<bool, HoldRefusal> {
        let Some(aboard) = &mut self.aboard else {
            return Ok(false);
        };
        let kind_of = |hold| match hold {
            Hold::Orbit(_) => HoldKind::Orbit,
            Hold::Hover(_) | Hold::Zamo(_) => HoldKind::Still,
        };
        if aboard.hold.map(kind_of) == Some(kind) {
            aboard.hold = None;
            return Ok(false);
        }
        let ship = aboard.flown.ship();
        let hold = hold_here(kind, ship);
        hold.acceleration(ship, 0.0)?;
        aboard.hold = Some(hold);
        aboard.note_push();
        aboard.pace = aboard.pace.min(Engine::Hold.fastest());
        Ok(true)
    }
}
