//! Nobody is left with an unexplained black screen: from every preset the keys that a newcomer
//! holds, and a fall to its end. In each screenshot the hole, an arrow or a sentence is visible, and
//! a fall announces the horizon.
//!
//! The screenshots are judged by their pixels: once as light, with the user interface over it, and
//! once as the view of ray classes, in which dark rays have a colour of their own. The texts come
//! from egui's own output, and count only where the pixels show them.

use crate::desktop::Desktop;
use crate::{WINDOW, program};
use bevy::ecs::system::SystemParam;
use bevy::input::ButtonState;
use bevy::input::keyboard::{Key, KeyboardInput};
use bevy::prelude::*;
use bevy::render::view::window::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::time::TimeUpdateStrategy;
use bevy::window::PrimaryWindow;
use bevy_egui::{EguiFullOutput, EguiPostUpdateSet, egui};
use lightfall::app::FreeFall;
use lightfall_core::gpu::Drawable;
use lightfall_render::{CurrentScene, Progress};
use std::path::PathBuf;
use std::time::Duration;

/// Names the presets to start from, as digits, in place of [`SOME_PRESETS`].
const PRESETS_VARIABLE: &str = "LIGHTFALL_SCRIPT_PRESETS";
/// The presets of the usual run: far away, the first one, near the horizon, and falling.
const SOME_PRESETS: &str = "1279";
/// Names a folder that keeps the screenshots.
const FOLDER_VARIABLE: &str = "LIGHTFALL_SCRIPT_PICTURES";

/// Time that passes in a frame: as much as one frame may move the camera.
const STEP: f64 = 0.25;
/// Frames that a fall may take: three times as long as the longest one here.
const MAX_FALL_FRAMES: u32 = 800;
/// Frames before a screenshot, in which overlays fade in and the resolution becomes full.
const SETTLING_FRAMES: u32 = 8;

/// What a leg of the script holds, and for how many seconds.
const LEGS: [(&str, Option<(&[KeyCode], f64)>); 6] = [
    ("W", Some((&[KeyCode::KeyW], 10.0))),
    // So fast that nothing but the hole is left in view.
    (
        "Shift-W",
        Some((&[KeyCode::ShiftLeft, KeyCode::KeyW], 10.0)),
    ),
    ("S", Some((&[KeyCode::KeyS], 10.0))),
    ("D", Some((&[KeyCode::KeyD], 8.0))),
    ("Space", Some((&[KeyCode::Space], 8.0))),
    ("fall", None),
];

/// Where the script is.
#[derive(Resource)]
struct Script {
    presets: Vec<char>,
    /// Index of the leg, counted over all presets.
    leg: usize,
    phase: Phase,
    /// Frames since the phase began.
    frames: u32,
    texts: Vec<(String, egui::Rect)>,
    light: Option<Shown>,
    /// Whether the crossing of the horizon was announced since the last fall began.
    crossed: bool,
    /// Whether falls are faster than usual from their beginning.
    is_fast: bool,
    folder: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    Load,
    LetGo,
    Move,
    ShowLight,
    AwaitLight,
    ShowClasses,
    AwaitClasses,
}

/// A screenshot, and the texts that were on it.
struct Shown {
    picture: image::RgbaImage,
    texts: Vec<(String, egui::Rect)>,
}

/// The keyboard as a hand uses it.
#[derive(SystemParam)]
struct Keyboard<'w, 's> {
    window: Single<'w, 's, (Entity, &'static Window), With<PrimaryWindow>>,
    inputs: MessageWriter<'w, KeyboardInput>,
}

impl Keyboard<'_, '_> {
    fn write(&mut self, key_code: KeyCode, state: ButtonState) {
        self.inputs.write(KeyboardInput {
            key_code,
            logical_key: Key::Unidentified(bevy::input::keyboard::NativeKey::Unidentified),
            state,
            text: None,
            repeat: false,
            window: self.window.0,
        });
    }

    fn press(&mut self, key_code: KeyCode) {
        self.write(key_code, ButtonState::Pressed);
        self.write(key_code, ButtonState::Released);
    }
}

fn fly_script(
    mut commands: Commands,
    mut script: ResMut<Script>,
    mut keyboard: Keyboard,
    mut scene: ResMut<CurrentScene>,
    progress: Res<Progress>,
    free_fall: Res<FreeFall>,
    mut exit: MessageWriter<AppExit>,
) {
    let Some(&preset) = script.presets.get(script.leg / LEGS.len()) else {
        eprintln!("script: done");
        exit.write(AppExit::Success);
        return;
    };
    // A disk that moves never comes to rest.
    if scene.disk.rate > 0.0 {
        let mut still = scene.scene().clone();
        still.disk.rate = 0.0;
        scene.0 = Drawable::new(still).unwrap();
    }
    let (name, held) = LEGS[script.leg % LEGS.len()];
    let phase = script.phase;
    script.frames += 1;
    let drawn = *progress == Progress::Done && script.frames > SETTLING_FRAMES;
    let next = match phase {
        Phase::Load if script.frames == 1 => {
            let digit = preset.to_digit(10).unwrap() as usize;
            keyboard.press(DIGITS[digit - 1]);
            None
        }
        Phase::Load => drawn.then_some(match held {
            Some(_) => Phase::Move,
            None => Phase::LetGo,
        }),
        Phase::LetGo => {
            script.crossed = false;
            keyboard.press(KeyCode::KeyF);
            // Four times as fast.
            if !script.is_fast {
                keyboard.press(KeyCode::Period);
                keyboard.press(KeyCode::Period);
            }
            Some(Phase::Move)
        }
        Phase::Move => match held {
            Some((keys, seconds)) => {
                let over = f64::from(script.frames) * STEP > seconds;
                for key in keys {
                    if script.frames == 1 {
                        keyboard.write(*key, ButtonState::Pressed);
                    } else if over {
                        keyboard.write(*key, ButtonState::Released);
                    }
                }
                over.then_some(Phase::ShowLight)
            }
            None => {
                let over = script.frames > 2 && !free_fall.is_moving();
                // The next fall begins at the usual pace. But where the disk moves, the keys are those of
                // its clock now.
                script.is_fast = scene.disk_moves();
                if over && !script.is_fast {
                    keyboard.press(KeyCode::Comma);
                    keyboard.press(KeyCode::Comma);
                }
                (over || script.frames > MAX_FALL_FRAMES).then_some(Phase::ShowLight)
            }
        },
        Phase::ShowLight | Phase::ShowClasses => drawn.then(|| {
            let texts = script.texts.clone();
            commands.spawn(Screenshot::primary_window()).observe(
                move |shot: On<ScreenshotCaptured>, mut script: ResMut<Script>| {
                    let picture = shot.image.clone().try_into_dynamic().unwrap().to_rgba8();
                    let texts = texts.clone();
                    script.receive(Shown { picture, texts });
                },
            );
            match phase {
                Phase::ShowLight => Phase::AwaitLight,
                _ => Phase::AwaitClasses,
            }
        }),
        Phase::AwaitLight => script.light.is_some().then(|| {
            keyboard.press(KeyCode::KeyB);
            keyboard.press(KeyCode::KeyH);
            Phase::ShowClasses
        }),
        Phase::AwaitClasses => script.light.is_none().then(|| {
            keyboard.press(KeyCode::KeyH);
            eprintln!("script: preset {preset} {name} at r {:.3}", scene.camera.r);
            script.leg += 1;
            Phase::Load
        }),
    };
    if let Some(next) = next {
        (script.phase, script.frames) = (next, 0);
    }
}

const DIGITS: [KeyCode; 9] = [
    KeyCode::Digit1,
    KeyCode::Digit2,
    KeyCode::Digit3,
    KeyCode::Digit4,
    KeyCode::Digit5,
    KeyCode::Digit6,
    KeyCode::Digit7,
    KeyCode::Digit8,
    KeyCode::Digit9,
];

impl Script {
    /// Takes a screenshot of light, or with one of ray classes judges both.
    fn receive(&mut self, shown: Shown) {
        let preset = self.presets[self.leg / LEGS.len()];
        let name = LEGS[self.leg % LEGS.len()].0;
        let Some(light) = self.light.take() else {
            if let Some(folder) = &self.folder {
                let file = folder.join(format!("{preset}-{name}.png"));
                shown.picture.save(file).unwrap();
            }
            self.light = Some(shown);
            return;
        };
        let mut verdict = judge(&light, &shown.picture);
        verdict.found &= name != "fall" || self.crossed;
        eprintln!("script: preset {preset} {name}: {verdict}");
    }
}

/// What the screenshots show.
struct Verdict {
    /// Share of the picture whose rays come from the hole.
    hole: f64,
    /// Share that is dark: from the hole, and not through the disk.
    dark: f64,
    /// The sentence or card that explains the picture, where the pixels show it.
    sentence: Option<String>,
    /// The label of an arrow or a ring, where the pixels show it.
    mark: Option<String>,
    /// Whether a player can tell where the hole is, and was told of crossing the horizon.
    found: bool,
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            hole,
            dark,
            sentence,
            mark,
            found,
        } = self;
        let found = if *found { "found" } else { "lost" };
        write!(
            f,
            "{found}; hole {hole:.4}, dark {dark:.3}, sentence {sentence:?}, mark {mark:?}"
        )
    }
}

fn judge(light: &Shown, classes: &image::RgbaImage) -> Verdict {
    let counted = |is: fn([u8; 4]) -> bool| {
        let pixels = classes.pixels().filter(|pixel| is(pixel.0)).count();
        pixels as f64 / f64::from(classes.width() * classes.height())
    };
    // Rays from the hole are shown in brown to yellow, the others in blue; the darkest brown has
    // not met the disk.
    let hole = counted(|[red, _, blue, _]| red > blue);
    let dark = counted(|[red, green, blue, _]| red > blue && green < 60);
    let find = |starts: &[&str]| {
        light
            .texts
            .iter()
            .find(|(text, rect)| {
                starts.iter().any(|start| text.starts_with(start)) && is_legible(light, *rect)
            })
            .map(|(text, _)| text.clone())
    };
    let sentence = find(&["The hole fills the view", "The fall ends here"]);
    let mark = find(&["hole", "sky"]);
    // A hole that covers a thousandth of the picture is 50 pixels across. One that leaves less than
    // three hundredths of it has no shape.
    let shows = hole > 0.001 && dark < 0.97;
    let found = sentence.is_some() || dark < 0.97 && (mark.is_some() || shows);
    Verdict {
        hole,
        dark,
        sentence,
        mark,
        found,
    }
}

/// Whether the pixels of a text differ as much as 4.5:1, in the contrast of WCAG 2.
fn is_legible(light: &Shown, rect: egui::Rect) -> bool {
    let luminance = |pixel: &image::Rgba<u8>| {
        let [red, green, blue] = [0, 1, 2].map(|channel: usize| {
            let value = f64::from(pixel.0[channel]) / 255.0;
            if value <= 0.04045 {
                value / 12.92
            } else {
                ((value + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    };
    let (width, height) = light.picture.dimensions();
    let columns = rect.left().max(0.0) as u32..(rect.right().max(0.0) as u32).min(width);
    let rows = rect.top().max(0.0) as u32..(rect.bottom().max(0.0) as u32).min(height);
    let pixels = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
    let [mut least, mut most] = [f64::INFINITY, 0.0];
    for (x, y) in pixels {
        let found = luminance(light.picture.get_pixel(x, y));
        (least, most) = (found.min(least), found.max(most));
    }
    (most + 0.05) / (least + 0.05) >= 4.5
}

/// Notes the texts that egui draws in this frame. At the usual scale a point is a pixel.
fn read_texts(mut script: ResMut<Script>, outputs: Query<&EguiFullOutput>) {
    fn collect(shape: &egui::Shape, texts: &mut Vec<(String, egui::Rect)>) {
        match shape {
            egui::Shape::Text(text) => {
                texts.push((text.galley.text().to_owned(), text.visual_bounding_rect()));
            }
            egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, texts)),
            _ => {}
        }
    }
    script.texts.clear();
    for output in outputs.iter().filter_map(|output| output.0.as_ref()) {
        for clipped in &output.shapes {
            collect(&clipped.shape, &mut script.texts);
        }
    }
    let announced = |(text, _): &(String, _)| text == "You have crossed the horizon";
    let crossed = script.texts.iter().any(announced);
    script.crossed |= crossed;
}

/// The program that flies the script by itself. This is no test: the test below starts it as another
/// process.
#[test]
#[ignore = "started by the test of the script"]
fn started_program_that_flies_the_script() {
    let presets = std::env::var(PRESETS_VARIABLE).unwrap_or_else(|_| SOME_PRESETS.into());
    let mut app = program();
    app.insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs_f64(
        STEP,
    )))
    .insert_resource(Script {
        presets: presets.chars().collect(),
        leg: 0,
        phase: Phase::Load,
        frames: 0,
        texts: Vec::new(),
        light: None,
        crossed: false,
        is_fast: false,
        folder: std::env::var_os(FOLDER_VARIABLE).map(PathBuf::from),
    })
    .add_systems(First, fly_script)
    .add_systems(
        PostUpdate,
        read_texts
            .after(EguiPostUpdateSet::EndPass)
            .before(EguiPostUpdateSet::ProcessOutput),
    );
    assert_eq!(app.run(), AppExit::Success);
}

#[test]
#[ignore = "needs a graphics adapter, Xvfb and xdotool"]
fn after_each_leg_of_the_script_the_hole_an_arrow_or_a_sentence_is_visible() {
    let program = std::env::current_exe().unwrap();
    let only = [
        "--exact",
        "lost::started_program_that_flies_the_script",
        "--ignored",
        "--test-threads=1",
        "--nocapture",
    ];
    let started = std::time::Instant::now();
    let screen = (WINDOW.0 as u16 + 60, WINDOW.1 as u16 + 90);
    let mut desktop = Desktop::open_on(screen, &program, &only);
    while !desktop.stderr().contains("script: done") {
        assert!(desktop.running(), "{}", desktop.stderr());
        assert!(
            started.elapsed() < Duration::from_secs(1500),
            "{}",
            desktop.stderr()
        );
        std::thread::sleep(Duration::from_millis(200));
    }
    let stderr = desktop.stderr();
    let verdicts: Vec<&str> = stderr
        .lines()
        .filter(|line| line.contains("dark "))
        .collect();
    for line in stderr.lines().filter(|line| line.starts_with("script:")) {
        println!("{line}");
    }
    println!("{:.0?}", started.elapsed());
    let presets = std::env::var(PRESETS_VARIABLE).map_or(SOME_PRESETS.len(), |list| list.len());
    assert_eq!(verdicts.len(), presets * LEGS.len());
    let lost: Vec<_> = verdicts
        .iter()
        .filter(|line| !line.contains(": found"))
        .collect();
    assert!(lost.is_empty(), "{lost:#?}");
}
