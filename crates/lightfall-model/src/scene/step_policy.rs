//! The steps of the article's methods, verlet and kerr-schild: the article's named qualities, and
//! what the fields of `quality` mean where they leave the choice to the program.

use super::{ARTICLE_MAX_STEPS, AccuracySetting, Quality, Scene};

crate::words! {
    /// The article's qualities, each a scale of the steps and a budget of steps.
    pub enum ArticleQuality {
        /// The fastest.
        Cheap = "cheap",
        /// The article's default.
        Balanced = "balanced",
        /// The most exact.
        High = "high",
    }
}

impl ArticleQuality {
    /// Its `quality.step_scale`.
    pub const fn step_scale(self) -> f64 {
        match self {
            Self::Cheap => 1.55,
            Self::Balanced => 0.85,
            Self::High => 0.45,
        }
    }

    /// Its `quality.max_steps`.
    pub const fn max_steps(self) -> u32 {
        match self {
            Self::Cheap => 128,
            Self::Balanced => 256,
            Self::High => ARTICLE_MAX_STEPS,
        }
    }
}

impl Quality {
    /// These settings with the steps of one of the article's qualities.
    #[must_use]
    pub fn with_steps_of(self, named: ArticleQuality) -> Self {
        Self {
            step_scale: named.step_scale(),
            max_steps: named.max_steps(),
            ..self
        }
    }

    /// The article's quality that has these steps, if one has.
    pub fn article(&self) -> Option<ArticleQuality> {
        ArticleQuality::ALL
            .into_iter()
            .find(|named| *self == self.with_steps_of(*named))
    }
}

impl Scene {
    /// The radius beyond which an outgoing ray of the article's methods counts as escaped:
    /// `quality.escape_radius`, but never less than the camera's radius and the disk's, or the
    /// article's own rule.
    pub fn escape_radius(&self) -> f64 {
        let (camera, disk) = (self.camera.r, self.disk.outer);
        if self.quality.escape_radius > 0.0 {
            self.quality.escape_radius.max(camera).max(disk)
        } else {
            // Beyond the disk whether the disk is shown or not.
            f64::max(1.15 * camera, 3.0 * disk)
        }
    }

    /// The least step of the method's rule: `quality.min_step`, or the article's own. Zero for
    /// methods that have none.
    pub fn min_step(&self) -> f64 {
        let own = self.resolved_method().properties().min_step;
        if own > 0.0 && self.quality.min_step > 0.0 {
            self.quality.min_step
        } else {
            own
        }
    }

    /// How many times the article's budget of steps one ray may take; one for methods without such
    /// a budget.
    pub fn budget_ratio(&self) -> f64 {
        let budgeted = self.effects.lensing
            && self.resolved_method().properties().setting == AccuracySetting::StepScale;
        if budgeted {
            f64::from(self.quality.max_steps.max(ARTICLE_MAX_STEPS)) / f64::from(ARTICLE_MAX_STEPS)
        } else {
            1.0
        }
    }
}
