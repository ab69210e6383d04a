//! What fingers do on the picture in a frame. Fingers on the user interface are egui's.

use super::gestures::{Gesture, Gestures};
use super::pointer::is_on_picture;
use crate::app::state::overlays::Overlays;
use bevy::input::touch::TouchInput;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_egui::EguiContexts;
use glam::DVec2;

/// What fingers did on the picture in this frame.
#[derive(Resource, Default)]
pub(crate) struct Fingers {
    gestures: Gestures,
    /// Whether the screen was ever touched.
    pub(crate) seen: bool,
    /// Way of a finger that drags the picture, to the right and up, as a share of the window's
    /// height.
    pub(crate) drag: DVec2,
    /// Power of e by which two fingers were spread.
    pub(crate) spread: f64,
    /// Clockwise turn of two fingers, in radians.
    pub(crate) turn: f64,
    /// Where a finger has tapped, in logical pixels from the window's upper left corner.
    pub(crate) tap: Option<Vec2>,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<Fingers>()
        .add_systems(Update, read_fingers);
}

/// Reads the touches of this frame. A window that loses the focus may not be told of a finger's end.
pub(crate) fn read_fingers(
    mut touches: MessageReader<TouchInput>,
    mut contexts: EguiContexts,
    overlays: Res<Overlays>,
    window: Single<&Window, With<PrimaryWindow>>,
    mut fingers: ResMut<Fingers>,
) {
    let fingers = &mut *fingers;
    (fingers.drag, fingers.spread, fingers.turn) = (DVec2::ZERO, 0.0, 0.0);
    fingers.tap = None;
    if !window.focused {
        fingers.gestures.clear();
    }
    let Ok(context) = contexts.ctx_mut() else {
        return;
    };
    for touch in touches.read() {
        fingers.seen = true;
        let on_picture = is_on_picture(context, &overlays, touch.position);
        let gesture = fingers
            .gestures
            .follow(touch.id, touch.phase, touch.position, on_picture);
        match gesture {
            Some(Gesture::Drag(way)) => {
                let [right, down] = way.as_dvec2().to_array();
                fingers.drag += DVec2::new(right, -down) / f64::from(window.height());
            }
            Some(Gesture::Pinch { spread, turn }) => {
                fingers.spread += f64::from(spread);
                fingers.turn += f64::from(turn);
            }
            Some(Gesture::Tap(place)) => fingers.tap = Some(place),
            None => {}
        }
    }
}
