//! The program in a browser. The page's address takes the place of the command line: `preset` names
//! a preset, a mission or a lesson, and every other parameter sets a field, as in `?preset=8&hole.spin=0.7`.

use crate::app;
use crate::app::Start;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::journey::Journey;
use lightfall_core::scene::presets::{DEFAULT, PRESETS};
use lightfall_core::scene::{Override, field};
use lightfall_platform::storage::Opened;
use lightfall_platform::{browser, storage};

/// What messages call the address.
const ADDRESS: &str = "the page's address";

/// Runs the program on the page.
pub fn run() {
    storage::report_panics(browser::report);
    if let Err(reason) = start().and_then(app::fly) {
        browser::report(&reason);
    }
}

/// The scene, the mission or the journey of the address or, with a message, the default scene.
fn start() -> Result<Start, String> {
    let usual_scene = PRESETS[DEFAULT - 1].plain_scene();
    let usual = storage::read_journey(None, usual_scene).map_err(|error| error.to_string())?;
    let start = match start_of_address(usual.clone()) {
        Ok(start) => start,
        Err(reason) => {
            let scene = Drawable::new(usual_scene.clone()).map_err(|error| error.to_string())?;
            Start {
                message: Some(reason),
                ..Start::new(scene, usual)
            }
        }
    };
    Ok(Start {
        keeps_own_look: browser::parameters()
            .iter()
            .any(|(key, _)| key == "picture.bypass"),
        ..start
    })
}

/// What the address names, with `usual` as its journey unless it names one. A journey starts at once, in
/// the preset that it names.
fn start_of_address(usual: Journey) -> Result<Start, String> {
    let mut preset = PRESETS[DEFAULT - 1].name.to_owned();
    let mut overrides = Vec::new();
    for (key, value) in browser::parameters() {
        if key == "preset" {
            preset = value;
        } else if field(&key).is_some() || key.contains('.') {
            // Sites add parameters of their own, such as `v` and `utm_source`.
            overrides.push(Override::new(ADDRESS, &key, &value));
        }
    }
    let opened = storage::open_by_name(ADDRESS, preset.as_ref(), &overrides)
        .map_err(|error| error.to_string())?;
    match opened {
        Opened::Journey(journey) => {
            let scene = journey
                .stage()
                .scene(&overrides)
                .map_err(|error| error.to_string())?;
            let journey = storage::flyable_journey(preset.as_ref(), *journey, &scene)
                .map_err(|error| error.to_string())?;
            let scene = Drawable::new(scene).map_err(|error| error.to_string())?;
            Ok(Start {
                plays_journey: true,
                ..Start::new(scene, journey)
            })
        }
        opened => {
            let (scene, mission) = opened.into_parts();
            let scene = Drawable::new(scene).map_err(|error| error.to_string())?;
            Ok(Start {
                mission,
                ..Start::new(scene, usual)
            })
        }
    }
}
