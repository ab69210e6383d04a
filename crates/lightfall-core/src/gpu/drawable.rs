//! A scene that can be drawn: the only thing that the passes accept.

use super::{GpuError, GpuScene};
use crate::scene::{ObserverKind, Refusal, Scene};
use glam::UVec2;
use std::ops::Deref;
use thiserror::Error;

/// A scene that passed every check, together with what the GPU is told of it.
///
/// It reads as a [`Scene`], and cannot be changed: whoever wants another scene makes another
/// `Drawable` of it, and so learns whether that one can be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawable {
    scene: Scene,
    numbers: GpuScene,
}

/// Why a scene cannot be drawn.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Undrawable {
    /// A field has a value that it cannot have beside the others.
    #[error(transparent)]
    Refused(#[from] Refusal),
    /// The method, the spin and the observer do not go together.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl Drawable {
    /// Checks a scene and works out its numbers.
    ///
    /// # Errors
    /// The first field that is refused, or else why no shader can trace the scene.
    pub fn new(scene: Scene) -> Result<Self, Undrawable> {
        scene.check()?;
        let size = UVec2::new(scene.picture.width, scene.picture.height);
        let numbers = GpuScene::new(&scene, size)?;
        Ok(Self { scene, numbers })
    }

    /// As [`Drawable::new`]; but where the scene's observer cannot exist at the camera's place, the
    /// nearest observer that can takes its place. The second value is the kind that was put in.
    ///
    /// Nearer to the hole fewer kinds exist: a circular orbit ends at the photon orbit and off the
    /// equator, rest at the static limit, zero angular momentum at the horizon; free fall goes on.
    ///
    /// # Errors
    /// Why the scene cannot be drawn with its own observer, if no other one helps.
    pub fn with_nearest_observer(
        mut scene: Scene,
    ) -> Result<(Self, Option<ObserverKind>), Undrawable> {
        let reason = match Self::new(scene.clone()) {
            Ok(drawable) => return Ok((drawable, None)),
            Err(reason) => reason,
        };
        let own = scene.observer.kind;
        for kind in [ObserverKind::Static, ObserverKind::Zamo, ObserverKind::Rain] {
            scene.observer.kind = kind;
            if kind != own
                && let Ok(drawable) = Self::new(scene.clone())
            {
                return Ok((drawable, Some(kind)));
            }
        }
        Err(reason)
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// What the GPU is told of the scene, for a picture of the scene's own size.
    #[must_use]
    pub fn numbers(&self) -> &GpuScene {
        &self.numbers
    }

    /// The scene, to be changed and checked again.
    #[must_use]
    pub fn into_scene(self) -> Scene {
        self.scene
    }
}

impl Deref for Drawable {
    type Target = Scene;

    fn deref(&self) -> &Scene {
        &self.scene
    }
}
