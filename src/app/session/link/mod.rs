//! Sharing a scene: by the page's address in a browser, elsewhere by a command line.

#[cfg(target_arch = "wasm32")]
mod address;
#[cfg(not(target_arch = "wasm32"))]
mod command_line;

#[cfg(target_arch = "wasm32")]
pub(crate) use address::{copy_link, plugin};
#[cfg(not(target_arch = "wasm32"))]
pub use command_line::command_line;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use command_line::copy_link;
