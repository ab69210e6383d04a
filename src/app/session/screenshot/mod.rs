//! Screenshots: the picture by itself, or what the window shows.

#[cfg(target_arch = "wasm32")]
mod downloads;
#[cfg(not(target_arch = "wasm32"))]
mod files;
mod pixels;
mod sharpness;

#[cfg(target_arch = "wasm32")]
use downloads as writer;
#[cfg(not(target_arch = "wasm32"))]
use files as writer;

pub(crate) fn plugin(app: &mut bevy::app::App) {
    app.add_plugins((sharpness::plugin, writer::plugin));
}
