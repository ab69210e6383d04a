//! The photo mode: nothing is drawn over the picture, and journeys, falls and the disk's clock are
//! paused.

use crate::app::controls::bindings::Bindings;
use crate::app::state::overlays::Overlays;
use crate::app::state::paused::Paused;
use crate::app::state::toast::Toast;
use bevy::prelude::*;

/// The most useful controls in the photo mode and what they do, in two lines.
const KEYS: [&[(&[&str], &str)]; 2] = [
    &[
        (&["fly.orbit"], "goes around the hole"),
        (&["fly.roll_left", "fly.roll_right"], "roll"),
        (&["fly.narrower", "fly.wider"], "field of view"),
        (&["picture.brighter", "picture.darker"], "exposure"),
    ],
    &[
        (&["picture.bypass"], "pixel look"),
        (&["picture.bloom"], "bloom"),
        (&["window.screenshot"], "saves the picture"),
        (&["window.hide"], "ends the photo mode"),
    ],
];

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(
        Update,
        apply_photo_mode.after(super::dock::apply_overlay_commands),
    );
}

/// Pauses all motion when the photo mode begins, and restores the state before when it ends.
fn apply_photo_mode(
    overlays: Res<Overlays>,
    bindings: Res<Bindings>,
    mut paused: ResMut<Paused>,
    mut toast: ResMut<Toast>,
    mut paused_before: Local<Option<bool>>,
) {
    match (overlays.hidden, *paused_before) {
        (true, None) => {
            *paused_before = Some(paused.0);
            paused.0 = true;
            toast.say(keys_in_words(&bindings));
        }
        (false, Some(before)) => {
            *paused_before = None;
            // A mission that has begun meanwhile has ended the pause.
            paused.0 &= before;
            toast.say("Photo mode: off");
        }
        _ => {}
    }
}

/// The message at the beginning of the photo mode.
fn keys_in_words(bindings: &Bindings) -> String {
    let lines = KEYS.map(|line| {
        let entries = line.iter().filter_map(|(ids, does)| {
            let keys = ids.iter().map(|id| bindings.first_name(id));
            let keys: Vec<_> = keys.filter(|key| !key.is_empty()).collect();
            (!keys.is_empty()).then(|| format!("{} {does}", keys.join(" ")))
        });
        entries.collect::<Vec<_>>().join(" · ")
    });
    format!("Photo mode: {}", lines.join("\n"))
}
