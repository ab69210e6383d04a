//! Lightfall: fly a camera around a black hole and see what light really does there.
//!
//! The program around [`lightfall_core`]. Each module may use those above it in this list:
//!
//! 1. [`worker`]: background threads.
//! 2. `browser`: what the program asks of a browser, where it runs in one.
//! 3. [`storage`]: files and folders, and scenes by name.
//! 4. [`log`]: what is logged.
//! 5. [`render`]: the passes that turn a scene into pixels, in Bevy.
//! 6. [`picture`]: pictures and sequences without a window, and their files.
//! 7. [`app`]: the window.
//! 8. [`commands`]: the command line.
//!
//! In a browser there are no `picture` and `commands`; `page` starts the window with the scene that the
//! page's address describes.
//!
//! docs/ARCHITECTURE.md shows how the parts work together.

/// Whether the program runs in a browser.
pub const IN_BROWSER: bool = cfg!(target_arch = "wasm32");

pub mod app;
#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(not(target_arch = "wasm32"))]
pub mod commands;
pub mod log;
#[cfg(target_arch = "wasm32")]
pub mod page;
#[cfg(not(target_arch = "wasm32"))]
pub mod picture;
pub mod render;
pub mod storage;
pub mod worker;
