//! The keys that controls have at first, on a keyboard of any layout.

use super::control::{Action, Control};
use super::key_labels::{KeyLabels, PRINTED};
use super::table::CONTROLS;
use bevy::prelude::KeyCode;

/// Whether a control's keys are meant by their places: those that are held fly, and form a pattern
/// under the hand.
pub(super) fn is_by_place(control: &Control) -> bool {
    matches!(control.action, Action::Hold(_))
}

/// The places of every control's default keys, in the order of the control table. A letter whose key
/// flies falls back to its US place, or else to the first free key.
pub(super) fn default_places(labels: &KeyLabels) -> Vec<Vec<KeyCode>> {
    let wanted = |control: &Control| match is_by_place(control) {
        true => control.keys.to_vec(),
        false => control
            .keys
            .iter()
            .map(|key| labels.place_of(*key))
            .collect(),
    };
    let mut places: Vec<Vec<KeyCode>> = CONTROLS.iter().map(wanted).collect();
    for (row, control) in CONTROLS
        .iter()
        .enumerate()
        .filter(|(_, control)| !is_by_place(control))
    {
        for (column, key) in control.keys.iter().enumerate() {
            if is_free(&places, row, places[row][column]) {
                continue;
            }
            let others = PRINTED.iter().map(|(place, ..)| *place);
            let mut others = [*key].into_iter().chain(others);
            if let Some(place) = others.find(|place| is_free(&places, row, *place)) {
                places[row][column] = place;
            }
        }
    }
    places
}

/// Whether no control but that of this row is bound to a key, with the modifier of this row.
fn is_free(places: &[Vec<KeyCode>], row: usize, place: KeyCode) -> bool {
    let others = CONTROLS.iter().zip(places).enumerate();
    let mut taken = others.filter(|(other, (control, keys))| {
        *other != row && control.modifier == CONTROLS[row].modifier && keys.contains(&place)
    });
    taken.next().is_none()
}
