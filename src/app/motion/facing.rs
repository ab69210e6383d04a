//! Turning the camera to face the hole, its edge, or outward, with the disk's normal up.

use super::steering::is_inside;
use crate::app::controls::control::AppCommand;
use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use crate::app::state::toast::Toast;
use bevy::prelude::*;
use glam::{DMat3, DQuat, DVec3};
use lightfall_core::optics::apparent_hole::ApparentHole;
use lightfall_core::scene::Scene;
use lightfall_render::CurrentScene;
use std::f64::consts::PI;

/// Seconds that a turn takes.
const TURN_SECONDS: f64 = 0.6;
/// A camera that looks this near to where it would be turned, in radians, looks there: 3 degrees.
const FACES: f64 = 0.05;

/// What the camera turns to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The middle of the hole, where it appears to the camera.
    Hole,
    /// The edge of the hole above its middle. Inside the horizon the light of the sky is gathered
    /// there, while straight outward hardly any is left.
    Edge,
    /// The opposite direction, where the most of the sky is.
    Outward,
}

impl Aim {
    /// The aim that the key turns to after this one.
    fn next(self, scene: &Scene) -> Self {
        match self {
            Self::Hole if is_inside(scene) => Self::Edge,
            Self::Hole | Self::Edge => Self::Outward,
            Self::Outward => Self::Hole,
        }
    }

    /// What the window says of it.
    fn words(self) -> &'static str {
        match self {
            Self::Hole => "Facing the hole",
            Self::Edge => "Facing the hole's edge, where the light of the sky is",
            Self::Outward => "Facing outward",
        }
    }
}

/// The turn under way, if there is one.
#[derive(Resource, Default)]
pub(crate) struct Facing {
    turn: Option<Turn>,
    left: LeftAngles,
}

/// Yaw, pitch and roll as a system left them, by which it notices that something else has turned the
/// camera.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LeftAngles(Option<[f64; 3]>);

impl LeftAngles {
    /// Notes how the camera looks.
    pub(crate) fn note(&mut self, scene: &Scene) {
        self.0 = Some(scene.camera.angles());
    }

    /// Whether the camera looks as it was left.
    pub(crate) fn are_those_of(&self, scene: &Scene) -> bool {
        self.0 == Some(scene.camera.angles())
    }

    /// Whether anything was noted, and the camera looks elsewhere.
    pub(crate) fn were_changed(&self, scene: &Scene) -> bool {
        self.0.is_some() && !self.are_those_of(scene)
    }

    /// Follows a fall, which carries the camera along and turns it on the axes of its new place.
    pub(crate) fn carry(&mut self, before: &Scene, after: &Scene) {
        if self.are_those_of(before) {
            self.note(after);
        }
    }
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
            from: scene.camera.heading(),
            seconds: 0.0,
        });
        self.left.note(scene);
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
        self.left.are_those_of(scene)
    }

    /// Follows a fall. See [`LeftAngles::carry`].
    pub(crate) fn carry(&mut self, before: &Scene, after: &Scene) {
        self.left.carry(before, after);
    }
}

/// The axes right, up, forward of a camera with this aim, on the observer's axes. Up is as near to
/// decreasing theta as the aim allows, so that the disk lies level; over the pole nothing jumps.
/// None if the scene's observer does not exist.
#[must_use]
pub fn aimed(scene: &Scene, aim: Aim) -> Option<DMat3> {
    let hole = ApparentHole::new(scene).ok()?;
    let forward = match aim {
        Aim::Hole | Aim::Edge => hole.direction,
        Aim::Outward => -hole.direction,
    };
    let up = (-DVec3::Y).reject_from_normalized(forward).try_normalize();
    let up = up.unwrap_or_else(|| forward.any_orthonormal_vector());
    let level = DMat3::from_cols(forward.cross(up), up, forward);
    // Right, up, forward is a left-handed triple, so glam's positive turn leads downward.
    let rise = if aim == Aim::Edge { hole.radius } else { 0.0 };
    Some(level * DMat3::from_rotation_x(-rise))
}

/// The aim of the key that faces the hole and, pressed again, outward. Inside the horizon the edge of
/// the hole comes first.
#[must_use]
pub fn next_aim(scene: &Scene) -> Aim {
    let first = if is_inside(scene) {
        Aim::Edge
    } else {
        Aim::Hole
    };
    let Ok(hole) = ApparentHole::new(scene) else {
        return first;
    };
    let forward = scene.camera.heading().z_axis;
    let angle = hole.direction.angle_between(forward);
    let aims = [
        (Aim::Hole, 0.0),
        (Aim::Edge, hole.radius),
        (Aim::Outward, PI),
    ];
    aims.into_iter()
        .filter(|(aim, _)| *aim != Aim::Edge || is_inside(scene))
        .find(|(_, aimed)| (angle - aimed).abs() < FACES)
        .map_or(first, |(aim, _)| aim.next(scene))
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
        let aim = match &facing.turn {
            Some(turn) => turn.aim.next(&scene),
            None => next_aim(&scene),
        };
        facing.start(aim, &scene);
        toast.say(aim.words());
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
    facing.left.note(&editor.scene());
}
