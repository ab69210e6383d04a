//! What is drawn, and the geometry that it is drawn in: scenes and pure functions, without optics,
//! GPU or window.
//!
//! Each module may use those before it in this list:
//!
//! * [`words`](mod@words): enumerations with a word for each variant.
//! * [`numbers`]: numbers in words, as people read them.
//! * [`text`]: text that other programs wrote, decoded.
//! * [`reason`](mod@reason): why the system refused a file, in words.
//! * [`random`]: random numbers from a seed.
//! * [`geometry`]: Kerr and Schwarzschild, observers and geodesics, as pure functions in f64.
//! * [`scene`]: the one description of what is drawn, with its fields, limits and presets.

pub mod geometry;
pub mod numbers;
pub mod random;
pub mod reason;
pub mod scene;
pub mod text;
pub mod words;
