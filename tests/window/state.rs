//! The window's state, which a program under test writes down after every frame, and a session in
//! which a test presses keys and reads it.

use crate::desktop::Desktop;
use crate::{PLAIN, program};
use bevy::diagnostic::FrameCount;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use bevy::window::{CursorGrabMode, CursorOptions, PrimaryWindow, WindowMode};
use bevy_egui::{EguiFullOutput, EguiPostUpdateSet, egui};
use lightfall::app::{DiskClock, FreeFall, JourneyPlayer, Menu};
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Scene, load};
use lightfall_render::{Comparison, ComparisonMode, CurrentScene, DrawnScene, Progress};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Time that passes in a frame, however long the frame takes: how far a held key moves the camera
/// depends on the number of frames alone.
const STEP: Duration = Duration::from_millis(50);
/// Frames within which a key has done what it does.
const PROMPT: u32 = 3;

/// Maximum time to wait for a state: a software renderer on a busy machine may need seconds for a
/// frame, and a minute for a new shader.
const PATIENCE: Duration = Duration::from_secs(60);

/// Fields that the window itself sets, to fit its size and to stay fluent.
const OF_THE_WINDOW: [&str; 4] = [
    "picture.width",
    "picture.height",
    "picture.grid_width",
    "picture.grid_height",
];

/// What the program remembers at the end of a frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// The number of the frame.
    pub frame: u32,
    /// The fields of the scene, as in a preset, without those that the window sets.
    pub scene: BTreeMap<String, Value>,
    /// The texts over the picture that can be seen.
    pub texts: BTreeSet<String>,
    /// Seconds along the journey while it is flown.
    pub journey: Option<f64>,
    /// Whether an observer was let go and still moves.
    pub falls: bool,
    /// How fast the observer's time passes when it falls.
    pub pace: f64,
    /// How far the picture of the scene is drawn, e.g. `Averaging(3)` or `Done`.
    pub progress: String,
    /// Whether the menu is open.
    pub menu: bool,
    /// How two scenes are compared; empty while none are.
    pub comparison: String,
    /// Whether the mouse looks around and its arrow is hidden.
    pub grabs_mouse: bool,
    /// Whether the window is to fill the screen.
    pub full_screen: bool,
}

impl State {
    /// A number of the scene.
    pub fn number(&self, key: &str) -> f64 {
        self.scene[key].as_f64().unwrap()
    }

    /// Whether a text that begins so can be seen.
    pub fn shows(&self, start: &str) -> bool {
        self.texts.iter().any(|text| text.starts_with(start))
    }

    /// The fields of the scene whose value differs from another state's, with the value here.
    pub fn changed_since(&self, before: &Self) -> BTreeMap<String, Value> {
        let changed = |(key, value): &(&String, &Value)| before.scene.get(*key) != Some(*value);
        let fields = self.scene.iter().filter(changed);
        fields
            .map(|(key, value)| (key.clone(), value.clone()))
            .collect()
    }
}

/// The fields of a scene by their keys, without those that the window sets.
pub fn fields_of(scene: &Scene) -> BTreeMap<String, Value> {
    fn collect(prefix: &str, value: Value, fields: &mut BTreeMap<String, Value>) {
        match value {
            Value::Object(table) => {
                for (name, value) in table {
                    let dot = if prefix.is_empty() { "" } else { "." };
                    collect(&format!("{prefix}{dot}{name}"), value, fields);
                }
            }
            value => {
                fields.insert(prefix.to_owned(), value);
            }
        }
    }
    let preset: toml::Table = scene.to_preset().parse().unwrap();
    let mut fields = BTreeMap::new();
    collect("", serde_json::to_value(preset).unwrap(), &mut fields);
    fields.retain(|key, _| !OF_THE_WINDOW.contains(&key.as_str()));
    fields
}

fn plain_scene() -> Scene {
    load(PLAIN, include_str!("plain.toml"), &[]).unwrap()
}

/// The texts of a shape that can be seen.
fn collect_texts(shape: &egui::Shape, texts: &mut BTreeSet<String>) {
    match shape {
        egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect_texts(shape, texts)),
        egui::Shape::Text(text) if text.opacity_factor > 0.2 => {
            texts.insert(text.galley.text().replace('\n', " "));
        }
        _ => {}
    }
}

fn write_state(
    frame: Res<FrameCount>,
    scene: Res<DrawnScene>,
    outputs: Query<&EguiFullOutput>,
    (player, fall, progress): (Res<JourneyPlayer>, Res<FreeFall>, Res<Progress>),
    (menu, comparison): (Res<Menu>, Res<Comparison>),
    window: Single<(&Window, &CursorOptions), With<PrimaryWindow>>,
) {
    let mut texts = BTreeSet::new();
    for output in outputs.iter().filter_map(|output| output.0.as_ref()) {
        for clipped in &output.shapes {
            collect_texts(&clipped.shape, &mut texts);
        }
    }
    let (window, cursor) = *window;
    let state = State {
        frame: frame.0,
        scene: fields_of(scene.scene()),
        texts,
        journey: player.is_playing().then(|| player.time()),
        falls: fall.is_moving(),
        pace: fall.rate(1.0),
        progress: format!("{:?}", *progress),
        menu: menu.is_open(),
        comparison: match comparison.0.as_ref().map(|(_, mode)| *mode) {
            None => String::new(),
            Some(ComparisonMode::SideBySide { .. }) => "side by side".into(),
            Some(ComparisonMode::Difference { gain }) => format!("difference times {gain}"),
        },
        grabs_mouse: cursor.grab_mode != CursorGrabMode::None && !cursor.visible,
        full_screen: window.mode != WindowMode::Windowed,
    };
    // Renamed when it is complete, so that nobody reads half of it.
    let file = state_file(Path::new(&std::env::var_os("HOME").unwrap()));
    let part = file.with_extension("part");
    std::fs::write(&part, serde_json::to_vec(&state).unwrap()).unwrap();
    std::fs::rename(part, file).unwrap();
}

fn state_file(home: &Path) -> PathBuf {
    home.join("state.json")
}

/// Keypad 0 shows the first scene again.
fn show_first_scene(
    keys: Res<ButtonInput<KeyCode>>,
    mut scene: ResMut<CurrentScene>,
    mut clock: ResMut<DiskClock>,
) {
    if keys.just_pressed(KeyCode::Numpad0) {
        scene.0 = Drawable::new(plain_scene()).unwrap();
        clock.set(scene.disk.time);
    }
}

/// The program, which writes down its state. This is no test: sessions start it as another process.
#[test]
#[ignore = "started by the tests of keys"]
fn started_program_that_writes_down_its_state() {
    let mut app = program();
    app.insert_resource(TimeUpdateStrategy::ManualDuration(STEP))
        .add_systems(Update, show_first_scene)
        .add_systems(
            PostUpdate,
            write_state
                .after(EguiPostUpdateSet::EndPass)
                .before(EguiPostUpdateSet::ProcessOutput),
        );
    assert_eq!(app.run(), AppExit::Success);
}

/// A window with the plain scene, whose state can be read.
pub struct Session {
    pub desktop: Desktop,
}

impl Session {
    /// Opens the window, with these variables of the environment.
    pub fn open(variables: &[(&str, &str)]) -> Self {
        let program = std::env::current_exe().unwrap();
        let only = [
            "--exact",
            "state::started_program_that_writes_down_its_state",
            "--ignored",
            "--test-threads=1",
            "--nocapture",
        ];
        let desktop = Desktop::open_program_with_variables(&program, variables, &only);
        desktop.first_picture();
        let session = Self { desktop };
        session.show_first_scene();
        session
    }

    /// The state after the last frame.
    pub fn state(&self) -> State {
        let bytes = std::fs::read(state_file(self.desktop.home.path())).unwrap();
        serde_json::from_slice(&bytes).unwrap()
    }

    /// Waits for a state, and returns it.
    pub fn wait(&self, what: &str, so: impl Fn(&State) -> bool) -> State {
        let start = Instant::now();
        loop {
            let state = self.state();
            if so(&state) {
                return state;
            }
            let stderr = self.desktop.stderr();
            assert!(
                start.elapsed() < PATIENCE,
                "{what} does not come: {state:#?} {stderr}"
            );
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// The state some frames later. The pointer moves and comes back, so that there are frames.
    pub fn later(&self, frames: u32) -> State {
        let last = self.state().frame + frames;
        self.desktop.wait("more frames", || {
            self.desktop.look(1, 0);
            self.desktop.look(-1, 0);
            self.state().frame >= last
        });
        self.state()
    }

    /// Presses a key, and returns the state when it has done what it does.
    pub fn press(&self, key: &str) -> State {
        self.desktop.press(key);
        self.later(PROMPT)
    }

    /// Shows the first scene again, and returns its state.
    pub fn show_first_scene(&self) -> State {
        let first = fields_of(&plain_scene());
        // The keysym of keypad 0 without Num Lock.
        self.press("KP_Insert");
        self.wait("the first scene", |state| state.scene == first)
    }
}
