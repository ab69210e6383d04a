//! The pinned scene as the passes draw it.

use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResource;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::Scene;

/// The pinned scene as it is drawn with the current one.
#[derive(Resource, Clone, Debug, Default, PartialEq, ExtractResource)]
pub enum ComparedScene {
    /// Nothing is compared.
    #[default]
    None,
    /// The pinned settings cannot be drawn from the current camera, for this reason.
    Undrawable(String),
    /// The pinned scene, and where it is drawn.
    Drawn(Box<(Drawable, ComparisonLayout)>),
}

/// Where the two scenes are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ComparisonLayout {
    /// The pinned scene fills this many columns of the picture, from the left.
    SideBySide {
        /// The number of columns, in pixels.
        columns: u32,
    },
    /// Each scene fills a texture of its own, and the picture shows their difference.
    Difference {
        /// What the difference is multiplied by.
        gain: f32,
    },
}

impl ComparedScene {
    /// The pinned scene and where it is drawn, if it is.
    #[must_use]
    pub fn drawn(&self) -> Option<(&Drawable, ComparisonLayout)> {
        match self {
            Self::Drawn(drawn) => Some((&drawn.0, drawn.1)),
            _ => None,
        }
    }

    /// Whether the picture shows a difference.
    pub(crate) fn is_difference(&self) -> bool {
        matches!(self.drawn(), Some((_, ComparisonLayout::Difference { .. })))
    }

    /// What decides the traced picture: as [`Scene::without_presentation`], of the pinned scene.
    pub(crate) fn without_presentation(&self) -> Option<(Scene, ComparisonLayout)> {
        self.drawn()
            .map(|(scene, layout)| (scene.without_presentation(), layout))
    }
}
