//! How wrong a method is: its answers compared with those of the f64 reference, on samples with
//! many difficult rays.
//!
//! Close to the critical curve every half-turn multiplies an error by e^pi whatever the method. So
//! three things are stated side by side: the forward error, which the picture shows; the backward
//! error, which is the method's own: the smallest turn t of the ray for which the reference's answer
//! differs from the method's by at most t; and the confusion matrix of outcomes.

mod answer;
mod backward;
mod camera_tracer;
mod chart;
mod class;
mod delay;
mod edge;
mod grid;
pub mod inspection;
mod near_edge;
mod newton;
mod part;
mod picture;
mod ray;
pub mod rays;
mod reference_camera;
mod sample;
pub mod steps;
mod summary;
mod surroundings;
mod tolerance;
mod truth;
mod turns;

pub use answer::{greater, hits, is_same_class};
pub use delay::{DelayError, TimedRay};
pub use edge::Shadow;
pub use picture::picture_errors;
pub use ray::Ray;
pub use sample::{
    EDGE_DISTANCES, rays_near_edge, rays_over_picture, rays_over_picture_and_near_edge,
    rays_over_sky,
};
pub use summary::{ErrorSummary, Quantiles};
pub use surroundings::Surroundings;
pub use tolerance::tolerance;
pub use truth::{RayError, Truth};
pub use turns::Bounds;
