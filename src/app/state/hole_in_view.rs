//! Where the hole is on the screen, and how much of the picture it darkens: computed once for every
//! scene, for the arrow and the sentence that keep a player from getting lost.

use bevy::prelude::*;
use glam::DVec3;
use lightfall_core::optics::apparent_hole::{ApparentHole, dark_share};
use lightfall_core::scene::Scene;
use lightfall_render::{ComparedScene, DrawnScene};

/// The share of the picture, from 0 to 1, that has to be dark for the hole to fill the view.
const FILLS_VIEW: f64 = 0.94;

/// The hole in the picture. None where the scene's observer does not exist.
#[derive(Resource, Default)]
pub(crate) struct HoleInView(pub(crate) Option<SeenHole>);

/// What the camera sees of the hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SeenHole {
    /// Unit vector toward its middle on the camera's axes (right, up, forward).
    pub(crate) direction: DVec3,
    /// Angular radius of the black disc, in radians.
    pub(crate) radius: f64,
    /// Whether any part of the black disc is in the picture.
    pub(crate) in_picture: bool,
    /// Whether (nearly) all of the picture is dark because of the hole.
    pub(crate) fills_view: bool,
}

impl SeenHole {
    fn new(scene: &Scene) -> Option<Self> {
        let hole = ApparentHole::new(scene).ok()?;
        let in_picture = hole.is_in_picture(scene);
        let half_height = scene.camera.half_angles(scene.picture.size().as_dvec2()).y;
        // A hole smaller than the picture's height cannot darken all of it, and needs no rays.
        let fills_view = in_picture
            && hole.radius > half_height
            && dark_share(scene).is_ok_and(|share| share > FILLS_VIEW);
        Some(Self {
            direction: hole.from_camera(scene),
            radius: hole.radius,
            in_picture,
            fills_view,
        })
    }
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<HoleInView>().add_systems(
        PostUpdate,
        find_hole
            .run_if(resource_changed::<DrawnScene>.or_eager(resource_changed::<ComparedScene>)),
    );
}

/// Only where rays have changed: the light of a disk that moves changes in every frame.
fn find_hole(
    (scene, compared): (Res<DrawnScene>, Res<ComparedScene>),
    mut hole: ResMut<HoleInView>,
    mut found_for: Local<Option<Scene>>,
) {
    let scene = compared.drawn_current(&scene);
    let rays = scene.without_shading();
    if found_for.as_ref() != Some(&rays) {
        hole.0 = SeenHole::new(scene);
        *found_for = Some(rays);
    }
}
