//! The core of Lightfall, without Bevy: what is drawn, the physics of light around a black hole,
//! the shaders and their numbers, and how accurate all of it is.
//!
//! This crate joins the crates of the core under one name. Each of them depends only on those before
//! it in this list, so the compiler keeps their order:
//!
//! 1. `lightfall-model`: [`words`](mod@words) and [`numbers`], [`geometry`] (Kerr and Schwarzschild as
//!    pure functions in f64) and [`scene`] (the one description of what is drawn).
//! 2. `lightfall-optics`, as [`optics`]: what a scene's camera sees, in f64: the truth that
//!    everything is measured against.
//! 3. `lightfall-gpu`, as [`gpu`]: a scene as the GPU's numbers and shaders, and rays traced by them.
//! 4. `lightfall-accuracy`, as [`accuracy`]: how wrong an answer is, against the reference.
//!
//! `lightfall-lab`, which measures error against run time, stands above them. docs/PHYSICS.md explains
//! the words and signs.

pub use lightfall_accuracy as accuracy;
pub use lightfall_gpu as gpu;
pub use lightfall_model::{geometry, numbers, random, reason, scene, text, words};
pub use lightfall_optics as optics;
