//! Screenshots: the picture by itself, or what the window shows.

#[cfg(target_arch = "wasm32")]
mod downloads;
#[cfg(not(target_arch = "wasm32"))]
mod files;
mod pixels;

#[cfg(target_arch = "wasm32")]
pub(crate) use downloads::plugin;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use files::plugin;
