//! What the keeper of a window for visitors needs: keys that end it, and a pointer that is hidden while the
//! mouse rests.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::control::Modifier;
use crate::app::state::kiosk::{HiddenPointer, in_kiosk};
use bevy::prelude::*;
use std::time::Duration;

/// The control whose key ends the window, held with [`QUIT_MODIFIERS`].
const QUIT: &str = "window.quit";
const QUIT_MODIFIERS: [Modifier; 2] = [Modifier::Ctrl, Modifier::Shift];
/// How long the keys that end the window are held: longer than a hand rests on them.
const QUIT_HOLD: Duration = Duration::from_secs(3);
/// The longest time that counts for a frame: a slow frame does not stand for a key that is held.
const MAX_FRAME: Duration = Duration::from_millis(500);
/// How long the pointer stays after the mouse was used.
const POINTER_STAY: Duration = Duration::from_secs(3);

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, (end_by_keeper, hide_pointer).run_if(in_kiosk));
}

/// Ends the program when the keeper's keys were held long enough.
fn end_by_keeper(
    keys: Res<ButtonInput<KeyCode>>,
    bindings: Res<Bindings>,
    time: Res<Time<Real>>,
    mut held: Local<Duration>,
    mut exits: MessageWriter<AppExit>,
) {
    let modified = QUIT_MODIFIERS.map(|modifier| keys.any_pressed(modifier.keys()));
    let quits = keys.any_pressed(bindings.of(QUIT).iter().copied());
    if modified != [true; 2] || !quits {
        *held = Duration::ZERO;
        return;
    }
    *held += time.delta().min(MAX_FRAME);
    if *held >= QUIT_HOLD {
        exits.write(AppExit::Success);
    }
}

/// Hides the pointer while the mouse rests.
fn hide_pointer(
    mut moves: MessageReader<CursorMoved>,
    buttons: Res<ButtonInput<MouseButton>>,
    time: Res<Time<Real>>,
    mut moved: Local<Duration>,
    mut hidden: ResMut<HiddenPointer>,
) {
    let used = moves.read().count() > 0 || buttons.get_pressed().next().is_some();
    if used {
        *moved = time.elapsed();
    }
    hidden.0 = time.elapsed().saturating_sub(*moved) >= POINTER_STAY;
}
