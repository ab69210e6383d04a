//! The program in a browser. The page's address takes the place of the command line: `preset` names
//! a preset or a mission, and every other parameter sets a field, as in `?preset=8&hole.spin=0.7`.

use crate::app;
use crate::app::Start;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::mission::Mission;
use lightfall_core::scene::presets::{DEFAULT, PRESETS};
use lightfall_core::scene::{Override, field};
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

/// The scene or the mission of the address or, with a message, the default scene.
fn start() -> Result<Start, String> {
    let journey_scene = PRESETS[DEFAULT - 1].plain_scene();
    let journey = storage::read_journey(None, journey_scene).map_err(|error| error.to_string())?;
    let (drawable, mission, message) = match scene_of_address() {
        Ok((drawable, mission)) => (drawable, mission, None),
        Err(reason) => {
            let usual = Drawable::new(journey_scene.clone()).map_err(|error| error.to_string())?;
            (usual, None, Some(reason))
        }
    };
    Ok(Start {
        message,
        mission,
        keeps_own_look: browser::parameters()
            .iter()
            .any(|(key, _)| key == "picture.bypass"),
        ..Start::new(drawable, journey)
    })
}

fn scene_of_address() -> Result<(Drawable, Option<Box<Mission>>), String> {
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
    let (scene, mission) = opened.into_parts();
    let drawable = Drawable::new(scene).map_err(|error| error.to_string())?;
    Ok((drawable, mission))
}
