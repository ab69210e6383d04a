//! The effect of Esc: it ends or closes what is uppermost, or opens the menu if nothing is open.

use crate::app::controls::control::AppCommand;
use crate::app::motion::pilot::Pilot;
use crate::app::state::end_card::EndCard;
use crate::app::state::kiosk::Kiosk;
use crate::app::state::menu::Menu;
use crate::app::state::overlays::Overlays;
use bevy::prelude::*;

/// Frees the mouse, or ends the photo mode, or closes the help, the card at the end of a flight or a
/// panel, or opens the menu, which a window for visitors does not have.
pub(super) fn apply_escape(
    mut commands: MessageReader<AppCommand>,
    mut pilot: ResMut<Pilot>,
    mut overlays: ResMut<Overlays>,
    mut end_card: ResMut<EndCard>,
    (mut menu, kiosk): (ResMut<Menu>, Res<Kiosk>),
) {
    // Any key has closed some cards before this system runs.
    let closed_card = end_card.is_changed() && !end_card.is_open() && !end_card.is_added();
    let presses = commands.read().filter(|it| **it == AppCommand::Escape);
    if presses.count() == 0 || closed_card || menu.is_open() {
        return;
    }
    if pilot.free_look {
        pilot.free_look = false;
    } else if overlays.hidden {
        overlays.hidden = false;
    } else if overlays.help {
        overlays.help = false;
    } else if end_card.is_open() {
        end_card.close();
    } else if !overlays.close_side() && !kiosk.is_on() {
        menu.open();
    }
}
