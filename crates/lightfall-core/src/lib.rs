//! The core of Lightfall, without Bevy: what is drawn, the physics of light around a black hole,
//! the shaders and their numbers, and how accurate all of it is.
//!
//! Each module may import from those before it in this list, and from no other:
//!
//! 1. [`words`](mod@words): enumerations with a word for each variant.
//! 2. [`numbers`]: numbers as text, for people.
//! 3. [`random`]: random numbers that are the same on every machine.
//! 4. [`geometry`]: Kerr and Schwarzschild, observers and geodesics, as pure functions in f64.
//! 5. [`scene`]: the one description of what is drawn, with its fields, limits and presets.
//! 6. [`optics`]: what a scene's camera sees, in f64: the truth that everything is measured against.
//! 7. [`gpu`]: a scene as the GPU's numbers and shaders, and rays traced by them.
//! 8. [`accuracy`]: how wrong an answer is, against the reference.
//! 9. [`reports`]: measurements in forms that people and programs read.
//!
//! A test, `cargo test -p lightfall-core --test structure`, fails on an import that runs the other
//! way and on files that import each other in a circle. docs/PHYSICS.md explains the words and signs.

pub mod accuracy;
pub mod geometry;
pub mod gpu;
pub mod numbers;
pub mod optics;
pub mod random;
pub mod reports;
pub mod scene;
pub mod words;
