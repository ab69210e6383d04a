//! Which keys and which gamepad buttons each control is bound to: the defaults of the tables,
//! unless the settings say otherwise.

use super::buttons;
use super::control::{Control, Modifier};
use super::default_keys::{default_places, is_by_place};
use super::key_labels::KeyLabels;
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

    /// The defaults of every control on a keyboard of this layout, in the order of the control
    /// table.
    fn defaults(labels: &KeyLabels) -> Vec<Vec<Self>>;

    /// The input that the name of `input` means for this control: a letter means the key that
    /// prints it, unless the control's keys are meant by place.
    fn meant(control: &Control, input: Self, labels: &KeyLabels) -> Self;

    /// The input by whose name the settings file calls an input of this control.
    fn written(control: &Control, input: Self, labels: &KeyLabels) -> Self;

    /// What is printed on the input, where this is not its name.
    fn print(self, labels: &KeyLabels) -> Option<String>;

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

    fn defaults(labels: &KeyLabels) -> Vec<Vec<Self>> {
        default_places(labels)
    }

    fn meant(control: &Control, input: Self, labels: &KeyLabels) -> Self {
        if is_by_place(control) {
            input
        } else {
            labels.place_of(input)
        }
    }

    fn written(control: &Control, input: Self, labels: &KeyLabels) -> Self {
        if is_by_place(control) {
            input
        } else {
            labels.key_at(input)
        }
    }

    fn print(self, labels: &KeyLabels) -> Option<String> {
        labels.print_of(self)
    }

    fn modifier(control: &Control) -> Option<Modifier> {
        control.modifier
    }
}

impl Bindable for GamepadButton {
    const WORD: &'static str = "button";
    const NAMES: &'static [(Self, &'static str)] = buttons::NAMES;

    fn defaults(_: &KeyLabels) -> Vec<Vec<Self>> {
        let ids = CONTROLS.iter().map(|control| control.id);
        ids.map(|id| buttons::default_buttons(id).to_vec())
            .collect()
    }

    fn meant(_: &Control, input: Self, _: &KeyLabels) -> Self {
        input
    }

    fn written(_: &Control, input: Self, _: &KeyLabels) -> Self {
        input
    }

    fn print(self, _: &KeyLabels) -> Option<String> {
        None
    }

    fn modifier(_: &Control) -> Option<Modifier> {
        None
    }
}

/// The keys of every control.
pub type Bindings = BindingTable<KeyCode>;
/// The gamepad buttons of every control.
pub type PadBindings = BindingTable<GamepadButton>;

/// The inputs of every control.
#[derive(Resource, Clone, Debug, PartialEq, Eq)]
pub struct BindingTable<B: Bindable> {
    /// The inputs, in the order of the control table.
    inputs: Vec<Vec<B>>,
    /// The layout of the keyboard.
    labels: KeyLabels,
}

impl<B: Bindable> Default for BindingTable<B> {
    fn default() -> Self {
        Self::with_defaults(&KeyLabels::default())
    }
}

impl<B: Bindable> BindingTable<B> {
    /// The defaults on a keyboard of this layout.
    #[must_use]
    pub fn with_defaults(labels: &KeyLabels) -> Self {
        Self {
            inputs: B::defaults(labels),
            labels: labels.clone(),
        }
    }

    /// The layout of the keyboard.
    #[must_use]
    pub fn labels(&self) -> &KeyLabels {
        &self.labels
    }

    /// The defaults, with the inputs of some controls replaced: names of inputs by name of control.
    /// A default gives way to them, so that an older settings file stays valid when a new control
    /// has one of its keys as a default. A name may have the prefix of its control's modifier.
    ///
    /// # Errors
    /// One sentence: a control or an input does not exist, or two of the given controls share an
    /// input.
    pub fn new(
        settings: &BTreeMap<String, Vec<String>>,
        labels: &KeyLabels,
    ) -> Result<Self, String> {
        let word = B::WORD;
        let mut bindings = Self::with_defaults(labels);
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
            let control = &CONTROLS[place];
            let prefix = B::modifier(control).map_or("", Modifier::prefix);
            let inputs = names.iter().map(|name| {
                let named = B::from_name(name.strip_prefix(prefix).unwrap_or(name));
                let meant = named.map(|input| B::meant(control, input, labels));
                meant.ok_or_else(|| {
                    let known = B::names().collect::<Vec<_>>().join(" ");
                    format!("{word}s: {id}: unknown {word} \"{name}\"; the {word}s are {known}")
                })
            });
            bindings.inputs[place] = inputs.collect::<Result<_, _>>()?;
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
                let name = bindings.name_of(*input).unwrap_or_default();
                return Err(format!(
                    "{word}s: {name} is given to both {} and {}",
                    other.id, control.id
                ));
            }
            for (other, inputs) in CONTROLS.iter().zip(&mut bindings.inputs) {
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
        CONTROLS.iter().zip(self.inputs.iter().map(Vec::as_slice))
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
        for (control, inputs) in CONTROLS.iter().zip(&mut self.inputs) {
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
        let names = |control: &Control, inputs: &[B]| {
            inputs
                .iter()
                .filter_map(|input| B::written(control, *input, &self.labels).name())
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        self.iter()
            .zip(B::defaults(&self.labels))
            .filter(|((_, inputs), defaults)| defaults != inputs)
            .map(|((control, inputs), _)| (control.id.to_owned(), names(control, inputs)))
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

    /// The names of a control's inputs, for example `F12, Print`. Keys are called by what the
    /// keyboard's layout prints on them.
    #[must_use]
    pub fn label_of(&self, control: &Control) -> String {
        let prefix = B::modifier(control).map_or("", Modifier::prefix);
        self.of(control.id)
            .iter()
            .filter_map(|input| self.name_of(*input))
            // A second key of the same name, on the right or on the keypad, needs no mention.
            .filter(|name| !name.starts_with("Right ") && !name.starts_with("Keypad "))
            .map(|name| format!("{prefix}{name}"))
            .collect::<Vec<_>>()
            .join(", ")
    }

    /// What an input is called: what is printed on it.
    fn name_of(&self, input: B) -> Option<String> {
        let name = input.name()?;
        Some(input.print(&self.labels).unwrap_or_else(|| name.to_owned()))
    }
}
