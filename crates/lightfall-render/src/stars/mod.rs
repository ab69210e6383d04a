//! The star passes: compute passes that find the images of stars and add up their light in each
//! pixel. The geodesic pass adds the sums to its light.
//!
//! They run when the place of an image or its light changes, and not when only the exposure does.

mod draw;
mod images;
mod kernels;
mod list;

pub(crate) use draw::plugin;
pub(crate) use images::{SceneStars, StarWriter};
pub(crate) use kernels::{StarPass, StarPipelines};
