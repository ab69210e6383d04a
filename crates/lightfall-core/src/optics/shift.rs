//! What potentials and motions do to light, apart from each other, for pictures with one of them
//! switched off.
//!
//! At each end of a ray stands the observer with zero angular momentum (without spin: at rest), as
//! the article's observer does: she measures the frequency nu = E (1 - omega lambda) / N, with N
//! and omega her lapse and angular velocity (Bardeen, Press & Teukolsky 1972 eqs. 2.5, 3.2). So the
//! camera's frequency over the emitted one is a product,
//!
//!   g = gravity * motion,   gravity = nu(camera) / nu(emitter)
//!     = N_e (1 - omega_c lambda) / (N_c (1 - omega_e lambda)),
//!
//! and motion is the rest of it: by how much the camera and the matter move through those
//! observers. At infinity N = 1 and omega = 0. Derived.
//!
//! Straight rays (`effects.lensing = false`) have no lambda that both ends share. There the
//! frame-dragging is left out, gravity = N_e / N_c, and the matter's motion counts with the angle
//! at which it meets the straight ray.

use crate::geometry::kerr::{Kerr, MASS};
use crate::scene::{Effects, Scene};

/// The shifts of a scene's light, as its effects have them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shift {
    kerr: Kerr,
    effects: Effects,
    camera: RestFrame,
}

/// The observer with zero angular momentum at some place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestFrame {
    /// N = sqrt(Sigma Delta / A), A = (r^2 + a^2)^2 - a^2 Delta sin^2 theta. Zero inside the
    /// horizon, where there is no such observer.
    pub lapse: f64,
    /// omega = 2 M a r / A, in 1/r_s.
    pub dragging: f64,
    /// Circumference of her circle of latitude over 2 pi sin(theta): sqrt(A / Sigma), in r_s.
    pub width: f64,
}

impl RestFrame {
    /// At `r`, where the cosine of the angle from the axis is `cos_theta`.
    #[must_use]
    pub fn at(kerr: Kerr, r: f64, cos_theta: f64) -> Self {
        let (a2, sigma) = (kerr.a().powi(2), kerr.sigma(r, cos_theta));
        let area = sigma * (r * r + a2) + 2.0 * MASS * r * a2 * (1.0 - cos_theta * cos_theta);
        Self {
            lapse: (sigma * kerr.delta(r) / area).max(0.0).sqrt(),
            dragging: 2.0 * MASS * kerr.a() * r / area,
            width: (area / sigma).sqrt(),
        }
    }

    fn without_dragging_unless(self, lensing: bool) -> Self {
        if lensing {
            self
        } else {
            Self {
                dragging: 0.0,
                ..self
            }
        }
    }
}

impl Shift {
    /// Of this scene's light.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let kerr = Kerr {
            spin: scene.hole.spin,
        };
        let (_, cos) = crate::geometry::sphere::polar_sin_cos(scene.camera.theta_deg.to_radians());
        Self {
            kerr,
            effects: scene.effects,
            camera: Self::frame(kerr, scene.effects, scene.camera.r, cos),
        }
    }

    fn frame(kerr: Kerr, effects: Effects, r: f64, cos_theta: f64) -> RestFrame {
        RestFrame::at(kerr, r, cos_theta).without_dragging_unless(effects.lensing)
    }

    /// The frame at the camera.
    #[must_use]
    pub fn camera(&self) -> RestFrame {
        self.camera
    }

    /// Shift of light from infinity, `g` = 1/E being the whole one.
    #[must_use]
    pub fn of_sky(&self, g: f64, lambda: f64) -> f64 {
        self.parted(g, (1.0 - self.camera.dragging * lambda) / self.camera.lapse)
    }

    /// Shift of light from the disk at `r`, `g` being the whole one.
    #[must_use]
    pub fn of_disk(&self, g: f64, r: f64, lambda: f64) -> f64 {
        let there = Self::frame(self.kerr, self.effects, r, 0.0);
        let camera = (1.0 - self.camera.dragging * lambda) / self.camera.lapse;
        self.parted(g, camera * there.lapse / (1.0 - there.dragging * lambda))
    }

    /// `g` without the share of what is switched off.
    fn parted(&self, g: f64, gravity: f64) -> f64 {
        match (self.effects.gravitational_shift, self.effects.doppler) {
            (true, true) => g,
            (true, false) => gravity,
            (false, true) => g / gravity,
            (false, false) => 1.0,
        }
    }
}
