//! What leads others to a scene: in a browser the page's address, elsewhere a command line.

#[cfg(target_arch = "wasm32")]
mod address;
#[cfg(not(target_arch = "wasm32"))]
mod command_line;

#[cfg(target_arch = "wasm32")]
pub(crate) use address::{copy_link, plugin};
#[cfg(not(target_arch = "wasm32"))]
pub use command_line::command_line;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use command_line::{copy_link, plugin};
