//! The file dialog of the desktop or of the browser.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;
mod dialog;
mod picked;

pub(super) use dialog::FileDialog;
pub(super) use picked::Picked;
