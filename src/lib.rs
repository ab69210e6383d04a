//! Lightfall: fly a camera around a black hole and see what light really does there.
//!
//! The program around [`lightfall_core`]. It stands on the crates `lightfall-platform` (files, the
//! browser, background threads, the log), `lightfall-render` (the passes that turn a scene into
//! pixels, in Bevy) and `lightfall-picture` (pictures and sequences without a window, and their
//! files). Each of its own modules may use those above it in this list:
//!
//! 1. [`app`]: the window.
//! 2. [`commands`]: the command line.
//!
//! In a browser there are no pictures and no `commands`; `page` starts the window with the scene
//! that the page's address describes.
//!
//! docs/ARCHITECTURE.md shows how the parts work together.

pub mod app;
#[cfg(not(target_arch = "wasm32"))]
pub mod commands;
#[cfg(target_arch = "wasm32")]
pub mod page;
