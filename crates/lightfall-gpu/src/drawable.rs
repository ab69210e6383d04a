//! A checked scene: the only thing that the passes accept.

use super::error::GpuError;
use super::scene::GpuScene;
use lightfall_model::scene::{Frame, ObserverKind, Refusal, Scene};
use lightfall_optics::exposure::exposed;
use lightfall_optics::sky_picture::{SkyPicture, SkyPictureError};
use std::ops::Deref;
use thiserror::Error;

/// A scene that passed every check, together with its numbers for the GPU.
///
/// It dereferences to its [`Scene`], but cannot be changed: every changed scene goes through
/// [`Drawable::new`], which says whether it can be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawable {
    scene: Scene,
    numbers: GpuScene,
}

/// Why a scene cannot be drawn.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Undrawable {
    /// A field has a value that it cannot have together with the others.
    #[error(transparent)]
    Refused(#[from] Refusal),
    /// The method, the spin and the observer are not compatible.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The picture of the sky cannot be shown.
    #[error(transparent)]
    Sky(#[from] SkyPictureError),
}

impl Drawable {
    /// Checks a scene, reads the picture that its sky shows, if it shows one that was not read
    /// before, and computes its numbers for the GPU.
    ///
    /// # Errors
    /// The first refused field, the reason why no shader can trace the scene, or what is wrong with
    /// the picture of the sky.
    pub fn new(scene: Scene) -> Result<Self, Undrawable> {
        scene.check()?;
        SkyPicture::of(&scene)?;
        let numbers = GpuScene::new(&scene, &Frame::of(&scene))?;
        Ok(Self { scene, numbers })
    }

    /// As [`Drawable::new`], but if the scene's observer cannot exist at the camera's place,
    /// another kind of observer that can replaces it. The second value is the new kind.
    ///
    /// The kinds that exist off the equatorial plane are tried in the order in which they cease to
    /// exist toward the hole: static observers at the static limit, ZAMOs at the horizon, and free
    /// fall continues inside.
    ///
    /// # Errors
    /// The reason why the scene cannot be drawn with its own observer, if no other kind helps.
    pub fn with_nearest_observer(
        mut scene: Scene,
    ) -> Result<(Self, Option<ObserverKind>), Undrawable> {
        let reason = match Self::new(scene.clone()) {
            Ok(drawable) => return Ok((drawable, None)),
            Err(reason) => reason,
        };
        let own = scene.observer.kind;
        for kind in ObserverKind::ALL {
            scene.observer.kind = kind;
            if kind != own
                && !kind.properties().equatorial
                && let Ok(drawable) = Self::new(scene.clone())
            {
                return Ok((drawable, Some(kind)));
            }
        }
        Err(reason)
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The scene's numbers for the GPU, for its own frame or the one that it is shown in.
    pub fn numbers(&self) -> &GpuScene {
        &self.numbers
    }

    /// The scene as a frame shows it. The frame's values have to be within the ranges of their
    /// fields; whether there is an observer does not depend on them.
    #[must_use]
    pub fn shown_in(&self, frame: &Frame) -> Self {
        let scene = frame.shown(&self.scene);
        let mut numbers = self.numbers.clone();
        numbers.set_frame(&scene, frame);
        Self { scene, numbers }
    }

    /// The scene with the exposure that its light meter chooses, where its exposure is automatic.
    #[must_use]
    pub fn exposed(self) -> Self {
        if !self.scene.picture.automatic_exposure {
            return self;
        }
        self.shown_in(&Frame::of(&exposed(&self.scene)))
    }

    /// The scene, for changes that are checked again.
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
