//! Turning the camera to face the hole, or outward, with the disk's normal up.

use crate::app::controls::control::AppCommand;
use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use glam::{DMat3, DQuat, DVec3};
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::scene::Scene;
use lightfall_render::CurrentScene;

/// Seconds that a turn takes.
const TURN_SECONDS: f64 = 0.6;
/// A camera that looks this near to the hole's middle faces the hole, as a cosine: 3 degrees.
const FACES_HOLE: f64 = 0.9986;

/// What the camera turns to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The middle of the hole, where it appears to the camera.
    Hole,
    /// The opposite direction, where the most of the sky is.
    Outward,
}

/// The turn under way, if there is one.
#[derive(Resource, Default)]
pub(crate) struct Facing {
    turn: Option<Turn>,
    /// Yaw, pitch and roll as the last turn left them.
    left_at: Option<[f64; 3]>,
}

struct Turn {
    aim: Aim,
    /// The camera's axes on the observer's axes at the start.
    from: DMat3,
    seconds: f64,
}

impl Facing {
    /// Begins to turn the scene's camera.
    pub(crate) fn start(&mut self, aim: Aim, scene: &Scene) {
        self.turn = Some(Turn {
            aim,
            from: scene.camera.tetrad_from_camera(),
            seconds: 0.0,
        });
        self.left_at = Some(scene.camera.angles());
    }

    /// Leaves the camera as it is.
    pub(crate) fn stop(&mut self) {
        self.turn = None;
    }

    /// Whether the camera is being turned.
    pub(crate) fn is_turning(&self) -> bool {
        self.turn.is_some()
    }

    /// Whether the camera looks where the last turn left it. Any other angles were set by something
    /// else, which ends the turn.
    pub(crate) fn has_left(&self, scene: &Scene) -> bool {
        self.left_at == Some(scene.camera.angles())
    }
}

/// The axes right, up, forward of a camera with this aim, on the observer's axes. Up is as near to
/// decreasing theta as the aim allows, so that the disk lies level; over the pole nothing jumps.
/// None if the scene's observer does not exist.
#[must_use]
pub fn aimed(scene: &Scene, aim: Aim) -> Option<DMat3> {
    let hole = ApparentHole::new(scene).ok()?.direction;
    let forward = match aim {
        Aim::Hole => hole,
        Aim::Outward => -hole,
    };
    let up = (-DVec3::Y).reject_from_normalized(forward).try_normalize();
    let up = up.unwrap_or_else(|| forward.any_orthonormal_vector());
    Some(DMat3::from_cols(forward.cross(up), up, forward))
}

/// The aim of the key that faces the hole and, pressed again, outward.
#[must_use]
pub fn next_aim(scene: &Scene) -> Aim {
    let forward = scene.camera.tetrad_from_camera().z_axis;
    let faces = ApparentHole::new(scene).is_ok_and(|hole| hole.direction.dot(forward) > FACES_HOLE);
    if faces { Aim::Outward } else { Aim::Hole }
}

/// The axes a `share` of the way from one orientation to another, gently at both ends.
#[must_use]
pub fn between_axes(from: DMat3, to: DMat3, share: f64) -> DMat3 {
    let share = share.clamp(0.0, 1.0);
    let eased = share * share * (3.0 - 2.0 * share);
    let rotation = DQuat::from_mat3(&(to * from.transpose()));
    DMat3::from_quat(DQuat::IDENTITY.slerp(rotation, eased)) * from
}

/// Starts a turn when its key is pressed.
pub(crate) fn start_facing(
    mut commands: MessageReader<AppCommand>,
    scene: Res<CurrentScene>,
    mut facing: ResMut<Facing>,
    mut toast: ResMut<Toast>,
) {
    for _ in 0..AppCommand::Face.count(&mut commands) {
        let aim = match facing.turn.as_ref().map(|turn| turn.aim) {
            Some(Aim::Hole) => Aim::Outward,
            Some(Aim::Outward) => Aim::Hole,
            None => next_aim(&scene),
        };
        facing.start(aim, &scene);
        toast.say(match aim {
            Aim::Hole => "Facing the hole",
            Aim::Outward => "Facing outward",
        });
    }
}

/// Turns the camera for one frame. With reduced motion it turns at once.
pub(crate) fn turn_camera(
    time: Res<Time>,
    preferences: Res<Preferences>,
    mut facing: ResMut<Facing>,
    mut editor: SceneEditor,
) {
    if !facing.is_turning() {
        return;
    }
    let scene = editor.scene();
    let is_left = facing.has_left(&scene);
    let Some(turn) = &mut facing.turn else {
        return;
    };
    let aimed = aimed(&scene, turn.aim);
    let (Some(to), true) = (aimed, is_left) else {
        facing.turn = None;
        return;
    };
    turn.seconds += time.delta_secs_f64();
    let share = if preferences.settings.reduced_motion {
        1.0
    } else {
        turn.seconds / TURN_SECONDS
    };
    editor.turn(between_axes(turn.from, to, share));
    if share >= 1.0 {
        facing.turn = None;
    }
    facing.left_at = Some(editor.scene().camera.angles());
}
