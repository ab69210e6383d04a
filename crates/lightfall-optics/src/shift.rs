//! The frequency shift split into a gravitational and a Doppler factor, for pictures with one of
//! them switched off. The twin in WGSL is shaders/shift.wgsl.
//!
//! As in the article, each end of a ray has a zero-angular-momentum observer (ZAMO; without spin an
//! observer at rest). A ZAMO with lapse N and angular velocity omega measures the frequency nu = E
//! (1 - omega lambda) / N (Bardeen, Press & Teukolsky 1972 eqs. 2.5, 3.2). So the observed over the
//! emitted frequency is a product,
//!
//!   g = gravity * motion,   gravity = nu(camera) / nu(emitter)
//!     = N_e (1 - omega_c lambda) / (N_c (1 - omega_e lambda)),
//!
//! and the other factor is due to the motion of the camera and of the matter relative to the ZAMOs.
//! At infinity N = 1 and omega = 0. Derived.
//!
//! On straight rays (`effects.lensing = false`) lambda is not the same at both ends. There the
//! frame dragging is left out, gravity = N_e / N_c, and the Doppler factor is that of the angle
//! between the matter's velocity and the straight ray.

use lightfall_model::geometry::kerr::{Kerr, MASS};
use lightfall_model::geometry::sphere::polar_sin_cos;
use lightfall_model::scene::{Effects, Scene};
use std::f64::consts::FRAC_PI_2;

/// The frequency shifts of a scene's light, with the scene's effects on or off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shift {
    kerr: Kerr,
    effects: Effects,
    camera: RestFrame,
}

/// The frame of the zero-angular-momentum observer at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RestFrame {
    /// N = sqrt(Sigma Delta / A), with A as in [`Kerr::area`]. Zero inside the horizon, where there
    /// is no such observer.
    pub lapse: f64,
    /// omega = 2 M a r / A, in 1/r_s.
    pub dragging: f64,
    /// Circumference of the circle of latitude over 2 pi sin(theta): sqrt(A / Sigma), in r_s.
    pub width: f64,
}

impl RestFrame {
    /// The frame at (`r`, `theta`) (r_s, radians).
    pub fn at(kerr: Kerr, r: f64, theta: f64) -> Self {
        let (sin, cos) = polar_sin_cos(theta);
        let (sigma, area) = (kerr.sigma(r, cos), kerr.area(r, (sin, cos)));
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
    /// The shifts of this scene's light.
    pub fn new(scene: &Scene) -> Self {
        let kerr = scene.kerr();
        let theta = scene.camera.theta_deg.to_radians();
        Self {
            kerr,
            effects: scene.effects,
            camera: Self::frame(kerr, scene.effects, scene.camera.r, theta),
        }
    }

    fn frame(kerr: Kerr, effects: Effects, r: f64, theta: f64) -> RestFrame {
        RestFrame::at(kerr, r, theta).without_dragging_unless(effects.lensing)
    }

    /// The frame at the camera.
    pub fn camera(&self) -> RestFrame {
        self.camera
    }

    /// Shift of light from infinity, where `g` = 1/E is the full shift.
    pub fn of_sky(&self, g: f64, lambda: f64) -> f64 {
        self.active_part(g, (1.0 - self.camera.dragging * lambda) / self.camera.lapse)
    }

    /// Shift of light from the disk at `r`, where `g` is the full shift.
    pub fn of_disk(&self, g: f64, r: f64, lambda: f64) -> f64 {
        self.of_matter(g, (r, FRAC_PI_2), lambda)
    }

    /// Shift of light from matter at the radius and the angle `theta` of `place`, where `g` is the
    /// full shift.
    pub fn of_matter(&self, g: f64, (r, theta): (f64, f64), lambda: f64) -> f64 {
        let emitter = Self::frame(self.kerr, self.effects, r, theta);
        let camera = (1.0 - self.camera.dragging * lambda) / self.camera.lapse;
        self.active_part(
            g,
            camera * emitter.lapse / (1.0 - emitter.dragging * lambda),
        )
    }

    /// The factor by which a shift multiplies bolometric intensity: g^4, or one without beaming.
    pub fn beaming_factor(&self, g: f64) -> f64 {
        if self.effects.beaming { g.powi(4) } else { 1.0 }
    }

    /// `g` without the factors of the effects that are off.
    fn active_part(&self, g: f64, gravity: f64) -> f64 {
        match (self.effects.gravitational_shift, self.effects.doppler) {
            (true, true) => g,
            (true, false) => gravity,
            (false, true) => g / gravity,
            (false, false) => 1.0,
        }
    }
}
