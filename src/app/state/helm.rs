//! What the player's hands fly: the camera, or the ship.

use super::kiosk::Kiosk;
use crate::app::controls::control::AppCommand;
use crate::app::controls::helm::{ShipCommand, ship_command};
use bevy::ecs::system::SystemParam;
use bevy::prelude::{App, MessageWriter, Res, Resource};

/// What the hands fly.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Helm {
    /// The camera.
    #[default]
    Camera,
    /// The ship.
    Ship,
    /// The ship, on a mission.
    Mission,
    /// The ship, after the end of a mission.
    MissionOver,
}

impl Helm {
    /// Whether the hands fly the ship.
    #[must_use]
    pub fn has_ship(self) -> bool {
        self != Self::Camera
    }
}

/// Whether a finger holds the button that pushes the ship along its nose.
#[derive(Resource, Default)]
pub(crate) struct FingerPushes(pub(crate) bool);

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Helm>()
        .init_resource::<FingerPushes>()
        .add_message::<ShipCommand>();
}

/// Sends commands to whom they are for: some are the ship's while the hands fly it. In a window for
/// visitors only their commands are sent.
#[derive(SystemParam)]
pub(crate) struct CommandSender<'w> {
    pub(crate) helm: Res<'w, Helm>,
    pub(crate) kiosk: Res<'w, Kiosk>,
    app: MessageWriter<'w, AppCommand>,
    ship: MessageWriter<'w, ShipCommand>,
}

impl CommandSender<'_> {
    pub(crate) fn send(&mut self, command: AppCommand) {
        if !self.kiosk.allows_command(command) {
            return;
        }
        let for_ship = self.helm.has_ship();
        let is_over = *self.helm == Helm::MissionOver;
        let on_mission = is_over || *self.helm == Helm::Mission;
        match ship_command(command, on_mission, is_over).filter(|_| for_ship) {
            Some(command) => drop(self.ship.write(command)),
            None => drop(self.app.write(command)),
        }
    }
}
