//! Values that were given by name and change nothing: one sentence for each, which says why and what
//! would make it count.

use super::cli::SceneArgs;
use super::scene::scene_with;
use lightfall_core::scene::journey::Journey;
use lightfall_core::scene::{Idle, Output, Override, Scene, presets};
use lightfall_platform::log::say;
use std::ffi::OsStr;
use std::path::Path;

/// Fields that every saved preset names, whether the picture needs them or not.
const ALWAYS_GIVEN: [&str; 7] = [
    "name",
    "title",
    "picture.width",
    "picture.height",
    "picture.grid_width",
    "picture.grid_height",
    "picture.exposure_ev",
];

/// An option that may change something: only the pictures with and without it can tell.
pub(super) struct Suspect {
    /// As it was written on the command line.
    option: String,
    /// The scene without it.
    pub(super) without: Scene,
}

impl Suspect {
    /// Says that the picture is the same without the option.
    pub(super) fn say_it_is_unused(&self) {
        say(format_args!(
            "lightfall: {} changes no pixel of this picture; what it sets may be hidden, out of view, too \
             small to be seen, or without effect beside other values",
            self.option
        ));
    }
}

/// Says which options that set fields change nothing in `scene`, which they led to, and returns the
/// others. `finish` does to a scene what else the command line asks for. `decided` may give a further
/// reason, such as a journey that sets the same field; its argument is the scene without the option.
pub(super) fn note_unused(
    args: &SceneArgs,
    scene: &Scene,
    output: Output,
    finish: impl Fn(Scene) -> Scene,
    decided: impl Fn(&Scene) -> Option<String>,
) -> Vec<Suspect> {
    let Ok(overrides) = args.overrides() else {
        return Vec::new();
    };
    // A pipe would wait for ever when it is read a second time.
    let is_pipe = |path: &Path| path.exists() && !path.is_file() && !path.is_dir();
    if args.preset.as_deref().map(Path::new).is_some_and(is_pipe) {
        return Vec::new();
    }
    let mut suspects = Vec::new();
    let mut said = Vec::new();
    for (index, given) in overrides.iter().enumerate() {
        // A dome takes all of its values together, and says none of them by name; a picture of the sky
        // takes its mode with its file.
        if given.option == "--dome" || given.option == "--sky" && given.key == "sky.mode" {
            continue;
        }
        let option = written(args, given);
        let Some(unfinished) = without(args, &overrides, index) else {
            continue;
        };
        let without = finish(unfinished.clone());
        let later = overrides[index + 1..]
            .iter()
            .find(|after| after.key == given.key);
        let reason = if let Some(later) = later {
            Some(format!("{} comes after it", written(args, later)))
        } else if let Some(idle) = scene.idle_value(&given.key, output) {
            Some(with_remedy(idle, "--set "))
        } else if without.differences(scene).is_empty() {
            Some(reason_of_equal(&unfinished, args, &overrides).into())
        } else if let Some(reason) = without.same_value(scene, &given.key) {
            Some(reason.into())
        } else {
            decided(&without)
        };
        match reason {
            Some(reason) if !said.contains(&option) => {
                say(format_args!(
                    "lightfall: {option} changes nothing: {reason}"
                ));
                said.push(option);
            }
            None if !said.contains(&option) => {
                said.push(option.clone());
                suspects.push(Suspect { option, without });
            }
            _ => {}
        }
    }
    suspects
}

/// Why the finished scene is the same without an option, which led to the scene `unfinished`.
fn reason_of_equal(unfinished: &Scene, args: &SceneArgs, overrides: &[Override]) -> &'static str {
    let with = scene_with(args, overrides);
    if with.is_ok_and(|with| !with.differences(unfinished).is_empty()) {
        // It alone is applied after the values.
        "--size decides it"
    } else {
        "the scene has this value without it"
    }
}

/// An option as it was written.
fn written(args: &SceneArgs, given: &Override) -> String {
    let value = match given.option {
        "--set" => return format!("--set {}={}", given.key, given.value),
        "--quality" => args.quality.as_deref().unwrap_or_default(),
        "--cells" if given.value == "true" => "off",
        "--cells" => "on",
        _ => &given.value,
    };
    format!("{} {value}", given.option)
}

/// The scene without one of the overrides, or without all of `--quality` or of `--sky`. `None` if
/// there is no such scene.
fn without(args: &SceneArgs, overrides: &[Override], index: usize) -> Option<Scene> {
    let option = overrides[index].option;
    let named = ["--quality", "--sky"].contains(&option);
    let others = overrides
        .iter()
        .enumerate()
        .filter(|(other, given)| *other != index && !(named && given.option == option));
    let others: Vec<_> = others.map(|(_, given)| given.clone()).collect();
    scene_with(args, &others).ok()
}

/// The fields that a user's preset sets and that change nothing, each with the reason. The list of a
/// built-in preset and that of a picture are empty.
pub(super) fn idle_fields(preset: &OsStr, scene: &Scene) -> Vec<String> {
    let mut idle = Vec::new();
    let is_built_in = preset.to_str().and_then(presets::find).is_some();
    if is_built_in || is_in_picture(Path::new(preset)) {
        return idle;
    }
    let default = Scene::default();
    for (key, value) in scene.differences(&default) {
        let reason = scene
            .idle_value(key, Output::Window)
            .map(|reason| with_remedy(reason, ""))
            .or_else(|| default.same_value(scene, key).map(str::to_owned))
            .filter(|_| !ALWAYS_GIVEN.contains(&key));
        if let Some(reason) = reason {
            idle.push(format!("{key} = {value} changes nothing: {reason}"));
        }
    }
    idle
}

/// Whether a preset is in a picture, which holds values that nobody chose by name.
fn is_in_picture(preset: &Path) -> bool {
    let extension = preset.extension().unwrap_or_default();
    ["png", "apng", "exr"]
        .iter()
        .any(|picture| extension.eq_ignore_ascii_case(picture))
}

/// Says in one sentence that a user's preset sets fields that change nothing.
pub(super) fn note_idle_preset(preset: Option<&OsStr>, scene: &Scene) {
    let Some(preset) = preset else {
        return;
    };
    let idle = idle_fields(preset, scene);
    let name = preset.display();
    match idle.as_slice() {
        [] => {}
        [only] => say(format_args!("lightfall: {name}: {only}")),
        [first, others @ ..] => say(format_args!(
            "lightfall: {name}: {first}; {} more of its values change nothing (`lightfall presets check` \
             lists them)",
            others.len()
        )),
    }
}

/// Says which values of a journey's keyframes change nothing in a scene.
pub(super) fn note_idle_journey(file: &Path, journey: &Journey, scene: &Scene) {
    for (name, idle) in journey.idle_values(scene) {
        say(format_args!(
            "lightfall: {}: {name} changes nothing: {}",
            file.display(),
            with_remedy(idle, "--set ")
        ));
    }
}

/// A reason, and the value that would make the field count, in the way it is set.
fn with_remedy(idle: Idle, set: &str) -> String {
    match idle.remedy {
        "" => idle.why.to_owned(),
        remedy => format!("{}; {set}{remedy} uses it", idle.why),
    }
}
