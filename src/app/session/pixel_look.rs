//! The pixel look as a preference: the picture shows large cells or not, whichever scene is loaded.
//! The scene's field `picture.bypass` holds what is shown. A key, the panel and undo change that
//! field, and the setting follows; a change of the setting changes the field.

use crate::app::state::preferences::Preferences;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(Update, keep_pixel_look);
}

/// Makes the setting and the picture agree after either has changed. A picture whose look was
/// chosen on the command line differs from the setting until one of them changes. `last` is what
/// the setting said and what was shown.
fn keep_pixel_look(
    mut editor: SceneEditor,
    mut preferences: ResMut<Preferences>,
    mut last: Local<Option<[bool; 2]>>,
) {
    let [setting, shown] = [preferences.settings.pixel_look, editor.has_pixel_look()];
    if last.is_some_and(|[_, last]| last != shown) {
        preferences.settings.pixel_look = shown;
    } else if last.is_some_and(|[last, _]| last != setting) {
        let mut scene = editor.scene();
        scene.picture.bypass = !setting;
        editor.change("Pixel look", scene);
    }
    *last = Some([preferences.settings.pixel_look, editor.has_pixel_look()]);
}
