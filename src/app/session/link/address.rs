//! The page's address with a scene. It follows the scene, so that a bookmark or a reload leads back
//! to it.

use crate::app::session::clipboard::Clipboard;
use crate::app::session::frame_pacing::FramePacing;
use crate::app::state::scene_editor::SceneEditor;
use bevy::prelude::*;
use lightfall_core::scene::{Changes, Scene};
use lightfall_platform::browser;

pub(crate) fn plugin(app: &mut App) {
    app.add_systems(PostUpdate, show_address);
}

/// Copies the address, and says so or why not.
pub(crate) fn copy_link(scene: &Scene, clipboard: &Clipboard) -> String {
    match address(scene) {
        Ok(address) => {
            clipboard.copy(address);
            "Copied the address of this page with this scene".into()
        }
        Err(reason) => format!("Nothing is copied: {reason}"),
    }
}

/// The page's address with this scene.
///
/// # Errors
/// The browser's reason.
fn address(scene: &Scene) -> Result<String, String> {
    let Changes { preset, fields } = Changes::of(scene);
    let preset = ("preset".to_owned(), preset.name.to_owned());
    let fields = fields
        .into_iter()
        .map(|(key, value)| (key.to_owned(), value.to_string()));
    browser::address_with(&[preset].into_iter().chain(fields).collect::<Vec<_>>())
}

/// Shows the scene in the address once it has come to rest. Browsers allow few changes of the address
/// in a short time.
fn show_address(
    pacing: Res<FramePacing>,
    editor: SceneEditor,
    mut is_late: Local<bool>,
    mut shown: Local<Option<Scene>>,
) {
    *is_late |= editor.has_changed();
    if pacing.moving || !*is_late {
        return;
    }
    *is_late = false;
    let scene = editor.scene();
    // A disk whose clock runs would change the address in every frame.
    if shown.as_ref().map(Scene::without_clock) != Some(scene.without_clock()) {
        if let Err(reason) = address(&scene).and_then(|address| browser::replace_address(&address))
        {
            warn!("the address cannot be changed: {reason}");
        }
        *shown = Some(scene);
    }
}
