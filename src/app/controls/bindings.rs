//! Which keys and which buttons of a gamepad the controls have: those of the tables, unless the
//! settings say otherwise.

use crate::app::controls::buttons;
use crate::app::controls::buttons::default_buttons;
use crate::app::controls::keys;
use crate::app::controls::table::{CONTROLS, Control, control_named};
use bevy::prelude::{GamepadButton, KeyCode, Resource};
use std::collections::BTreeMap;

/// What a hand presses.
pub trait Switch: Copy + PartialEq + Send + Sync + 'static {
    /// What it is called in a sentence; with an s, its table in the settings file.
    const WORD: &'static str;

    /// Every one that a control can be bound to, with its name.
    const NAMES: &'static [(Self, &'static str)];

    /// Those of a control where the settings say nothing else.
    fn defaults(control: &Control) -> &'static [Self];

    /// Whether Alt belongs to it for this control. The same switch with Alt and without is two.
    fn with_alt(control: &Control) -> bool;

    /// Its name; none if nothing can be bound to it.
    fn name(self) -> Option<&'static str> {
        Self::NAMES
            .iter()
            .find(|(switch, _)| *switch == self)
            .map(|(_, name)| *name)
    }

    /// The one with this name, however it is capitalized.
    fn named(name: &str) -> Option<Self> {
        Self::NAMES
            .iter()
            .find(|(_, known)| known.eq_ignore_ascii_case(name.trim()))
            .map(|(switch, _)| *switch)
    }

    /// Every name, in the order of the table.
    fn names() -> impl Iterator<Item = &'static str> {
        Self::NAMES.iter().map(|(_, name)| *name)
    }
}

impl Switch for KeyCode {
    const WORD: &'static str = "key";
    const NAMES: &'static [(Self, &'static str)] = keys::NAMES;

    fn defaults(control: &Control) -> &'static [Self] {
        control.keys
    }

    fn with_alt(control: &Control) -> bool {
        control.alt
    }
}

impl Switch for GamepadButton {
    const WORD: &'static str = "button";
    const NAMES: &'static [(Self, &'static str)] = buttons::NAMES;

    fn defaults(control: &Control) -> &'static [Self] {
        default_buttons(control.id)
    }

    fn with_alt(_: &Control) -> bool {
        false
    }
}

/// The keys of every control.
pub type Bindings = Bound<KeyCode>;
/// The buttons of every control, on a gamepad.
pub type PadBindings = Bound<GamepadButton>;

/// The switches of every control, in the order of the key table.
#[derive(Resource, Clone, Debug, PartialEq, Eq)]
pub struct Bound<S: Switch>(Vec<Vec<S>>);

impl<S: Switch> Default for Bound<S> {
    fn default() -> Self {
        Self(
            CONTROLS
                .iter()
                .map(|control| S::defaults(control).to_vec())
                .collect(),
        )
    }
}

impl<S: Switch> Bound<S> {
    /// The table's, with those of some controls replaced: names of switches by names of controls.
    ///
    /// # Errors
    /// One sentence: a control or switch that does not exist, or a switch that two controls have.
    pub fn new(settings: &BTreeMap<String, Vec<String>>) -> Result<Self, String> {
        let word = S::WORD;
        let mut bindings = Self::default();
        for (id, names) in settings {
            let place = CONTROLS
                .iter()
                .position(|control| control.id == id)
                .ok_or_else(|| {
                    let known = CONTROLS
                        .iter()
                        .map(|control| control.id)
                        .collect::<Vec<_>>()
                        .join(", ");
                    format!("{word}s: there is no control {id}; the controls are {known}")
                })?;
            let switches = names.iter().map(|name| {
                S::named(name).ok_or_else(|| {
                    let known = S::names().collect::<Vec<_>>().join(" ");
                    format!("{word}s: {id} is given the {word} \"{name}\", which is none; the {word}s are {known}")
                })
            });
            bindings.0[place] = switches.collect::<Result<_, _>>()?;
        }
        for (control, switches) in bindings.iter() {
            for switch in switches {
                if let Some(other) = bindings
                    .owner(*switch, S::with_alt(control))
                    .filter(|other| other.id != control.id)
                {
                    let name = switch.name().unwrap_or("?");
                    return Err(format!(
                        "{word}s: {name} is given to both {} and {}",
                        other.id, control.id
                    ));
                }
            }
        }
        Ok(bindings)
    }

    /// The first control that has this switch.
    #[must_use]
    pub fn owner(&self, switch: S, alt: bool) -> Option<&'static Control> {
        self.iter()
            .find(|(control, switches)| S::with_alt(control) == alt && switches.contains(&switch))
            .map(|(control, _)| control)
    }

    /// Every control with its switches.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Control, &[S])> {
        CONTROLS.iter().zip(self.0.iter().map(Vec::as_slice))
    }

    /// The switches of one control.
    #[must_use]
    pub fn of(&self, id: &str) -> &[S] {
        self.iter()
            .find(|(control, _)| control.id == id)
            .map_or(&[], |(_, switches)| switches)
    }

    /// Gives a control this switch and no other, and takes it from whoever had it.
    pub fn bind(&mut self, id: &str, switch: S) {
        let Some(bound) = control_named(id) else {
            return;
        };
        for (control, switches) in CONTROLS.iter().zip(&mut self.0) {
            if control.id == id {
                *switches = vec![switch];
            } else if S::with_alt(control) == S::with_alt(bound) {
                switches.retain(|other| *other != switch);
            }
        }
    }

    /// What the settings file says of the controls that differ from the table.
    #[must_use]
    pub fn settings(&self) -> BTreeMap<String, Vec<String>> {
        let names = |switches: &[S]| {
            switches
                .iter()
                .filter_map(|switch| switch.name())
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        let changed = self
            .iter()
            .filter(|(control, switches)| S::defaults(control) != *switches);
        changed
            .map(|(control, switches)| (control.id.to_owned(), names(switches)))
            .collect()
    }

    /// The switches of the control with this name, in words; empty where there is none.
    #[must_use]
    pub fn named(&self, id: &str) -> String {
        control_named(id)
            .map(|control| self.in_words(control))
            .unwrap_or_default()
    }

    /// A control's switches in words, e.g. `F12, Print`.
    #[must_use]
    pub fn in_words(&self, control: &Control) -> String {
        let names = self
            .of(control.id)
            .iter()
            .filter_map(|switch| switch.name());
        // The same key on the right is no news.
        let names =
            names.filter(|name| !name.starts_with("Right ") && !name.starts_with("Keypad "));
        let alt = if S::with_alt(control) { "Alt+" } else { "" };
        names
            .map(|name| format!("{alt}{name}"))
            .collect::<Vec<_>>()
            .join(", ")
    }
}
