//! Lightfall: fly a camera around a black hole and see what light really does there.
//!
//! The program around [`lightfall_core`]. Each module may use those above it in this list:
//!
//! 1. [`worker`]: background threads.
//! 2. [`storage`]: files and folders, and scenes by name.
//! 3. [`render`]: the passes that turn a scene into pixels, in Bevy.
//! 4. [`picture`]: pictures and sequences without a window, and their files.
//! 5. [`app`]: the window.
//! 6. [`commands`]: the command line.
//!
//! docs/ARCHITECTURE.md shows how the parts work together.

pub mod app;
pub mod commands;
pub mod picture;
pub mod render;
pub mod storage;
pub mod worker;
