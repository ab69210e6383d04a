//! Automatic exposure during flights: it follows the light meter smoothly. Every other change of the
//! scene is metered at once ([`SceneEditor`](crate::app::state::scene_editor::SceneEditor)), so that
//! no switch leaves the picture black or white.

use crate::app::state::light_meter::LightMeter;
use crate::app::state::preferences::Preferences;
use crate::app::state::resolution::Resolution;
use bevy::prelude::*;
use lightfall_core::scene::Scene;
use lightfall_render::CurrentScene;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, follow_light);
}

fn follow_light(
    time: Res<Time>,
    preferences: Res<Preferences>,
    resolution: Res<Resolution>,
    scene: Res<CurrentScene>,
    mut meter: ResMut<LightMeter>,
) {
    if !scene.picture.automatic_exposure || preferences.settings.reduced_motion {
        meter.forget();
        return;
    }
    // Not at the resolution that is drawn: a coarser picture is metered a little differently.
    let metered = Scene {
        picture: resolution.in_window(&scene.shown_picture()),
        ..scene.scene().clone()
    };
    meter.follow(&metered, time.delta_secs_f64());
}
