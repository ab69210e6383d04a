//! What a key says in addition to what it does: why nothing can be seen of it, or what it skipped.

use super::bindings::Bindings;
use super::control::Control;
use super::edits::ALL_LEVELS;
use super::refusal::no_observer;
use super::table::control_named;
use lightfall_core::numbers::four_digits;
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::scene::{Content, ObserverKind, Projection, Scene, View};

/// A remark on the change that a control has made. None where the picture shows the change. Keys
/// are named as they are bound.
#[must_use]
pub fn remark(
    control: &Control,
    before: &Scene,
    after: &Scene,
    bindings: &Bindings,
) -> Option<String> {
    let key = |id| bindings.first_label(id);
    let way_back = |does: &str| {
        let id = view_key(after.view);
        id.map_or(String::new(), |id| format!("; {} {does}", key(id)))
    };
    match control.id {
        "scene.observer" if after.hole.spin == 0.0 && after.observer.kind == ObserverKind::Zamo => {
            Some("without spin this is hovering at rest".into())
        }
        "scene.observer" => skipped_observers(before, after),
        "scene.spin" if before.method != after.method => {
            Some(format!("the method is now {}", after.method.word()))
        }
        "scene.spin" if after.hole.spin != 0.0 && after.disk.enabled && !after.disk.follow_isco => {
            Some(format!(
                "the disk still begins at {} r_s; {} moves it to the innermost stable orbit",
                four_digits(after.disk.inner),
                key("scene.isco")
            ))
        }
        "scene.isco" if !after.disk.enabled => {
            Some(format!("the disk is off; {} shows it", key("scene.disk")))
        }
        "scene.isco" if before.inner_edge() == after.inner_edge() => {
            Some("the disk begins at the innermost stable orbit in either case".into())
        }
        "light.doppler" | "light.gravitational_shift" | "light.beaming"
            if hides_light(control, after.view) =>
        {
            let back = way_back("shows it again");
            Some(format!("this view shows no light{back}"))
        }
        "light.doppler" if !after.disk.enabled && at_rest(after) => {
            Some("nothing in view moves".into())
        }
        "light.doppler" if !after.effects.doppler && after.effects.beaming => {
            Some("with it goes the beaming by motion".into())
        }
        "light.beaming"
            if !after.effects.beaming && after.effects.doppler && after.disk.enabled =>
        {
            Some(format!(
                "what approaches is still bluer and looks hotter, so it stays brighter; {} switches that off, too",
                key("light.doppler")
            ))
        }
        "picture.antialias" if !after.probe.enabled => Some(format!(
            "there is no probe to smooth; {} adds it",
            key("scene.probe")
        )),
        "picture.bypass" | "picture.dither" | "picture.levels"
            if after.camera.projection != Projection::Perspective =>
        {
            Some("only perspective pictures are shown in cells".into())
        }
        "picture.dither" | "picture.levels" if !after.view.shows_light() => {
            let back = way_back("shows light");
            Some(format!("a view keeps its exact colours{back}"))
        }
        "picture.dither" | "picture.levels" if after.picture.bypass => Some(format!(
            "this shows in the pixel look only; {} switches it on",
            key("picture.bypass")
        )),
        "picture.dither" if after.picture.levels == ALL_LEVELS => Some(format!(
            "with all tones there is little to dither; {} chooses few",
            key("picture.levels")
        )),
        _ => None,
    }
}

/// The kinds of observer that the key skipped because they cannot exist here, with the reasons.
fn skipped_observers(before: &Scene, after: &Scene) -> Option<String> {
    let (from, to) = (before.observer.kind, after.observer.kind);
    let horizon = after.kerr().horizon();
    if from == to && after.camera.r < horizon {
        return Some("inside the horizon every observer falls".into());
    }
    let mut other = before.clone();
    let mut reasons = Vec::new();
    loop {
        other.observer.kind = other.observer.kind.next();
        if other.observer.kind == to {
            break;
        }
        let refused = CameraRays::new(&other).err();
        reasons.extend(refused.map(|error| no_observer(&error, &other)));
    }
    let reasons = reasons.join("; ");
    (!reasons.is_empty()).then_some(reasons)
}

/// Whether a view hides what this control does to light.
fn hides_light(control: &Control, view: View) -> bool {
    match view.properties().content {
        Content::Light => false,
        Content::Shift => control.id == "light.beaming",
        Content::Rays => true,
        Content::Matter => !view.needs_light(),
    }
}

/// The control that leaves a view for the light.
fn view_key(view: View) -> Option<&'static str> {
    let id = format!("view.{}", view.word().replace('-', "_"));
    control_named(&id).map(|control| control.id)
}

/// Whether the observer has no motion of its own, so that the sky shows no Doppler shift.
fn at_rest(scene: &Scene) -> bool {
    let kind = scene.observer.kind;
    let dragged = scene.hole.spin != 0.0 && kind != ObserverKind::Zamo;
    !kind.properties().falls_freely && !dragged && scene.observer.velocity == [0.0; 3]
}
