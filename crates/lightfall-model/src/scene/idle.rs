//! Which fields of a scene change nothing at present, why, and what would make them count.

use super::fields::field;
use super::idle_rules::{RULES, Rule};
use super::tables::TURN;
use super::{Scene, SkyMode};

/// The number of waves in a ring of the disk's structure is a multiple of this.
const WAVE_GROUPS: u32 = 4;

/// What a scene is drawn to. Some fields matter to one of these and not to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// The window, in which time passes.
    Window,
    /// One picture as the window would show it.
    Still,
    /// Numbered pictures, in which time passes.
    Sequence,
    /// Linear light and the data of rays.
    Linear,
    /// The rays alone.
    Rays,
}

/// Why a field changes nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Idle {
    /// The reason, as a clause: lower case, without a full stop.
    pub why: &'static str,
    /// The `KEY=VALUE` that makes the field count; empty where there is none.
    pub remedy: &'static str,
}

impl Scene {
    /// Why no value of the field with this key changes what this output shows. `None` if the field
    /// matters, as far as can be said without drawing.
    #[must_use]
    pub fn idle(&self, key: &str, output: Output) -> Option<Idle> {
        let mut rules = self.rules_for(key, output);
        rules.find(|rule| !rule.of_value).map(|rule| rule.idle)
    }

    /// As [`Scene::idle`], and also where another value of the field would count.
    #[must_use]
    pub fn idle_value(&self, key: &str, output: Output) -> Option<Idle> {
        self.rules_for(key, output).next().map(|rule| rule.idle)
    }

    fn rules_for(&self, key: &str, output: Output) -> impl Iterator<Item = &'static Rule> {
        let applies = move |rule: &&Rule| rule.applies(self, key, output);
        RULES.iter().filter(applies)
    }

    /// Whether anything in the scene emits light: the disk, the jets, the sky or the probe.
    #[must_use]
    pub fn shines(&self) -> bool {
        let disk = self.disk.enabled && self.disk.brightness > 0.0;
        let sky = self.sky.mode != SkyMode::Off && self.sky.brightness > 0.0;
        let jets = self.jet.enabled && self.jet.brightness > 0.0;
        disk || jets || sky || self.probe.enabled
    }
}

impl Scene {
    /// Why a field means the same in `other`, though its value differs. `None` if it may not.
    #[must_use]
    pub fn same_value(&self, other: &Self, key: &str) -> Option<&'static str> {
        let field = field(key)?;
        let difference = field.get(other).number()? - field.get(self).number()?;
        let is_turn = field.kind.range() == TURN;
        if is_turn && difference != 0.0 && difference % 360.0 == 0.0 {
            return Some("the scene has the same angle without it, but for whole turns");
        }
        let groups = |scene: &Self| scene.disk.waves / WAVE_GROUPS;
        (key == "disk.waves" && difference != 0.0 && groups(self) == groups(other))
            .then_some("the number of waves is rounded down to a multiple of four")
    }
}

impl Idle {
    /// The reason as a sentence of its own.
    #[must_use]
    pub fn sentence(&self) -> String {
        let mut letters = self.why.chars();
        let first = letters.next().map(|letter| letter.to_ascii_uppercase());
        first.into_iter().chain(letters).chain(['.']).collect()
    }
}
