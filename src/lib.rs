//! Lightfall: fly a camera around a black hole and see what light really does there.
//!
//! The program around [`lightfall_core`]. Each module may use those above it in this list:
//!
//! 1. [`storage`]: files and folders, and scenes by name.
//! 2. [`render`]: the passes that turn a scene into pixels, in Bevy.
//! 3. [`picture`]: pictures and sequences without a window, and their files.
//! 4. [`app`]: the window.
//! 5. [`commands`]: the command line.
//!
//! docs/ARCHITECTURE.md shows how the parts work together.

pub mod app;
pub mod commands;
pub mod picture;
pub mod render;
pub mod storage;
