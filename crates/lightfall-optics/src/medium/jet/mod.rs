//! Jets: their shape, their motion and their smooth light. The twin in WGSL is
//! shaders/medium/jet.wgsl.
//!
//! The matter flows along the streamlines psi = r^kappa (1 - |cos theta|) (Tchekhovskoy, McKinney &
//! Narayan 2008, MNRAS 388, 551), so a jet's radius grows as r^(1 - kappa/2). With kappa = 0.88 this is
//! the z^0.56 of the jet of M87 (Asada & Nakamura 2012, ApJ 745, L28). Its brightness, its decay
//! outward and its swirl are choices for a picture, not results.

mod knots;
mod light;

pub use knots::{
    AXIS, FieldPlace, KINDS, KNOTS, Knots, SHEATH_KNOTS, STRANDS, TRAVEL, Travel, WAVES, Wave,
};
pub(super) use light::JetMatter;
pub use light::JetPlace;

use lightfall_model::geometry::kerr::Kerr;
use lightfall_model::scene::Scene;

/// The radius at which the spectrum falls off at [`Shape::colour`], in r_s.
const COLOUR_RADIUS: f64 = 10.0;
/// The share of the base's radius at which the matter is at rest.
const REST: f64 = 0.9;
/// The radius of a jet beyond which the matter swirls less, in r_s.
const SWIRL_RADIUS: f64 = 2.0;

/// The numbers of a pair of jets. Lengths are in r_s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// kappa of the streamlines.
    pub kappa: f64,
    /// psi of the outermost streamline.
    pub width: f64,
    /// Where the bright sheath is and how thick, as shares of the jet's radius.
    pub sheath: [f64; 2],
    /// Brightness of the axis over that of the sheath, and the radius of the spine as a share of the
    /// jet's.
    pub spine: [f64; 2],
    /// The power of the place across the jet with which the light falls to nothing at the edge.
    pub rim: f64,
    /// Velocity times Lorentz factor far out, and the radius over which the matter reaches half of it.
    pub speed: f64,
    /// As `speed` says.
    pub rise: f64,
    /// The radius where the light begins.
    pub base: f64,
    /// The radius where it has faded.
    pub length: f64,
    /// The share of this radius over which it fades.
    pub fade: f64,
    /// The power of the jet's radius with which the emission falls.
    pub decay: f64,
    /// Velocity about the axis over that along it, at the edge near the base.
    pub swirl: f64,
    /// Frequency at which the spectrum falls off at 10 r_s, over 540 THz.
    pub colour: f64,
    /// The power of r with which this frequency falls.
    pub cooling: f64,
    /// The power of the patterns' factor with which it grows: shocks heat.
    pub heating: f64,
}

impl Shape {
    /// The shape of jets of this width, speed, length and colour.
    pub fn new(kerr: Kerr, [width, speed, length, colour]: [f64; 4]) -> Self {
        Self {
            kappa: 0.88,
            width,
            sheath: [0.45, 0.35],
            spine: [100.0, 0.035],
            rim: 2.0,
            speed,
            rise: 8.0,
            base: 1.3 * kerr.horizon(),
            length,
            fade: 0.9,
            decay: 3.4,
            swirl: 0.5,
            colour,
            cooling: 1.1,
            heating: 0.6,
        }
    }
}

/// The jets of a hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// The hole.
    pub kerr: Kerr,
    /// The shape.
    pub shape: Shape,
}

impl Jet {
    /// The jets of a scene; `None` if it has none.
    pub fn of(scene: &Scene) -> Option<Self> {
        let (jet, kerr) = (scene.jet, scene.kerr());
        let shape = Shape::new(kerr, [jet.width, jet.speed, jet.length, jet.colour]);
        jet.enabled.then_some(Self { kerr, shape })
    }

    /// The place across the jet, from 0 on the axis to 1 on the outermost streamline.
    pub fn across(&self, r: f64, cos_theta: f64) -> f64 {
        let psi = r.powf(self.shape.kappa) * (1.0 - cos_theta.abs()).max(0.0);
        (psi / self.shape.width).sqrt()
    }

    /// The jet's radius at the distance `r` from the hole.
    pub fn radius(&self, r: f64) -> f64 {
        (2.0 * self.shape.width).sqrt() * r.powf(1.0 - 0.5 * self.shape.kappa)
    }

    /// The radius at which the matter is at rest.
    pub fn rest(&self) -> f64 {
        REST * self.shape.base
    }

    /// How far inside the jets a place is: positive inside.
    pub fn inside(&self, r: f64, cos_theta: f64) -> f64 {
        let Shape { base, length, .. } = self.shape;
        let x = self.across(r, cos_theta);
        (1.0 - x * x).min(r / base - 1.0).min(1.0 - r / length)
    }

    /// The radii beside the base and the end at which the light is not smooth.
    pub fn radii(&self) -> [f64; 3] {
        let shape = self.shape;
        let swirl = SWIRL_RADIUS / (2.0 * shape.width).sqrt();
        [
            2.0 * shape.base,
            (1.0 - shape.fade) * shape.length,
            swirl.powf(1.0 / (1.0 - 0.5 * shape.kappa)),
        ]
    }

    /// The brightness across the jet: a sheath and a spine, and nothing at the edge.
    pub fn profile(&self, x: f64) -> f64 {
        let [sheath, spine] = self.across_profile(x);
        (sheath + spine) * (1.0 - x.powf(self.shape.rim)).max(0.0).powi(2)
    }

    /// The brightness of the sheath and of the spine at a place across the jet.
    fn across_profile(&self, x: f64) -> [f64; 2] {
        let near = |offset: f64, width: f64| (-(offset / width).powi(2)).exp();
        let ([place, thickness], [spine, radius]) = (self.shape.sheath, self.shape.spine);
        [near(x - place, thickness), spine * near(x, radius)]
    }

    /// Emission of the smooth jets for each r_s of the way in the matter's frame.
    pub fn emissivity(&self, r: f64, cos_theta: f64) -> f64 {
        let shape = self.shape;
        let ends =
            fade(r / shape.base - 1.0) * fade((shape.length - r) / (shape.fade * shape.length));
        self.profile(self.across(r, cos_theta)) * self.radius(r).powf(-shape.decay) * ends
    }

    /// The frequency at which the matter's spectrum falls off, over 540 THz, where patterns multiply the
    /// emission by `factor`.
    pub fn frequency(&self, r: f64, factor: f64) -> f64 {
        self.shape.colour
            * (r / COLOUR_RADIUS).powf(-self.shape.cooling)
            * factor.powf(self.shape.heating)
    }

    /// The matter's Lorentz factor, and its velocity (outward, toward growing theta, toward growing
    /// phi) for the observer with zero angular momentum.
    pub fn velocity(&self, r: f64, cos_theta: f64) -> (f64, [f64; 3]) {
        let shape = self.shape;
        let momentum = shape.speed * (r - self.rest()) / (r + shape.rise);
        let lorentz = (1.0 + momentum * momentum).sqrt();
        // tan(theta/2) = sin(theta)/(1 + cos(theta)) from the nearer pole.
        let cos = cos_theta.abs();
        let half = ((1.0 - cos).max(0.0) / (1.0 + cos)).sqrt();
        let toward_axis = -shape.kappa * half * self.kerr.delta(r).max(0.0).sqrt() / r;
        let about =
            shape.swirl * self.across(r, cos_theta) * (SWIRL_RADIUS / self.radius(r)).min(1.0);
        let scale = momentum / lorentz / (1.0 + toward_axis.powi(2) + about.powi(2)).sqrt();
        let side = if cos_theta < 0.0 { -1.0 } else { 1.0 };
        (lorentz, [scale, side * toward_axis * scale, about * scale])
    }

    /// 1/g: the emitted over the observed frequency of light with the energy E and the angular momentum
    /// L, and with the slopes of u and of n_z along the backward ray in Mino time.
    ///
    /// The slopes are those of the photon: Sigma p^r = u'/u^2 and p_theta = n_z'/sin(theta).
    pub fn slowing(
        &self,
        [r, cos_theta]: [f64; 2],
        [energy, angular_momentum]: [f64; 2],
        [du, dz]: [f64; 2],
    ) -> f64 {
        let sin2 = (1.0 - cos_theta * cos_theta).max(1e-18);
        let sin = sin2.sqrt();
        let (sigma, delta) = (self.kerr.sigma(r, cos_theta), self.kerr.delta(r));
        let area = self.kerr.area(r, (sin, cos_theta));
        let lapse = (sigma * delta / area).sqrt();
        let dragging = self.kerr.a() * r / area;
        // The photon for the observer with zero angular momentum (Bardeen, Press & Teukolsky 1972
        // section III).
        let frequency = (energy - dragging * angular_momentum) / lapse;
        let momentum = [
            du * r * r / (sigma * delta).sqrt(),
            dz / (sin * sigma.sqrt()),
            angular_momentum / ((area / sigma).sqrt() * sin),
        ];
        let (lorentz, velocity) = self.velocity(r, cos_theta);
        let along: f64 = velocity.iter().zip(momentum).map(|(v, p)| v * p).sum();
        lorentz * (frequency - along)
    }
}

/// Smoothstep.
fn fade(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
