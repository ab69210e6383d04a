//! Which keys the controls have: those of the table, unless the settings say otherwise.

use super::controls::{CONTROLS, Control, control_named};
use super::keys::{key_name, key_named, key_names};
use bevy::prelude::{KeyCode, Resource};
use std::collections::BTreeMap;

/// The keys of every control, in the order of the table.
#[derive(Resource, Clone, Debug, PartialEq, Eq)]
pub struct Bindings(Vec<Vec<KeyCode>>);

impl Default for Bindings {
    fn default() -> Self {
        Self(CONTROLS.iter().map(|control| control.keys.to_vec()).collect())
    }
}

impl Bindings {
    /// The table's, with those of some controls replaced: names of keys by names of controls.
    ///
    /// # Errors
    /// One sentence: a control or key that does not exist, or a key that two controls have.
    pub fn new(settings: &BTreeMap<String, Vec<String>>) -> Result<Self, String> {
        let mut bindings = Self::default();
        for (id, names) in settings {
            let place = CONTROLS.iter().position(|control| control.id == id).ok_or_else(|| {
                let known = CONTROLS.iter().map(|control| control.id).collect::<Vec<_>>().join(", ");
                format!("keys: there is no control {id}; the controls are {known}")
            })?;
            let codes = names.iter().map(|name| {
                key_named(name).ok_or_else(|| {
                    let known = key_names().collect::<Vec<_>>().join(" ");
                    format!("keys: {id} is given the key \"{name}\", which is none; the keys are {known}")
                })
            });
            bindings.0[place] = codes.collect::<Result<_, _>>()?;
        }
        for (i, control) in CONTROLS.iter().enumerate() {
            for code in &bindings.0[i] {
                if let Some(other) = bindings.owner(*code, control.alt).filter(|other| other.id != control.id) {
                    let name = key_name(*code).unwrap_or("?");
                    return Err(format!("keys: {name} is given to both {} and {}", other.id, control.id));
                }
            }
        }
        Ok(bindings)
    }

    /// The first control that has this key.
    #[must_use]
    pub fn owner(&self, code: KeyCode, alt: bool) -> Option<&'static Control> {
        self.iter().find(|(control, codes)| control.alt == alt && codes.contains(&code)).map(|(control, _)| control)
    }

    /// Every control with its keys.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Control, &[KeyCode])> {
        CONTROLS.iter().zip(self.0.iter().map(Vec::as_slice))
    }

    /// The keys of one control.
    #[must_use]
    pub fn of(&self, id: &str) -> &[KeyCode] {
        self.iter().find(|(control, _)| control.id == id).map_or(&[], |(_, codes)| codes)
    }

    /// Gives a control this key and no other, and takes it from whoever had it.
    pub fn bind(&mut self, id: &str, code: KeyCode) {
        let Some(bound) = control_named(id) else { return };
        for (control, codes) in CONTROLS.iter().zip(&mut self.0) {
            if control.id == id {
                *codes = vec![code];
            } else if control.alt == bound.alt {
                codes.retain(|other| *other != code);
            }
        }
    }

    /// What the settings file says of the controls that differ from the table.
    #[must_use]
    pub fn settings(&self) -> BTreeMap<String, Vec<String>> {
        let names = |codes: &[KeyCode]| codes.iter().filter_map(|code| key_name(*code)).map(str::to_owned).collect();
        let changed = self.iter().filter(|(control, codes)| control.keys != *codes);
        changed.map(|(control, codes)| (control.id.to_owned(), names(codes))).collect()
    }

    /// The keys of the control with this name, in words; empty where there is none.
    #[must_use]
    pub fn named(&self, id: &str) -> String {
        control_named(id).map(|control| self.in_words(control)).unwrap_or_default()
    }

    /// A control's keys in words, e.g. `F12, Print`.
    #[must_use]
    pub fn in_words(&self, control: &Control) -> String {
        let names = self.of(control.id).iter().filter_map(|code| key_name(*code));
        // The same key on the right is no news.
        let names = names.filter(|name| !name.starts_with("Right ") && !name.starts_with("Keypad "));
        let alt = if control.alt { "Alt+" } else { "" };
        names.map(|name| format!("{alt}{name}")).collect::<Vec<_>>().join(", ")
    }
}
