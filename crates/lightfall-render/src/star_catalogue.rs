//! The stars that the sky mode `stars` shows.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::optics::stars::Catalogue;

/// The catalogue of bright stars. It stays the same as long as the program runs.
#[derive(Resource, Clone, Copy, Debug, Deref, ExtractResource)]
pub struct StarCatalogue(pub &'static Catalogue);

impl Default for StarCatalogue {
    fn default() -> Self {
        Self(Catalogue::built_in())
    }
}
