//! Scenes reduced to the fields that matter for one purpose, so that two of them compare equal
//! exactly when the result is the same.

use super::{Disk, HotSpotKind, Picture, Scene};
use glam::UVec2;

/// Steps of the exposure, in powers of two, at which the unit of whole-numbered light changes.
pub const EXPOSURE_STEP: f64 = 4.0;

impl Scene {
    /// The scene with only the fields that decide the traced picture, before the presentation. The
    /// schema, the texts and the presentation's settings have their defaults.
    ///
    /// Every other field is kept, whether the scene uses it or not: a field too many costs one
    /// frame, a field too few leaves a wrong picture on screen.
    #[must_use]
    pub fn without_presentation(&self) -> Self {
        let default = Self::default();
        let mut reduced = Self {
            schema: default.schema,
            name: default.name,
            title: default.title,
            ..self.clone()
        };
        reduced.picture.grid_width = default.picture.grid_width;
        reduced.picture.grid_height = default.picture.grid_height;
        reduced.picture.levels = default.picture.levels;
        reduced.picture.dither = default.picture.dither;
        reduced.picture.bypass = default.picture.bypass;
        reduced
    }

    /// The scene with only the fields that decide where the picture's rays go and end. Texts, the
    /// view, and everything that only gives rays their colour have their defaults.
    #[must_use]
    pub fn without_shading(&self) -> Self {
        let default = Self::default();
        Self {
            method: self.method,
            hole: self.hole,
            camera: self.camera,
            observer: self.observer,
            effects: self.effects,
            quality: self.quality,
            disk: Disk {
                enabled: self.disk.enabled,
                inner: self.disk.inner,
                follow_isco: self.disk.follow_isco,
                outer: self.disk.outer,
                thickness: self.disk.thickness,
                tilt_deg: self.disk.tilt_deg,
                node_deg: self.disk.node_deg,
                ..default.disk
            },
            picture: Picture {
                width: self.picture.width,
                height: self.picture.height,
                ..default.picture
            },
            ..default
        }
    }

    /// The scene with only the fields that decide the light of its point stars: those of its rays,
    /// the sky, and what of the disk lets light through. The exposure counts in steps of
    /// `EXPOSURE_STEP`, so that a little more of it draws no star anew.
    #[must_use]
    pub fn for_stars(&self) -> Self {
        let mut needed = self.without_shading();
        needed.sky = self.sky.clone();
        if self.has_thick_disk() {
            needed.disk = self.disk;
            if !needed.disk_moves() {
                needed.disk.time = Self::default().disk.time;
            }
        } else {
            needed.disk.edge_taper = self.disk.edge_taper;
            needed.disk.transmission = self.disk.transmission;
        }
        needed.picture.exposure_ev = self.stepped_exposure();
        needed
    }

    /// The exposure, rounded to a multiple of `EXPOSURE_STEP`.
    pub fn stepped_exposure(&self) -> f64 {
        EXPOSURE_STEP * (self.picture.exposure_ev / EXPOSURE_STEP).round()
    }

    /// The scene with only the fields that read-outs depend on: those of its rays, and where a hot
    /// spot is seen. Other light of the disk, which may move, is left out.
    #[must_use]
    pub fn for_readouts(&self) -> Self {
        let mut needed = self.without_shading();
        if self.drawn_hot_spot() != HotSpotKind::None {
            needed.hot_spot = self.hot_spot;
            needed.disk.time = self.disk.time;
        }
        needed
    }
}

impl Picture {
    /// Width and height of the traced picture, in pixels.
    pub fn size(&self) -> UVec2 {
        UVec2::new(self.width, self.height)
    }

    /// Width of the traced picture over its height.
    pub fn aspect(&self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }

    /// Columns and rows of the presentation grid.
    pub fn grid(&self) -> UVec2 {
        UVec2::new(self.grid_width, self.grid_height)
    }
}
