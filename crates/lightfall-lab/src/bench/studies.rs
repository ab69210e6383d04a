//! The article's four ways to refine its methods, each as a series of settings.

use lightfall_model::scene::{
    ARTICLE_MAX_STEPS, ArticleQuality, MAX_STEP_BUDGET, Method, Quality, Scene,
};

lightfall_model::words! {
    /// What a series refines.
    pub enum Study {
        /// Half the scale of the steps, again and again, with the article's budgets.
        StepScale = "step-scale",
        /// Twice the budgets of steps and of affine length, at a 32nd of the balanced step.
        Budget = "budget",
        /// Twice the radius of escape, at an eighth of the balanced step and with all budgets.
        EscapeRadius = "escape-radius",
        /// Half the least step, at a 64th of the balanced step, with all budgets and a far radius of
        /// escape.
        LeastStep = "least-step",
    }
}

/// The affine length where it should not limit any ray.
const UNLIMITED_AFFINE: f64 = 1e9;

/// The farthest radius of escape, as a power of two times the article's.
const FAR: i32 = 6;

/// One setting of a series.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Refinement {
    pub(super) study: Study,
    pub(super) scene: Scene,
}

/// Every series for one of the article's methods in a scene. Whatever no series mentions is the
/// article's.
pub(super) fn refinements(scene: &Scene, method: Method) -> Vec<Refinement> {
    let article = Scene {
        method,
        quality: Quality::default(),
        ..scene.clone()
    };
    let power = |exponent: i32| 2.0_f64.powi(exponent);
    let step = |halvings: i32| ArticleQuality::Balanced.step_scale() * power(-halvings);
    let radius = |doublings: i32| article.escape_radius() * power(doublings);
    let of = |study: Study, quality: Quality| Refinement {
        study,
        scene: Scene {
            quality,
            ..article.clone()
        },
    };
    let unlimited = Quality {
        max_steps: MAX_STEP_BUDGET,
        max_affine: UNLIMITED_AFFINE,
        ..article.quality
    };
    let step_scales = (-1..=6).map(|halvings| Quality {
        step_scale: step(halvings),
        ..article.quality
    });
    let budgets = (-1..=4).map(|doublings| Quality {
        step_scale: step(5),
        max_steps: (f64::from(ARTICLE_MAX_STEPS) * power(doublings)) as u32,
        max_affine: article.quality.max_affine * power(doublings),
        ..article.quality
    });
    let radii = (0..=FAR).map(|doublings| Quality {
        step_scale: step(3),
        escape_radius: radius(doublings),
        ..unlimited
    });
    let least_steps = (0..=5).map(|halvings| Quality {
        step_scale: step(6),
        escape_radius: radius(FAR),
        min_step: article.min_step() * power(-halvings),
        ..unlimited
    });
    step_scales
        .map(|quality| of(Study::StepScale, quality))
        .chain(budgets.map(|quality| of(Study::Budget, quality)))
        .chain(radii.map(|quality| of(Study::EscapeRadius, quality)))
        .chain(least_steps.map(|quality| of(Study::LeastStep, quality)))
        .collect()
}
