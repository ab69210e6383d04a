//! The scenes whose picture is on the screen. A scene that needs a new shader is drawn only once the
//! shader is compiled, and until then no legend and no label may speak of it.

use bevy::prelude::*;
use lightfall_core::scene::Scene;
use lightfall_render::{ComparedScene, DrawnScene, Progress};

/// What the picture on the screen shows.
#[derive(Resource, Default)]
pub(crate) struct ShownPicture {
    pub(crate) scene: Scene,
    /// The pinned scene of a comparison.
    pub(crate) pinned: Option<Scene>,
}

pub(crate) fn plugin(app: &mut App) {
    app.init_resource::<ShownPicture>()
        .add_systems(PreUpdate, note_shown_picture);
}

/// Before the renderer has started there are no shaders, and no picture.
fn note_shown_picture(
    scene: Res<DrawnScene>,
    compared: Res<ComparedScene>,
    progress: Res<Progress>,
    mut shown: ResMut<ShownPicture>,
) {
    if *progress == Progress::Compiling {
        return;
    }
    let pinned = compared.drawn().map(|(pinned, _)| pinned.scene());
    if shown.scene != *scene.scene() || shown.pinned.as_ref() != pinned {
        *shown = ShownPicture {
            scene: scene.scene().clone(),
            pinned: pinned.cloned(),
        };
    }
}
