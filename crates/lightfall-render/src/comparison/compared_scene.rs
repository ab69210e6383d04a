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
    /// The two scenes, and where they are drawn.
    Drawn(Box<TwoScenes>),
}

/// Two scenes that are drawn together.
#[derive(Clone, Debug, PartialEq)]
pub struct TwoScenes {
    /// The pinned scene as it is drawn.
    pub pinned: Drawable,
    /// The current scene, where it is drawn otherwise than alone.
    pub current: Option<Drawable>,
    /// Where they are drawn.
    pub layout: ComparisonLayout,
}

/// Where the two scenes are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ComparisonLayout {
    /// The pinned scene fills this many columns of the picture, from the left.
    SideBySide {
        /// The number of columns, in pixels.
        columns: u32,
    },
    /// Each scene is drawn whole: the pinned one in this many columns of the picture, from the left,
    /// and the current one in the others.
    TwoPictures {
        /// The number of columns, in pixels.
        columns: u32,
    },
    /// Each scene fills a texture of its own, and the picture shows their difference.
    Difference {
        /// What the difference is multiplied by.
        gain: f32,
    },
}

impl ComparisonLayout {
    /// The number of columns that show the pinned scene, where each scene has columns of its own.
    #[must_use]
    pub fn divider(self) -> Option<u32> {
        match self {
            Self::SideBySide { columns } | Self::TwoPictures { columns } => Some(columns),
            Self::Difference { .. } => None,
        }
    }

    /// Whether each scene is drawn whole.
    #[must_use]
    pub fn is_two_pictures(self) -> bool {
        matches!(self, Self::TwoPictures { .. })
    }
}

impl ComparedScene {
    /// The pinned scene and where it is drawn, if it is.
    #[must_use]
    pub fn drawn(&self) -> Option<(&Drawable, ComparisonLayout)> {
        match self {
            Self::Drawn(scenes) => Some((&scenes.pinned, scenes.layout)),
            _ => None,
        }
    }

    /// The current scene as it is drawn: of two whole pictures, each has half of the columns.
    #[must_use]
    pub fn drawn_current<'a>(&'a self, current: &'a Drawable) -> &'a Drawable {
        match self {
            Self::Drawn(scenes) => scenes.current.as_ref().unwrap_or(current),
            _ => current,
        }
    }

    /// Where the current scene's own picture begins in the whole one, in columns.
    #[must_use]
    pub fn first_column(&self) -> u32 {
        match self.drawn() {
            Some((_, ComparisonLayout::TwoPictures { columns })) => columns,
            _ => 0,
        }
    }

    /// Whether the picture shows a difference.
    pub(crate) fn is_difference(&self) -> bool {
        matches!(self.drawn(), Some((_, ComparisonLayout::Difference { .. })))
    }

    /// Whether the picture shows two whole ones.
    pub(crate) fn is_two_pictures(&self) -> bool {
        self.drawn()
            .is_some_and(|(_, layout)| layout.is_two_pictures())
    }

    /// What decides the traced picture: as [`Scene::without_presentation`], of the pinned scene.
    pub(crate) fn without_presentation(&self) -> Option<(Scene, ComparisonLayout)> {
        self.drawn()
            .map(|(scene, layout)| (scene.without_presentation(), layout))
    }
}
