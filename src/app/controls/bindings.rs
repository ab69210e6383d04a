//! Which keys and which gamepad buttons each control is bound to: the defaults of the tables,
//! unless the settings say otherwise.

use super::buttons;
use super::control::{Control, Modifier};
use super::keys;
use super::table::{CONTROLS, control_named};
use bevy::prelude::{GamepadButton, KeyCode, Resource};
use std::collections::BTreeMap;

/// A kind of input that controls are bound to: keys, or buttons of a gamepad.
pub trait Bindable: Copy + PartialEq + Send + Sync + 'static {
    /// The singular noun for such an input in a sentence. Its plural is the name of the table in
    /// the settings file.
    const WORD: &'static str;

    /// Every input that a control can be bound to, with its name.
    const NAMES: &'static [(Self, &'static str)];

    /// The defaults of a control.
    fn defaults(control: &Control) -> &'static [Self];

    /// The modifier that must be held with this control's inputs. The same key with a modifier
    /// and without counts as two.
    fn modifier(control: &Control) -> Option<Modifier>;

    /// The input's name; `None` if no control can be bound to the input.
    fn name(self) -> Option<&'static str> {
        Self::NAMES
            .iter()
            .find(|(input, _)| *input == self)
            .map(|(_, name)| *name)
    }

    /// The input with this name; the case of letters does not matter.
    fn from_name(name: &str) -> Option<Self> {
        Self::NAMES
            .iter()
            .find(|(_, known)| known.eq_ignore_ascii_case(name.trim()))
            .map(|(input, _)| *input)
    }

    /// Every name, in the order of the table.
    fn names() -> impl Iterator<Item = &'static str> {
        Self::NAMES.iter().map(|(_, name)| *name)
    }
}

impl Bindable for KeyCode {
    const WORD: &'static str = "key";
    const NAMES: &'static [(Self, &'static str)] = keys::NAMES;

    fn defaults(control: &Control) -> &'static [Self] {
        control.keys
    }

    fn modifier(control: &Control) -> Option<Modifier> {
        control.modifier
    }
}

impl Bindable for GamepadButton {
    const WORD: &'static str = "button";
    const NAMES: &'static [(Self, &'static str)] = buttons::NAMES;

    fn defaults(control: &Control) -> &'static [Self] {
        buttons::default_buttons(control.id)
    }

    fn modifier(_: &Control) -> Option<Modifier> {
        None
    }
}

/// The keys of every control.
pub type Bindings = BindingTable<KeyCode>;
/// The gamepad buttons of every control.
pub type PadBindings = BindingTable<GamepadButton>;

/// The inputs of every control, in the order of the control table.
#[derive(Resource, Clone, Debug, PartialEq, Eq)]
pub struct BindingTable<B: Bindable>(Vec<Vec<B>>);

impl<B: Bindable> Default for BindingTable<B> {
    fn default() -> Self {
        Self(
            CONTROLS
                .iter()
                .map(|control| B::defaults(control).to_vec())
                .collect(),
        )
    }
}

impl<B: Bindable> BindingTable<B> {
    /// The defaults, with the inputs of some controls replaced: names of inputs by name of control.
    /// A default gives way to them, so that an older settings file stays valid when a new control
    /// has one of its keys as a default. A name may have the prefix of its control's modifier.
    ///
    /// # Errors
    /// One sentence: a control or an input does not exist, or two of the given controls share an
    /// input.
    pub fn new(settings: &BTreeMap<String, Vec<String>>) -> Result<Self, String> {
        let word = B::WORD;
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
            let prefix = B::modifier(&CONTROLS[place]).map_or("", Modifier::prefix);
            let inputs = names.iter().map(|name| {
                B::from_name(name.strip_prefix(prefix).unwrap_or(name)).ok_or_else(|| {
                    let known = B::names().collect::<Vec<_>>().join(" ");
                    format!("{word}s: {id}: unknown {word} \"{name}\"; the {word}s are {known}")
                })
            });
            bindings.0[place] = inputs.collect::<Result<_, _>>()?;
        }
        let given: Vec<(&Control, B)> = bindings
            .iter()
            .filter(|(control, _)| settings.contains_key(control.id))
            .flat_map(|(control, inputs)| inputs.iter().map(move |input| (control, *input)))
            .collect();
        for (place, (control, input)) in given.iter().enumerate() {
            let same = |other: &Control, its_input: B| {
                its_input == *input
                    && other.id != control.id
                    && B::modifier(other) == B::modifier(control)
            };
            if let Some((other, _)) = given[..place].iter().find(|(other, its)| same(other, *its)) {
                let name = input.name().unwrap_or("?");
                return Err(format!(
                    "{word}s: {name} is given to both {} and {}",
                    other.id, control.id
                ));
            }
            for (other, inputs) in CONTROLS.iter().zip(&mut bindings.0) {
                inputs.retain(|its_input| !same(other, *its_input));
            }
        }
        Ok(bindings)
    }

    /// The first control that is bound to this input with exactly this modifier.
    #[must_use]
    pub fn owner(&self, input: B, modifier: Option<Modifier>) -> Option<&'static Control> {
        self.iter()
            .find(|(control, inputs)| B::modifier(control) == modifier && inputs.contains(&input))
            .map(|(control, _)| control)
    }

    /// The control that a press of this input means while a modifier is held. Shift changes only
    /// the keys that have a row with Shift, because it is also the key for flying faster. Alt and
    /// Ctrl leave every other key to the desktop.
    #[must_use]
    pub fn pressed(&self, input: B, held: Option<Modifier>) -> Option<&'static Control> {
        self.owner(input, held).or_else(|| {
            (held == Some(Modifier::Shift))
                .then(|| self.owner(input, None))
                .flatten()
        })
    }

    /// Every control with its inputs.
    pub fn iter(&self) -> impl Iterator<Item = (&'static Control, &[B])> {
        CONTROLS.iter().zip(self.0.iter().map(Vec::as_slice))
    }

    /// The inputs of one control.
    #[must_use]
    pub fn of(&self, id: &str) -> &[B] {
        self.iter()
            .find(|(control, _)| control.id == id)
            .map_or(&[], |(_, inputs)| inputs)
    }

    /// Binds a control to this input alone, and takes the input from the control that had it.
    pub fn bind(&mut self, id: &str, input: B) {
        let Some(bound) = control_named(id) else {
            return;
        };
        for (control, inputs) in CONTROLS.iter().zip(&mut self.0) {
            if control.id == id {
                *inputs = vec![input];
            } else if B::modifier(control) == B::modifier(bound) {
                inputs.retain(|other| *other != input);
            }
        }
    }

    /// The controls whose inputs differ from the defaults, as the settings file has them.
    #[must_use]
    pub fn settings(&self) -> BTreeMap<String, Vec<String>> {
        let names = |inputs: &[B]| {
            inputs
                .iter()
                .filter_map(|input| input.name())
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        self.iter()
            .filter(|(control, inputs)| B::defaults(control) != *inputs)
            .map(|(control, inputs)| (control.id.to_owned(), names(inputs)))
            .collect()
    }

    /// The label of the control with this name, as [`BindingTable::label_of`] writes it. Empty if
    /// there is no such control or no input is bound to it.
    #[must_use]
    pub fn label(&self, id: &str) -> String {
        control_named(id)
            .map(|control| self.label_of(control))
            .unwrap_or_default()
    }

    /// The name of the first input of the control with this name. Empty as [`label`](Self::label) is.
    #[must_use]
    pub fn first_label(&self, id: &str) -> String {
        // A comma may be a key itself.
        let names = self.label(id);
        names.split(", ").next().unwrap_or_default().to_owned()
    }

    /// The names of a control's inputs, for example `F12, Print`.
    #[must_use]
    pub fn label_of(&self, control: &Control) -> String {
        let prefix = B::modifier(control).map_or("", Modifier::prefix);
        self.of(control.id)
            .iter()
            .filter_map(|input| input.name())
            // A second key of the same name, on the right or on the keypad, needs no mention.
            .filter(|name| !name.starts_with("Right ") && !name.starts_with("Keypad "))
            .map(|name| format!("{prefix}{name}"))
            .collect::<Vec<_>>()
            .join(", ")
    }
}
