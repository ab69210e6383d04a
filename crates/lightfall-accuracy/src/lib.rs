//! How wrong a method is: its answers compared with those of the f64 reference, on samples with
//! many difficult rays.
//!
//! Close to the critical curve every half-turn multiplies an error by e^pi whatever the method. So
//! three things are stated side by side: the forward error, which the picture shows; the backward
//! error, which is the method's own: the smallest turn t of the ray for which the reference's answer
//! differs from the method's by at most t; and the confusion matrix of outcomes.

mod answer;
mod camera_tracer;
mod delay;
pub mod inspection;
pub mod light;
mod picture;
mod ray;
pub mod rays;
mod reference_camera;
mod sample;
mod search;
pub mod steps;
mod summary;
mod tolerance;
mod truth;

pub use answer::{greater, hits, is_same_class};
pub use delay::{DelayError, TimedRay};
pub use light::{LightErrors, light_floor, true_passages};
pub use picture::picture_errors;
pub use ray::Ray;
pub use sample::{
    EDGE_DISTANCES, rays_near_edge, rays_over_picture, rays_over_picture_and_near_edge,
    rays_over_sky,
};
pub use search::edge::Shadow;
pub use search::thorough::ThoroughSearch;
pub use search::turns::TurnBounds;
pub use summary::{ErrorSummary, Quantiles};
pub use tolerance::tolerance;
pub use truth::{RayError, Truth};
