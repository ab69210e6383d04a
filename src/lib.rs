//! Lightfall: fly a camera around a black hole and see what light really does there.
//!
//! One direction of data: [`scene`] (what is drawn) -> [`gpu`] (its numbers and shaders) ->
//! [`render`] (the passes) -> pixels, in a window ([`flight`]) or a file ([`picture`]). [`physics`]
//! is the truth in f64 that all of it is measured against, and [`cli`] and [`report`] are how it is
//! asked and how it answers. docs/PHYSICS.md has the words and signs.

pub mod cli;
pub mod flight;
pub mod gpu;
pub mod physics;
pub mod picture;
pub mod render;
pub mod report;
pub mod scene;
