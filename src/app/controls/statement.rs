//! What a control says when it has changed the scene: the state that it has led to.

use super::control::{Action, Control};
use lightfall_core::numbers::{four_digits, spin_digits, with_short_numbers};
use lightfall_core::scene::{Camera, Picture, Scene, SkyMode, Value, View};

/// The state that a control has led to, in a few words, e.g. `Doppler shift: off`. `before` and
/// `after` are the scene before and after the change. None for controls that change no scene.
#[must_use]
pub fn statement(control: &Control, before: &Scene, after: &Scene) -> Option<String> {
    let says = |what: &str, state: &str| Some(format!("{what}: {state}"));
    let switched = |what: &str, on: bool| says(what, if on { "on" } else { "off" });
    match control.id {
        "scene.sky" | "scene.sky_mode" => says("Sky", sky_word(after.sky.mode)),
        "scene.probe" if after.probe.enabled => {
            says("Probe", &format!("on, {}", probe_place(after)))
        }
        "scene.spin" => says("Spin", &spin_digits(after.hole.spin)),
        "scene.observer" => says("Observer", after.observer.kind.properties().motion),
        "picture.bloom" => switched("Bloom", after.picture.bloom > 0.0),
        "picture.brighter" | "picture.darker" | "picture.automatic_exposure" => {
            Some(exposure_in_words(after))
        }
        "picture.levels" if after.picture.levels >= super::edits::ALL_LEVELS => {
            says("Tones", "all")
        }
        "picture.levels" => says("Tones", &format!("{} a channel", after.picture.levels)),
        "picture.bypass" => switched("Pixel look", !after.picture.bypass),
        _ => match control.action {
            Action::Edit(_) if control.id.starts_with("view.") => {
                says("View", view_words(after.view))
            }
            Action::Edit(_) => says(
                &capitalised(control.description),
                &changed_value(before, after),
            ),
            // The scene's title says which preset it is.
            Action::Load(_) | Action::StepPreset(_) | Action::Do(_) | Action::Hold(_) => None,
        },
    }
}

/// The scene's exposure, and who chooses it.
#[must_use]
pub fn exposure_in_words(scene: &Scene) -> String {
    let Picture {
        exposure_ev,
        automatic_exposure,
        ..
    } = scene.picture;
    if automatic_exposure {
        format!("Exposure: automatic ({exposure_ev:+.1} EV)")
    } else {
        format!("Exposure: {exposure_ev:+.2} EV, by hand")
    }
}

/// The state of the first field that differs between two scenes: `on` or `off` for a switch.
fn changed_value(before: &Scene, after: &Scene) -> String {
    // The values of the scene that `differences` is asked for.
    let changed = after.differences(&metered_as(after, before));
    match changed.first() {
        Some((_, Value::Boolean(on))) => if *on { "on" } else { "off" }.into(),
        Some((_, value)) => with_short_numbers(&value.to_string().replace('"', "")),
        None => "as it was".into(),
    }
}

/// The scene with the other one's exposure, if the light meter chose both: it is no change.
fn metered_as(other: &Scene, scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    if scene.picture.automatic_exposure && other.picture.automatic_exposure {
        scene.picture.exposure_ev = other.picture.exposure_ev;
    }
    scene
}

/// What differs between two scenes, in a few words, e.g. `spin`, or `the flight` where only the
/// camera and how it moves differ.
#[must_use]
pub fn change_words(before: &Scene, after: &Scene) -> String {
    let keys: Vec<&str> = metered_as(after, before)
        .differences(after)
        .into_iter()
        .map(|(key, _)| key)
        .collect();
    let flown = |key: &&str| key.starts_with("camera.") || key.starts_with("observer.");
    match keys.as_slice() {
        [] => "nothing that shows".into(),
        _ if before.name != after.name => format!("preset {}", before.name),
        ["observer.kind"] => "observer".into(),
        ["picture.exposure_ev", "picture.automatic_exposure"] => "exposure".into(),
        keys if keys.iter().all(flown) => "the flight".into(),
        [key] => field_words(key),
        [key, others @ ..] => format!("{} and {} more", field_words(key), others.len()),
    }
}

/// A field in words.
fn field_words(key: &str) -> String {
    let (table, field) = key.rsplit_once('.').unwrap_or(("", key));
    match (table, field) {
        (_, "enabled" | "mode") => table.into(),
        (_, "follow_isco") => "disk from the innermost stable orbit".into(),
        (_, "bypass") => "pixel look".into(),
        (_, "levels") => "tones".into(),
        ("picture", "antialias") => "smooth edges".into(),
        (_, "samples") => "frames averaged".into(),
        (_, "edge_taper") => "soft edges of the disk".into(),
        (_, "exposure_ev" | "automatic_exposure") => "exposure".into(),
        ("disk", "limb") => "limb darkening".into(),
        ("disk", "structure") => "structure of the disk".into(),
        ("disk", "scale") => "width of the disk's filaments".into(),
        ("disk", "aspect") => "length of the disk's filaments".into(),
        ("disk", "pitch_deg") => "tilt of the disk's filaments".into(),
        ("disk", "lifetime") => "lifetime of the disk's filaments".into(),
        ("disk", "period") => "period of the disk's structure".into(),
        ("disk", "tilt_deg") => "tilt of the disk".into(),
        ("disk", "node_deg") => "azimuth of the disk's node".into(),
        ("disk", "time") => "disk's clock".into(),
        ("disk", "rate") => "rate of the disk's clock".into(),
        ("hot_spot", "kind") => "hot spot".into(),
        ("hot_spot", "r") => "radius of the hot spot".into(),
        ("hot_spot", "phi_deg") => "azimuth of the hot spot".into(),
        ("hot_spot", _) => format!("{} of the hot spot", field.replace('_', " ")),
        (_, "doppler") => "Doppler shift".into(),
        (_, "antialias") => "smooth edges of the probe".into(),
        ("disk" | "sky" | "probe", _) => format!("{} of the {table}", field.replace('_', " ")),
        _ => field.replace('_', " "),
    }
}

fn sky_word(sky: SkyMode) -> &'static str {
    match sky {
        SkyMode::Stars => "stars",
        SkyMode::Procedural => "the article's stars",
        SkyMode::Grid => "grid",
        SkyMode::Off => "off",
    }
}

/// What a view shows, in a few words.
fn view_words(view: View) -> &'static str {
    match view {
        View::Colour => "light",
        View::Unfinished => "light, unfinished rays in magenta",
        View::Classes => "ray classes",
        View::Residual => "residual of the null constraint",
        View::Order => "order of the image",
        View::Delay => "delay of the disk's light",
        View::Redshift => "redshift g",
        View::Steps => "heat map of steps",
        View::Error => "backward error",
    }
}

/// The text with a capital at its beginning.
fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    characters
        .next()
        .map(|first| first.to_uppercase().chain(characters).collect())
        .unwrap_or_default()
}

/// Where the probe is, as seen from the camera. The probe is drawn without lensing, so straight
/// lines of flat space decide.
fn probe_place(scene: &Scene) -> String {
    let (camera, probe) = (&scene.camera, &scene.probe);
    let place = Camera {
        r: probe.r,
        theta_deg: probe.theta_deg,
        phi_deg: probe.phi_deg,
        ..*camera
    };
    let way = place.r * place.direction() - camera.r * camera.direction();
    let axes = camera.tetrad() * camera.tetrad_from_camera();
    let looking = axes.transpose() * way;
    let [right, up, forward] = looking.to_array();
    let seen = camera.shows(looking, scene.picture.size().as_dvec2());
    let side = match (right.abs() > up.abs(), right > 0.0, up > 0.0) {
        _ if seen => "in view",
        _ if forward < 0.0 && -forward > right.abs().max(up.abs()) => "behind you",
        (true, true, _) => "to the right, out of view",
        (true, false, _) => "to the left, out of view",
        (false, _, true) => "above you, out of view",
        (false, _, false) => "below you, out of view",
    };
    if seen {
        side.into()
    } else {
        format!("{side}, at r {} r_s", four_digits(probe.r))
    }
}
