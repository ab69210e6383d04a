//! What a key says beside what it does: why nothing is to be seen of it, or what was passed over.

use crate::app::controls::bindings::Bindings;
use crate::app::controls::edits::{ALL_LEVELS, OBSERVERS};
use crate::app::controls::table::{Control, control_named};
use lightfall_core::geometry::kerr::Kerr;
use lightfall_core::optics::camera_rays::CameraRays;
use lightfall_core::optics::disk::inner_edge;
use lightfall_core::scene::{Content, ObserverKind, Scene, View};

/// A remark on the change that a control has made; none where the picture says it all. Keys are
/// named as they are bound. `metered` says whether the exposure follows the light.
#[must_use]
pub fn remark(
    control: &Control,
    before: &Scene,
    after: &Scene,
    bindings: &Bindings,
    metered: bool,
) -> Option<String> {
    let key = |id| bindings.named(id);
    match control.id {
        "scene.observer" => passed_over(before, after),
        "scene.spin" if before.method != after.method => {
            Some(format!("the method is {} now", after.method.word()))
        }
        "scene.isco" if !after.disk.enabled => {
            Some(format!("the disk is off; {} shows it", key("scene.disk")))
        }
        "scene.isco" if inner_edge(before) == inner_edge(after) => {
            Some("the disk begins at the innermost stable orbit either way".into())
        }
        "light.doppler" | "light.gravitational_shift" | "light.beaming"
            if hides_light(control, after.view) =>
        {
            let back = view_key(after.view).map(|id| format!("; {} goes back to it", key(id)));
            Some(format!(
                "this view shows no light{}",
                back.unwrap_or_default()
            ))
        }
        "light.doppler" if !after.disk.enabled && at_rest(after) => {
            Some("nothing that is seen moves".into())
        }
        "picture.brighter" | "picture.darker" if metered => Some(format!(
            "the exposure follows the light; {} leaves it to you",
            key("picture.automatic_exposure")
        )),
        "picture.antialias" if !after.probe.enabled => Some(format!(
            "there is no probe to smooth; {} puts it there",
            key("scene.probe")
        )),
        "picture.dither" | "picture.levels" if after.picture.bypass => Some(format!(
            "it shows in cells only; {} brings them back",
            key("picture.bypass")
        )),
        "picture.dither" if after.picture.levels == ALL_LEVELS => Some(format!(
            "with all tones there is little to dither; {} takes few",
            key("picture.levels")
        )),
        _ => None,
    }
}

/// The kinds of observer between two that cannot exist here, each with the reason.
fn passed_over(before: &Scene, after: &Scene) -> Option<String> {
    let place = |kind| {
        OBSERVERS
            .iter()
            .position(|other| *other == kind)
            .unwrap_or(0)
    };
    let (from, to) = (place(before.observer.kind), place(after.observer.kind));
    let steps = if from == to {
        OBSERVERS.len()
    } else {
        (to + OBSERVERS.len() - from) % OBSERVERS.len()
    };
    let horizon = Kerr {
        spin: after.hole.spin,
    }
    .horizon();
    if steps == OBSERVERS.len() && after.camera.r < horizon {
        return Some("inside the horizon everybody falls".into());
    }
    let reasons = (1..steps).filter_map(|step| {
        let mut other = before.clone();
        other.observer.kind = OBSERVERS[(from + step) % OBSERVERS.len()];
        CameraRays::new(&other)
            .err()
            .map(|reason| reason.to_string())
    });
    let reasons = reasons.collect::<Vec<_>>().join(". ");
    (!reasons.is_empty()).then(|| format!("passed over: {reasons}"))
}

/// Whether a view shows nothing of what this control does to light.
fn hides_light(control: &Control, view: View) -> bool {
    match view.properties().content {
        Content::Light => false,
        Content::Shift => control.id == "light.beaming",
        Content::Rays => true,
    }
}

/// The control that leaves a view for the light; that of errors has none.
fn view_key(view: View) -> Option<&'static str> {
    let id = format!("view.{}", view.word());
    control_named(&id).map(|control| control.id)
}

/// Whether the observer stands still where nothing is dragged along.
fn at_rest(scene: &Scene) -> bool {
    let kind = scene.observer.kind;
    let dragged = scene.hole.spin != 0.0 && kind != ObserverKind::Zamo;
    !kind.properties().falls_freely && !dragged && scene.observer.velocity == [0.0; 3]
}

/// Whether a scene's method gives every ray an answer.
pub(crate) fn leaves_none(scene: &Scene) -> bool {
    let method = scene.method.resolved(scene.hole.spin).properties();
    !scene.effects.lensing || method.answers_every_ray
}

/// Whether a scene's method solves rays instead of stepping them.
pub(crate) fn steps_none(scene: &Scene) -> bool {
    let method = scene.method.resolved(scene.hole.spin).properties();
    !scene.effects.lensing || !method.steps
}
