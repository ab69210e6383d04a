//! The star passes: compute passes that find the images of stars and add up their light in each
//! pixel. The geodesic pass adds the sums to its light.
//!
//! They run when the place of an image or its light changes, and not when only the exposure does.

mod buffers;
mod draw;
mod images;
mod kernels;
mod list;
mod ready;
mod sides;

pub(crate) use draw::plugin;
pub(crate) use images::{SceneStars, StarWriter};
pub(crate) use kernels::StarPipelines;
pub(crate) use list::StarLists;

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::optics::stars::Catalogue;

/// The catalogue of bright stars, which the sky mode `stars` shows. It stays the same as long as the
/// program runs.
#[derive(Resource, Clone, Copy, Debug, Deref, ExtractResource)]
pub struct StarCatalogue(pub &'static Catalogue);

impl Default for StarCatalogue {
    fn default() -> Self {
        Self(Catalogue::built_in())
    }
}
