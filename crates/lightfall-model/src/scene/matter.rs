//! Matter with depth: where a scene has it, and what traces rays through it.

use super::{HotSpotKind, Jet, Method, Scene};

/// The radius at which the thickness is H/r, in units of the disk's inner edge.
pub const THICKNESS_PIVOT: f64 = 4.0;
/// The smallest H/r that is no sheet. With less, single rays would hardly meet the matter between two
/// numbers of the GPU.
pub(super) const MIN_THICKNESS: f64 = 0.002;
/// The largest H/r, at any radius: the surface is then 26 degrees from the axis.
pub(super) const MAX_THICKNESS: f64 = 0.3;

impl Scene {
    /// Whether rays pass through matter with depth.
    pub fn has_medium(&self) -> bool {
        self.has_thick_disk() || self.jet.enabled
    }

    /// Whether the disk has thickness.
    pub fn has_thick_disk(&self) -> bool {
        self.disk.enabled && self.disk.thickness > 0.0
    }

    /// The hot spot that the disk has: none where the disk is off, or has thickness.
    pub fn drawn_hot_spot(&self) -> HotSpotKind {
        if self.disk.enabled && !self.has_thick_disk() {
            self.hot_spot.kind
        } else {
            HotSpotKind::None
        }
    }

    /// Whether something moves along the jets.
    pub fn jets_move(&self) -> bool {
        let Jet {
            enabled,
            knots,
            brightness,
            ..
        } = self.jet;
        enabled && knots > 0.0 && brightness > 0.0
    }

    /// Whether the picture depends on how disk and jets shine and absorb: it shows light, or what
    /// matter with depth does to it.
    pub fn shows_sources(&self) -> bool {
        self.view.shows_light() || self.view.shows_matter() && self.has_medium()
    }

    /// What `auto` means: the method with the smallest error at its speed (docs/ACCURACY.md) among
    /// those that can trace the scene.
    pub fn best_method(&self) -> Method {
        if self.has_medium() {
            Method::Mino
        } else {
            Method::BEST
        }
    }

    /// The scene's method, or what `auto` means for it.
    pub fn resolved_method(&self) -> Method {
        match self.method {
            Method::Auto => self.best_method(),
            method => method,
        }
    }
}
