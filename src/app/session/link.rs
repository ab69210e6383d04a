//! What leads others to a scene: in a browser the page's address, elsewhere a command line. In a
//! browser the address also follows the scene, so that a bookmark or a reload leads back to it.

#[cfg(target_arch = "wasm32")]
use crate::app::session::frame_pacing::FramePacing;
#[cfg(target_arch = "wasm32")]
use crate::app::state::resolution::Resolution;
#[cfg(target_arch = "wasm32")]
use crate::render::CurrentScene;
use bevy::prelude::*;
use lightfall_core::scene::{Changes, Scene};

#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn plugin(_: &mut App) {}

/// The command line that opens this scene.
///
/// # Errors
/// None.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn link(scene: &Scene) -> Result<String, String> {
    let Changes { preset, fields } = Changes::of(scene);
    let sets = fields.iter().map(|(key, value)| {
        let set = format!("{key}={value}");
        // Quoted for shells, whose quotes end at an apostrophe.
        format!(" --set '{}'", set.replace('\'', r"'\''"))
    });
    Ok(format!(
        "lightfall --preset {}{}",
        preset.name,
        sets.collect::<String>()
    ))
}

#[cfg(target_arch = "wasm32")]
pub(crate) fn plugin(app: &mut App) {
    app.add_systems(PostUpdate, show_address);
}

/// The page's address with this scene.
///
/// # Errors
/// The browser's reason.
#[cfg(target_arch = "wasm32")]
pub(crate) fn link(scene: &Scene) -> Result<String, String> {
    let Changes { preset, fields } = Changes::of(scene);
    let mut parameters = vec![("preset".to_owned(), preset.name.to_owned())];
    parameters.extend(
        fields
            .iter()
            .map(|(key, value)| ((*key).to_owned(), value.to_string())),
    );
    crate::browser::address_with(&parameters)
}

/// Follows the scene once it has come to rest. Browsers allow a few changes of the address a second.
#[cfg(target_arch = "wasm32")]
fn show_address(
    pacing: Res<FramePacing>,
    scene: Res<CurrentScene>,
    resolution: Res<Resolution>,
    mut shown: Local<Option<Scene>>,
) {
    if pacing.moving || !scene.is_changed() && shown.is_some() {
        return;
    }
    let scene = resolution.full_scene(&scene);
    if shown.as_ref() != Some(&scene) {
        if let Err(reason) = link(&scene).and_then(|link| crate::browser::replace_address(&link)) {
            warn!("the address cannot be changed: {reason}");
        }
        *shown = Some(scene);
    }
}
