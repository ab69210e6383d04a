//! The file dialog of the desktop or of the browser.

#[cfg(target_arch = "wasm32")]
mod browser;
#[cfg(not(target_arch = "wasm32"))]
mod desktop;
mod picked;

#[cfg(target_arch = "wasm32")]
pub(super) use browser::FileDialog;
#[cfg(not(target_arch = "wasm32"))]
pub(super) use desktop::FileDialog;
pub(super) use picked::Picked;
