//! Nobody is left with an unexplained black screen: from every preset the keys that a newcomer
//! holds, and a fall to its end. In each screenshot the hole, an arrow or a sentence is visible, and
//! a fall announces the horizon.
//!
//! The screenshots are judged by their pixels: once as light, with the user interface over it, and
//! once as the view of ray classes, in which dark rays have a colour of their own. The texts come
//! from egui's own output, and count only where the pixels show them.

use crate::desktop::Desktop;
use crate::messages::{contrast, luminance, pixels};
use crate::shot::Shot;
use lightfall_core::scene::presets;
use watched::{Order, Place, Text};

/// Names the presets to start from, as digits, in place of [`SOME_PRESETS`].
const PRESETS_VARIABLE: &str = "LIGHTFALL_SCRIPT_PRESETS";
/// The presets of the usual run: far away, the first one, near the horizon, and falling.
const SOME_PRESETS: &str = "1279";
/// Names a folder that keeps the screenshots.
const FOLDER_VARIABLE: &str = "LIGHTFALL_SCRIPT_PICTURES";

/// Time of a frame, in seconds: as much as one frame may move the camera.
const STEP: f64 = 0.25;

/// Pace of the falls: four times the usual one. At a higher pace the observer may be inside the
/// horizon for so few frames that no state shows the announcement.
const FALL_PACE: f64 = 0.4;

/// The legs of the script: their names, the keys that each holds, and for how many seconds.
const LEGS: [(&str, &[&str], f64); 6] = [
    ("W", &["w"], 10.0),
    // So fast that nothing but the hole is left in view.
    ("Shift-W", &["shift", "w"], 10.0),
    ("S", &["s"], 10.0),
    ("D", &["d"], 8.0),
    ("Space", &["space"], 8.0),
    ("fall", &[], 0.0),
];

/// Loads a preset, with a disk at rest.
fn load(desktop: &Desktop, number: &str) {
    desktop.press(number);
    let mut scene = presets::find(number).unwrap().scene(&[]).unwrap();
    scene.disk.rate = 0.0;
    desktop.order(&Order::Show(scene.to_preset()));
    desktop.settled("the preset", |_| true);
}

/// Holds keys for so many seconds of the program's.
fn hold(desktop: &Desktop, keys: &[&str], seconds: f64) {
    keys.iter().for_each(|key| desktop.hold(key));
    desktop.later((seconds / STEP) as u32);
    keys.iter().for_each(|key| desktop.let_go(key));
}

/// Lets the observer fall to the end, four times as fast as usual.
fn fall(desktop: &Desktop) {
    desktop.press_at_once("f");
    // The pace of one fall is that of the next. After a fall the keys change the rate of a moving
    // disk's clock instead, so that the pace is not set back.
    if desktop.state().pace < FALL_PACE {
        for _ in 0..2 {
            desktop.press_at_once("period");
        }
    }
    desktop.wait_for("the crossing of the horizon", |state| {
        state.shows("You have crossed the horizon")
    });
    let end = desktop.wait_for("the end of the fall", |state| !state.falls);
    assert_eq!(end.pace, FALL_PACE);
}

/// What the screenshots show.
#[derive(Debug)]
struct Verdict {
    /// Share of the picture whose rays come from the hole.
    hole: f64,
    /// Share that is dark: from the hole, and not through the disk.
    dark: f64,
    /// The sentence or card that explains the picture, where the pixels show it.
    sentence: Option<String>,
    /// The label of an arrow or a ring, where the pixels show it.
    mark: Option<String>,
}

impl Verdict {
    fn of(light: &Shot, texts: &[Text], classes: &Shot) -> Self {
        let share = |is: fn([u8; 3]) -> bool| {
            let (width, height) = (classes.width, classes.height);
            let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
            let found = pixels.filter(|&(x, y)| is(classes.pixel(x, y))).count();
            found as f64 / (width * height) as f64
        };
        let find = |starts: &[&str]| {
            let legible = |text: &&Text| {
                starts.iter().any(|start| text.words.starts_with(start))
                    && is_legible(light, text.place)
            };
            texts.iter().find(legible).map(|text| text.words.clone())
        };
        Self {
            // Rays from the hole are shown in brown to yellow, the others in blue; the darkest brown
            // has not met the disk.
            hole: share(|[red, _, blue]| red > blue),
            dark: share(|[red, green, blue]| red > blue && green < 60),
            sentence: find(&["The hole fills the view", "The fall ends here"]),
            mark: find(&["hole", "sky"]),
        }
    }

    /// Whether a player can tell where the hole is.
    fn is_found(&self) -> bool {
        // A hole that covers a thousandth of the picture is 20 pixels across. One that leaves less
        // than three hundredths of it has no shape.
        let has_shape = self.dark < 0.97;
        self.sentence.is_some() || has_shape && (self.mark.is_some() || self.hole > 0.001)
    }
}

/// Whether the pixels of a text differ as much as 4.5:1.
fn is_legible(light: &Shot, place: Place) -> bool {
    let [columns, rows] = pixels(place);
    let rows = rows.start..rows.end.min(light.height);
    let [mut least, mut most] = [f64::INFINITY, 0.0];
    for (x, y) in rows.flat_map(|y| columns.clone().map(move |x| (x, y))) {
        if x < light.width {
            let found = luminance(light.pixel(x, y));
            (least, most) = (found.min(least), found.max(most));
        }
    }
    contrast(least, most) >= 4.5
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn after_each_leg_of_the_script_the_hole_an_arrow_or_a_sentence_is_visible() {
    let desktop = Desktop::open_small(&["--preset", "2"]);
    desktop.first_picture();
    desktop.order(&Order::Step(STEP));
    let presets = std::env::var(PRESETS_VARIABLE).unwrap_or_else(|_| SOME_PRESETS.into());
    let mut lost = Vec::new();
    for preset in presets.chars() {
        for (name, keys, seconds) in LEGS {
            load(&desktop, &preset.to_string());
            if name == "fall" {
                fall(&desktop);
            } else {
                hold(&desktop, keys, seconds);
            }
            let light = desktop.settled(name, |_| true);
            let state = desktop.state();
            if let Some(folder) = std::env::var_os(FOLDER_VARIABLE) {
                let file = std::path::Path::new(&folder).join(format!("{preset}-{name}.png"));
                light.save(&file);
            }
            desktop.press("b");
            desktop.press("h");
            let classes = desktop.settled("the classes", |_| true);
            desktop.press("h");
            let verdict = Verdict::of(&light, &state.texts, &classes);
            let r = state.number("camera.r");
            println!("preset {preset} {name}: r {r:.3}, {verdict:?}");
            if !verdict.is_found() {
                lost.push(format!("preset {preset} {name}: {verdict:?}"));
            }
        }
    }
    assert!(lost.is_empty(), "{lost:#?}");
}
