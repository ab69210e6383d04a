//! Matter with depth: where a scene has it, and what traces rays through it.

use super::{Method, Scene};

impl Scene {
    /// Whether rays pass through matter with depth.
    pub fn has_medium(&self) -> bool {
        self.disk.enabled && self.disk.thickness > 0.0
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
