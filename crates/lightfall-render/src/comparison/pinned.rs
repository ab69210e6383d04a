//! Settings that were pinned for a comparison, seen by the camera of the current scene.

use lightfall_core::gpu::Drawable;
use lightfall_core::scene::{Camera, Observer, Scene};

/// A scene that follows the current one in everything that is not compared.
#[derive(Clone, Debug, PartialEq)]
pub struct Pinned {
    scene: Scene,
    /// The observer of the current scene, and the place of its camera, when they were last seen.
    observer: Observer,
    place: [f64; 3],
}

impl Pinned {
    /// Pins the settings of a scene.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self {
            scene: scene.clone(),
            observer: scene.observer,
            place: place(&scene.camera),
        }
    }

    /// Takes over the camera, the probe, the picture and the disk's time of the current scene.
    ///
    /// The observer is taken over while the camera moves, because flights and falls change both.
    /// An observer that is changed while the camera stays is what the user compares, and from then
    /// on each scene has its own.
    pub fn follow(&mut self, current: &Scene) {
        self.scene.camera = current.camera;
        self.scene.probe = current.probe;
        self.scene.picture = current.picture;
        self.scene.disk.time = current.disk.time;
        let moves = place(&current.camera) != self.place;
        if moves && self.scene.observer == self.observer {
            self.scene.observer = current.observer;
        }
        (self.observer, self.place) = (current.observer, place(&current.camera));
    }

    /// The scene to draw. Where its observer cannot exist at the camera's place, the observer of
    /// the current scene replaces it, and otherwise the nearest one that exists.
    ///
    /// # Errors
    /// Why the scene cannot be drawn from there.
    pub fn drawable(&self) -> Result<Drawable, String> {
        let with_current_observer = Scene {
            observer: self.observer,
            ..self.scene.clone()
        };
        Drawable::new(self.scene.clone())
            .or_else(|reason| Drawable::new(with_current_observer).map_err(|_| reason))
            .or_else(|reason| {
                Drawable::with_nearest_observer(self.scene.clone())
                    .map(|(drawable, _)| drawable)
                    .map_err(|_| reason)
            })
            .map_err(|reason| reason.to_string())
    }
}

fn place(camera: &Camera) -> [f64; 3] {
    [camera.r, camera.theta_deg, camera.phi_deg]
}
