//! The pixel look as a preference: the picture shows large cells or not, whichever scene is loaded.
//! The scene's field `picture.bypass` holds what is shown. A key, the panel and undo change that
//! field, and the setting follows; a change of the setting changes the field.

use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;

/// The pixel look in the settings and in the picture.
#[derive(Clone, Copy, PartialEq, Eq)]
struct PixelLook {
    setting: bool,
    shown: bool,
}

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, keep_pixel_look);
}

/// Makes the setting and the picture agree after either has changed. A picture whose look was
/// chosen on the command line differs from the setting until one of them changes.
fn keep_pixel_look(
    mut editor: SceneEditor,
    mut preferences: ResMut<Preferences>,
    mut last: Local<Option<PixelLook>>,
) {
    let settings = &mut preferences.settings;
    let mut now = PixelLook {
        setting: settings.pixel_look,
        shown: editor.shows_cells(),
    };
    if let Some(last) = *last {
        if now.shown != last.shown {
            settings.pixel_look = now.shown;
        } else if now.setting != last.setting {
            let mut scene = editor.scene();
            scene.picture.bypass = !now.setting;
            editor.change("Pixel look", scene);
        }
        now = PixelLook {
            setting: settings.pixel_look,
            shown: editor.shows_cells(),
        };
    }
    *last = Some(now);
}
