//! A window for the visitors of an exhibition.

use super::kiosk_round::KioskRound;
use crate::app::controls::control::{Action, AppCommand, Control};
use crate::app::controls::kiosk::{is_command_for_visitors, is_for_visitors};
use crate::app::controls::table::control_named;
use bevy::prelude::*;
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::Journey;
use std::time::Duration;

/// A journey of an exhibition, and the scene in which it is flown.
#[derive(Clone, Debug)]
pub struct Show {
    /// The scene.
    pub scene: Scene,
    /// The journey. It names no preset of its own, and asks no questions.
    pub journey: Journey,
}

impl Show {
    /// A journey in a scene. Its questions are left out, because answers would be written to a file.
    #[must_use]
    pub fn new(scene: Scene, mut journey: Journey) -> Self {
        journey.preset = None;
        for stop in &mut journey.stops {
            stop.question = None;
        }
        Self { scene, journey }
    }
}

/// What a window shows to visitors.
#[derive(Clone, Debug)]
pub struct Exhibition {
    /// The journeys, at least one, which are flown one after another.
    pub shows: Vec<Show>,
    /// How long a visitor may do nothing before the window goes back to its start.
    pub idle: Duration,
    /// Loudness of what a ship's pilot hears, from 0 for silence to 1.
    pub volume: f64,
}

/// The exhibition in this window. Off in every other window.
#[derive(Resource, Default)]
pub(crate) struct Kiosk(pub(crate) Option<OnShow>);

/// An exhibition under way.
pub(crate) struct OnShow {
    pub(crate) shows: Vec<Show>,
    pub(crate) round: KioskRound,
}

impl Kiosk {
    /// An exhibition that has not begun, or none.
    pub(crate) fn new(exhibition: Option<Exhibition>) -> Self {
        Self(exhibition.map(|exhibition| OnShow {
            round: KioskRound::new(exhibition.shows.len(), exhibition.idle),
            shows: exhibition.shows,
        }))
    }

    /// Whether this window is for visitors.
    pub(crate) fn is_on(&self) -> bool {
        self.0.is_some()
    }

    /// Whether nobody is there in a window for visitors.
    pub(crate) fn is_deserted(&self) -> bool {
        self.0.as_ref().is_some_and(|on| !on.round.has_visitor())
    }

    /// Whether controls may do this here.
    pub(crate) fn allows(&self, action: Action) -> bool {
        !self.is_on() || is_for_visitors(action)
    }

    /// Whether this command may be sent here.
    pub(crate) fn allows_command(&self, command: AppCommand) -> bool {
        !self.is_on() || is_command_for_visitors(command)
    }

    /// Whether buttons and texts name this command here: one that may be sent, except the one that leads to the
    /// menu elsewhere, which visitors do not have.
    pub(crate) fn offers(&self, command: AppCommand) -> bool {
        self.allows_command(command) && !(self.is_on() && command == AppCommand::Escape)
    }

    /// Whether texts name the control with this name here.
    pub(crate) fn offers_control(&self, id: &str) -> bool {
        let offers = |control: &Control| match control.action {
            Action::Do(command) => self.offers(command),
            action => self.allows(action),
        };
        !self.is_on() || control_named(id).is_none_or(offers)
    }
}

/// Whether the pointer is hidden because the mouse rests in a window for visitors.
#[derive(Resource, Default)]
pub(crate) struct HiddenPointer(pub(crate) bool);

/// A run condition: this window is not for visitors.
pub(crate) fn outside_kiosk(kiosk: Res<Kiosk>) -> bool {
    !kiosk.is_on()
}

/// A run condition: this window is for visitors.
pub(crate) fn in_kiosk(kiosk: Res<Kiosk>) -> bool {
    kiosk.is_on()
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Kiosk>()
        .init_resource::<HiddenPointer>();
}
