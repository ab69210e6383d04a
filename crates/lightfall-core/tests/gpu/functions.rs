//! Values of the shaders' elementary and elliptic functions.

use crate::gpu;
use crate::light::light_from;
use glam::Vec4;
use lightfall_core::gpu::Variant;
use lightfall_core::scene::{Method, Scene};

/// The value of an expression of these functions for each `given` in it.
pub fn value_of_functions(expression: &str, given: &[Vec4]) -> Vec<Vec4> {
    let scene = Scene {
        method: Method::Closed,
        ..Scene::default()
    };
    let source = Variant::rays(&scene).source();
    light_from(gpu(), &source, expression, &[], given.iter().copied())
}
