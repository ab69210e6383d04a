//! The comparison: pinned settings are drawn beside those of the current scene, or against them.
//! Both scenes have the camera, probe and picture of the current one, so that they differ only in
//! what is compared.

mod compared_scene;
mod difference;
mod pinned;

pub use compared_scene::{ComparedScene, ComparisonLayout, TwoScenes};
pub(super) use difference::{DifferencePass, draw_difference, prepare_difference};
pub use pinned::Pinned;

use crate::drawn_scene::DrawnScene;
use bevy::prelude::*;
use bevy::render::extract_resource::ExtractResourcePlugin;
use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Picture, View};

/// The pinned settings and how they are compared. `None` while nothing is compared.
#[derive(Resource, Clone, Debug, Default)]
pub struct Comparison(pub Option<(Pinned, ComparisonMode)>);

impl Comparison {
    /// Ends the comparison. Without one nothing is touched, because what is touched is drawn again.
    pub fn end(comparison: &mut ResMut<Self>) {
        if comparison.0.is_some() {
            comparison.0 = None;
        }
    }
}

/// How two scenes are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ComparisonMode {
    /// The pinned scene is drawn left of a divider, the current one right of it.
    SideBySide {
        /// Place of the divider, as a share of the picture's width.
        divider: f32,
    },
    /// Each scene is drawn whole, the pinned one in the left half and the current one in the right
    /// half.
    TwoPictures,
    /// The absolute difference of the two scenes' light is drawn.
    Difference {
        /// What the difference is multiplied by.
        gain: u32,
    },
}

impl ComparisonMode {
    /// The middle of the picture, as a share of its width: where two whole pictures meet, and where
    /// a divider begins.
    pub const MIDDLE: f32 = 0.5;

    fn layout(self, picture: &Picture) -> ComparisonLayout {
        match self {
            Self::SideBySide { divider } => ComparisonLayout::SideBySide {
                columns: columns_left_of(divider, picture),
            },
            Self::TwoPictures => ComparisonLayout::TwoPictures {
                columns: columns_left_of(Self::MIDDLE, picture),
            },
            Self::Difference { gain } => ComparisonLayout::Difference { gain: gain as f32 },
        }
    }
}

/// The number of the picture's columns left of a divider. Where the picture is shown in cells, the
/// divider lies between two cells, so that no cell mixes the two scenes.
fn columns_left_of(divider: f32, picture: &Picture) -> u32 {
    let steps = if picture.bypass {
        picture.width
    } else {
        picture.grid_width
    };
    let share = (f64::from(divider) * f64::from(steps)).round() / f64::from(steps.max(1));
    let columns = (share * f64::from(picture.width)).round();
    // A number that is not finite becomes zero.
    (columns as u32).min(picture.width)
}

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Comparison>()
        .init_resource::<ComparedScene>()
        .add_plugins(ExtractResourcePlugin::<ComparedScene>::default());
    difference::plugin(app);
}

/// Gives the pinned scene the camera, probe and picture of the current one.
pub(super) fn follow_current_scene(
    scene: Res<DrawnScene>,
    mut comparison: ResMut<Comparison>,
    mut compared: ResMut<ComparedScene>,
) {
    // What the pinned scene takes over is no change of the comparison.
    let next = match &mut comparison.bypass_change_detection().0 {
        None => ComparedScene::None,
        Some((pinned, mode)) => {
            pinned.follow(&scene);
            match pinned
                .drawable()
                .and_then(|drawable| draw_together(drawable, &scene, *mode))
            {
                Ok(scenes) => ComparedScene::Drawn(Box::new(scenes)),
                Err(reason) => ComparedScene::Undrawable(reason),
            }
        }
    };
    compared.set_if_neq(next);
}

/// The two scenes as this mode draws them, or why it cannot.
fn draw_together(
    pinned: Drawable,
    current: &Drawable,
    mode: ComparisonMode,
) -> Result<TwoScenes, String> {
    let layout = mode.layout(&current.picture);
    let (pinned, current) = match layout {
        ComparisonLayout::Difference { .. } if pinned.view != current.view => {
            return Err("a difference needs the same view on both sides".into());
        }
        ComparisonLayout::TwoPictures { .. } if current.view == View::Error => {
            return Err("the view error has numbers for one picture only".into());
        }
        ComparisonLayout::TwoPictures { columns } => {
            let width = current.picture.width;
            let [left, right] = [columns, width - columns].map(|columns| columns.max(1));
            // Both pictures have the same scale, by which the narrower one shows all that one
            // picture alone shows from left to right.
            let factor = f64::from(width) / f64::from(left.min(right));
            let half = |scene: &Drawable, columns| {
                Drawable::new(scene.widened(factor, columns)).map_err(|reason| reason.to_string())
            };
            (half(&pinned, left)?, Some(half(current, right)?))
        }
        _ => (pinned, None),
    };
    Ok(TwoScenes {
        pinned,
        current,
        layout,
    })
}
