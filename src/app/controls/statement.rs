//! What a control says after it has changed the scene: the new state.

use super::control::{Action, Control};
use super::edits::ALL_LEVELS;
use super::sections::field_in_words;
use lightfall_core::numbers::{four_digits, spin_digits};
use lightfall_core::scene::{Camera, Picture, Scene};

/// The state after a control was used, in a few words, such as `Doppler shift: off`. None for controls
/// that do not edit the scene. A control that loads a preset is one of these: the scene's title shows.
#[must_use]
pub fn statement(control: &Control, after: &Scene) -> Option<String> {
    let Action::Edit(edit) = control.action else {
        return None;
    };
    if let Some(says) = control.says {
        return Some(says(after));
    }
    Some(match edit.is_on(after) {
        Some(on) => switched(&capitalised(control.description), on),
        None => format!("View: {}", after.view.properties().words),
    })
}

fn switched(what: &str, on: bool) -> String {
    format!("{what}: {}", if on { "on" } else { "off" })
}

pub(super) fn sky(scene: &Scene) -> String {
    format!("Sky: {}", scene.sky.mode.choice().name.to_lowercase())
}

pub(super) fn probe(scene: &Scene) -> String {
    if scene.probe.enabled {
        format!("Probe: on, {}", probe_place(scene))
    } else {
        switched("Probe", false)
    }
}

pub(super) fn spin(scene: &Scene) -> String {
    format!("Spin: {}", spin_digits(scene.hole.spin))
}

pub(super) fn observer(scene: &Scene) -> String {
    format!("Observer: {}", scene.observer.kind.properties().motion)
}

pub(super) fn tones(scene: &Scene) -> String {
    match scene.picture.levels {
        ALL_LEVELS.. => "Tones: all".into(),
        levels => format!("Tones: {levels} a channel"),
    }
}

pub(super) fn pixel_look(scene: &Scene) -> String {
    switched("Pixel look", !scene.picture.bypass)
}

/// The scene's exposure, and whether it is automatic.
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

/// The scene with the other one's exposure if both are automatic, so that the exposure is not counted
/// as a change.
fn metered_as(other: &Scene, scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    if scene.picture.automatic_exposure && other.picture.automatic_exposure {
        scene.picture.exposure_ev = other.picture.exposure_ev;
    }
    scene
}

/// What differs between two scenes, in a few words, such as `spin`, or `the flight` if only the camera
/// and its motion differ.
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
        ["observer.kind"] => field_in_words("observer.kind"),
        ["picture.exposure_ev", "picture.automatic_exposure"] => "exposure".into(),
        keys if keys.iter().all(flown) => "the flight".into(),
        [key] => field_in_words(key),
        [key, others @ ..] => format!("{} and {} more", field_in_words(key), others.len()),
    }
}

/// The text with a capital first letter.
pub(crate) fn capitalised(text: &str) -> String {
    let mut characters = text.chars();
    characters
        .next()
        .map(|first| first.to_uppercase().chain(characters).collect())
        .unwrap_or_default()
}

/// The place of the probe as seen from the camera, along a straight line, because the probe is drawn
/// without lensing.
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
    if seen {
        return "in view".into();
    }
    let side = match (right.abs() > up.abs(), right > 0.0, up > 0.0) {
        _ if forward < 0.0 && -forward > right.abs().max(up.abs()) => "behind you",
        (true, true, _) => "to the right, out of view",
        (true, false, _) => "to the left, out of view",
        (false, _, true) => "above you, out of view",
        (false, _, false) => "below you, out of view",
    };
    format!("{side}, at r {} r_s", four_digits(probe.r))
}
