//! The images of a star, solved forward: from the star's direction at infinity to every direction
//! in which the camera sees it, with the magnification of each image. The kernels in shaders/stars/
//! do the same.
//!
//! A star of flux F, as it would be seen by an observer at rest without the hole, has an image of
//! the flux g^4 mu F and of the temperature g T, where mu is the ratio of the solid angles at the
//! camera and on the sky (I_nu / nu^3 is conserved: Misner, Thorne & Wheeler 1973, section 22.6).
//!
//! * Without spin the images are found by inverting a table ([`table`]).
//! * Without lensing there is one image, and mu is due to aberration alone: mu = g^-2.
//! * With spin, and for every other tracer, an image is polished with the tracer itself
//!   ([`refine_image`]).

mod caustic;
mod inversion;
mod mesh_layout;
mod named;
mod ray_mesh;
pub mod refine_image;
pub mod table;

pub use caustic::{MIN_SOURCE_RADIUS, inverse_sine};
pub use inversion::{Inversion, InversionError};
pub use mesh_layout::MeshLayout;
pub use named::{NamedImage, named_images};
pub use ray_mesh::RayMesh;
pub use table::ORDERS;

use glam::DVec3;

/// An image of a star.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StarImage {
    /// The looking direction in which the camera sees it: a unit vector on the observer's axes
    /// (outward, toward growing theta, toward growing phi).
    pub direction: DVec3,
    /// The number of whole half-turns of its light about the hole.
    pub order: u32,
    /// The solid angle at the camera over the solid angle on the sky.
    pub magnification: f64,
    /// g: the frequency at the camera over the frequency at the star. With every effect on it is
    /// 1/E.
    pub shift: f64,
    /// The image's flux over the star's own: g^4 mu, or mu without beaming.
    pub gain: f64,
}
