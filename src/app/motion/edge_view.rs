//! Keeps the edge of the shadow in view during a fall. The shadow grows until it fills any view
//! straight ahead, and the sky that is left lies at its edge.

use super::facing::{Facing, LeftAngles};
use super::free_fall::{FreeFall, advance_free_fall};
use crate::app::controls::control::AppCommand;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;
use glam::{DMat3, DQuat, DVec3};
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::scene::Scene;

/// Where the edge of a shadow that just outgrows the picture crosses it: this share of the way from
/// the middle to the picture's edge.
const FIRST_EDGE: f64 = 0.6;
/// Maximum speed at which the camera is turned, in radians per second.
const MAX_TURN_RATE: f64 = 0.5;
/// A camera that looks nearer than this to the hole's middle, in radians, is turned upward. Any other
/// is turned straight away from the middle.
const FACES_HOLE: f64 = 0.2;

/// How far from the hole's middle a camera has to look so that the edge of the shadow is in its
/// picture, in radians, or a negative number. `radius` is the shadow's angular radius, `half_height`
/// the angle from the middle of the picture to its upper edge. The edge comes nearer to the middle of
/// the picture as the shadow outgrows it, so that the shadow never fills much more than half of it.
#[must_use]
pub fn edge_distance(radius: f64, half_height: f64) -> f64 {
    let first = FIRST_EDGE * half_height;
    radius - first * first / radius.max(first)
}

/// The camera's axes on the observer's axes, turned by at most `max_turn` radians so that the edge of
/// the shadow is in the picture. A camera that looks farther away from the hole is turned back only
/// if it `was_turned` away before. None where there is nothing to turn, or where the observer does
/// not exist.
#[must_use]
pub fn edge_in_view(scene: &Scene, was_turned: bool, max_turn: f64) -> Option<DMat3> {
    let hole = ApparentHole::new(scene).ok()?;
    let axes = scene.camera.heading();
    let (up, forward) = (axes.y_axis, axes.z_axis);
    let distance = hole.direction.angle_between(forward);
    let half_height = scene.camera.half_angles(scene.picture.size().as_dvec2()).y;
    let faces_hole = distance < FACES_HOLE;
    let missing = edge_distance(hole.radius, half_height).max(0.0) - distance;
    let turn = missing.clamp(-max_turn, max_turn);
    if turn == 0.0 || turn < 0.0 && (faces_hole || !was_turned) {
        return None;
    }
    let away = if faces_hole { up } else { -hole.direction };
    let axis = forward.cross(away).try_normalize().unwrap_or(DVec3::Z);
    Some(DMat3::from_quat(DQuat::from_axis_angle(axis, turn)) * axes)
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<EdgeView>()
        .add_systems(Update, keep_edge_in_view.after(advance_free_fall));
}

/// Whether the fall or the user orients the camera.
#[derive(Resource, Default)]
pub(crate) struct EdgeView {
    /// Other angles were set by hand.
    left: LeftAngles,
    /// Whether the fall has turned the camera.
    was_turned: bool,
    /// Whether the camera was turned by hand, and stays as it is until the next fall.
    released: bool,
}

impl EdgeView {
    /// Follows a fall. See [`LeftAngles::carry`].
    pub(crate) fn carry(&mut self, before: &Scene, after: &Scene) {
        self.left.carry(before, after);
    }
}

/// Turns a falling camera for one frame.
fn keep_edge_in_view(
    time: Res<Time>,
    free_fall: Res<FreeFall>,
    facing: Res<Facing>,
    mut commands: MessageReader<AppCommand>,
    mut editor: SceneEditor,
    mut view: ResMut<EdgeView>,
) {
    let faces = AppCommand::Face.count(&mut commands) > 0;
    if !free_fall.is_fall() {
        *view = EdgeView::default();
        return;
    }
    let scene = editor.drawn_scene();
    view.released |= faces || view.left.were_changed(&scene) && !facing.has_left(&scene);
    view.left.note(&scene);
    if view.released || facing.is_turning() || !editor.has_changed() {
        return;
    }
    let max_turn = MAX_TURN_RATE * time.delta_secs_f64();
    let Some(axes) = edge_in_view(&scene, view.was_turned, max_turn) else {
        return;
    };
    editor.turn(axes);
    view.was_turned = true;
    view.left.note(&editor.scene());
}
