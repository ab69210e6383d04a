//! The state of the watched program.

use lightfall_core::scene::Scene;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// Fields that the window itself sets, to fit its size and to stay fluent.
const OF_THE_WINDOW: [&str; 4] = [
    "picture.width",
    "picture.height",
    "picture.grid_width",
    "picture.grid_height",
];

/// What the program is at the end of a frame.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The number of the frame.
    pub frame: u32,
    /// The number of frames in a row in which the picture was drawn and nothing moved.
    pub rested: u32,
    /// The number of keys pressed so far.
    pub keys: u32,
    /// The number of orders obeyed so far.
    pub orders: u32,
    /// The fields of the scene, as in a preset, without those that the window sets.
    pub scene: BTreeMap<String, Value>,
    /// The texts that can be seen.
    pub texts: Vec<Text>,
    /// Where the mouse can click or drag something.
    pub widgets: Vec<Place>,
    /// The boxes over the picture, each with its name.
    pub boxes: Vec<(String, Place)>,
    /// What was shown after the last key.
    pub answer: Answer,
    /// Seconds along the journey while it is flown.
    pub journey: Option<f64>,
    /// Whether an observer was let go and still moves.
    pub falls: bool,
    /// The ship, while the hands fly it.
    pub ship: Option<ShipState>,
    /// The loudness of what the ship's pilot hears.
    pub volume: f64,
    /// How many points of the ship's path ahead the picture shows.
    pub path_points: usize,
    /// How fast the observer's time passes when it falls.
    pub pace: f64,
    /// How far the picture of the scene is drawn, e.g. `Averaging(3)` or `Done`.
    pub progress: String,
    /// Whether frames are far apart because nothing happens.
    pub resting: bool,
    /// Whether the menu is open.
    pub menu: bool,
    /// How two scenes are compared; empty while none are.
    pub comparison: String,
    /// Whether the mouse looks around and its arrow is hidden.
    pub grabs_mouse: bool,
    /// Whether the mouse's arrow is shown over the window.
    pub shows_pointer: bool,
    /// Whether the window is to fill the screen.
    pub full_screen: bool,
    /// Whether the picture was kept, and for each frame after the key for more light whether its
    /// picture differs from the one that was kept.
    pub kept: Option<Vec<bool>>,
}

/// The ship in the player's hands. Lengths are in r_s, times in r_s/c.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ShipState {
    /// The ship's own clock.
    pub own_time: f64,
    /// The radii of the turning points if it coasts.
    pub periapsis: Option<f64>,
    /// See `periapsis`.
    pub apoapsis: Option<f64>,
    /// The proper acceleration, in c^2/r_s.
    pub acceleration: f64,
    /// The rapidity spent.
    pub rapidity_used: f64,
    /// How fast its time passes, as a multiple of the usual pace.
    pub pace: f64,
    /// What holds it and where, such as `Orbit(6.0)`; empty if nothing does.
    pub hold: String,
    /// What its nose turns to or follows, such as `Retrograde`; empty if the gyroscopes hold it.
    pub heading: String,
    /// The attempt at a mission: its name and its outcome; empty without one.
    pub mission: [String; 2],
}

/// A rectangle of the window, in points, which are pixels at the usual scale.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// The left, upper corner.
    pub min: [f32; 2],
    /// The right, lower corner.
    pub max: [f32; 2],
}

/// A text in the window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Text {
    /// The words, in one line.
    pub words: String,
    /// Where its letters are.
    pub place: Place,
    /// Its opacity, from 0 to 1.
    pub opacity: f32,
}

/// The texts that were shown within two frames after a key.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The number of the key.
    pub key: u32,
    /// All of them.
    pub shown: BTreeSet<String>,
    /// Those that were not shown before.
    pub new: BTreeSet<String>,
}

impl Place {
    /// Its centre.
    #[must_use]
    pub fn centre(&self) -> [f32; 2] {
        [0, 1].map(|axis| (self.min[axis] + self.max[axis]) / 2.0)
    }
}

impl State {
    /// A number of the scene.
    ///
    /// # Panics
    /// If the scene has no such number.
    #[must_use]
    pub fn number(&self, key: &str) -> f64 {
        self.scene
            .get(key)
            .and_then(Value::as_f64)
            .unwrap_or_else(|| panic!("the scene has no number {key}"))
    }

    /// Whether a text that begins so can be seen.
    #[must_use]
    pub fn shows(&self, start: &str) -> bool {
        self.texts.iter().any(|text| text.words.starts_with(start))
    }

    /// Whether a text with these words in it can be seen.
    #[must_use]
    pub fn mentions(&self, words: &str) -> bool {
        self.texts.iter().any(|text| text.words.contains(words))
    }

    /// The centre of the text with these words or, where there is none, of one that begins so.
    #[must_use]
    pub fn place_of(&self, words: &str) -> Option<[f32; 2]> {
        let whole = self.texts.iter().find(|text| text.words == words);
        let begins = |text: &&Text| text.words.starts_with(words);
        let text = whole.or_else(|| self.texts.iter().find(begins));
        text.map(|text| text.place.centre())
    }

    /// The centre of the widget to the right of a label.
    #[must_use]
    pub fn field_of(&self, label: &str) -> Option<[f32; 2]> {
        let label = self.texts.iter().find(|text| text.words == label)?.place;
        let in_line = |place: &&Place| {
            let [_, y] = label.centre();
            place.min[0] >= label.max[0] && (place.min[1]..place.max[1]).contains(&y)
        };
        let fields = self.widgets.iter().filter(in_line);
        let nearest = fields.min_by(|a, b| a.min[0].total_cmp(&b.min[0]));
        nearest.map(Place::centre)
    }

    /// The fields of the scene whose value differs from another state's, with the value here.
    #[must_use]
    pub fn changed_since(&self, before: &Self) -> BTreeMap<String, Value> {
        let changed = |(key, value): &(&String, &Value)| before.scene.get(*key) != Some(*value);
        let fields = self.scene.iter().filter(changed);
        fields
            .map(|(key, value)| (key.clone(), value.clone()))
            .collect()
    }
}

/// The fields of a scene by their keys, without those that the window sets.
///
/// # Panics
/// If the preset that the scene writes cannot be read.
#[must_use]
pub fn fields_of(scene: &Scene) -> BTreeMap<String, Value> {
    fn collect(prefix: &str, table: toml::Table, fields: &mut BTreeMap<String, Value>) {
        for (name, value) in table {
            let key = format!("{prefix}{name}");
            match value {
                toml::Value::Table(table) => collect(&format!("{key}."), table, fields),
                value => drop(fields.insert(key, serde_json::json!(value))),
            }
        }
    }
    let preset = scene.to_preset().parse().expect("a scene writes a preset");
    let mut fields = BTreeMap::new();
    collect("", preset, &mut fields);
    fields.retain(|key, _| !OF_THE_WINDOW.contains(&key.as_str()));
    fields
}
