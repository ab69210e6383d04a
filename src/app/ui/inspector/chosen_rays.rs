//! Which rays the inspector traces: that of a clicked pixel or of a lesson's stop.

use super::Inspector;
use super::ray_worker::InspectedRays;
use crate::app::input::pointer::PointerOverPicture;
use crate::app::input::touch::Fingers;
use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::lessons::{AskedRay, ShownRay};
use crate::app::state::overlays::Overlays;
use crate::app::ui::picture_in_window::{PictureInWindow, SceneSide};
use bevy::prelude::*;
use glam::{DVec2, DVec3};
use lightfall_core::scene::Scene;
use lightfall_core::scene::journey::InspectorView;

/// Inspects the pixel that is clicked or tapped.
pub(super) fn inspect_chosen_pixel(
    buttons: Res<ButtonInput<MouseButton>>,
    (over, fingers): (Res<PointerOverPicture>, Res<Fingers>),
    overlays: Res<Overlays>,
    picture: PictureInWindow,
    mut inspector: ResMut<Inspector>,
) {
    if !overlays.shows_inspector() {
        return;
    }
    let clicked = over.0 && buttons.just_pressed(MouseButton::Left);
    let pixel = match fingers.tap {
        Some(tap) => picture.pixel_at(tap),
        None if clicked => picture.pixel_of_mouse(),
        None => None,
    };
    if let Some((side, pixel)) = pixel
        && let Some(scene) = picture.scene_of(side)
        // Outside a fisheye picture's circle there is no ray.
        && scene.camera.coverage(pixel, scene.picture.size().as_dvec2()) > 0.0
    {
        inspector.followed = None;
        inspector.side = side;
        inspector.asked = Some((scene.clone(), pixel));
        inspector.ask();
    }
}

/// Inspects the ray that a lesson's stop asks for, and again whenever the picture has changed.
pub(super) fn inspect_ray_of_stop(
    asked: Res<AskedRay>,
    (overlays, pacing): (Res<Overlays>, Res<FramePacing>),
    picture: PictureInWindow,
    mut inspector: ResMut<Inspector>,
) {
    if asked.is_changed() {
        (inspector.followed, inspector.asked) = (asked.0, None);
    }
    let Some(view) = inspector.followed else {
        return;
    };
    let scene = picture.scene();
    let is_asked = |(asked, _): &(Scene, DVec2)| asked.without_clock() == scene.without_clock();
    if !overlays.shows_inspector()
        || pacing.moving
        || inspector.asked.as_ref().is_some_and(is_asked)
    {
        return;
    }
    let size = scene.picture.size().as_dvec2();
    let pixel = match view {
        InspectorView::Closed | InspectorView::Open => None,
        InspectorView::Place(share) => Some(DVec2::from(share) * size),
        InspectorView::Toward(direction) => {
            let from_camera = scene.camera.tetrad_from_camera();
            let looking = from_camera.transpose() * DVec3::from(direction).normalize();
            scene.camera.pixel_of(looking, size)
        }
    };
    if let Some(pixel) = pixel {
        inspector.side = SceneSide::Current;
        inspector.asked = Some((scene.clone(), pixel));
        inspector.ask();
    }
}

/// Notes the direction of the ray that is shown of the present picture.
pub(super) fn note_shown_ray(
    inspector: Res<Inspector>,
    picture: PictureInWindow,
    mut shown: ResMut<ShownRay>,
) {
    let is_current = |answer: &&InspectedRays| {
        inspector.side == SceneSide::Current
            && answer.scene.without_clock() == picture.scene().without_clock()
    };
    let answer = inspector.answer.as_ref().filter(is_current);
    let numbers = answer.and_then(|answer| Some(&answer.rays.first()?.numbers));
    shown.0 = numbers.map(|numbers| [numbers.er, numbers.etheta, numbers.ephi]);
}
