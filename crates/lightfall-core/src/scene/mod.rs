//! The scene: the one description of what is drawn, written by the command line, presets and
//! controls, read by the passes. Plain data: no Bevy, no GPU types, no files.
//!
//! Lengths are in Schwarzschild radii, angles in degrees (suffix `_deg`), temperatures in kelvin.
//! The hole's frame is right-handed with z along the disk normal; `r`, `theta_deg`, `phi_deg` are
//! Boyer-Lindquist.

mod camera;
mod defaults;
mod edit;
mod error;
mod fields;
pub mod journey;
mod limits;
mod load;
mod method;
mod pose;
pub mod presets;
mod relevant;
mod save;

pub use crate::geometry::observer::ObserverKind;
pub use camera::MAX_RADIUS;
pub use error::{Because, Refusal, SceneError};
pub use fields::{FIELDS, Field, Kind, MAX_PICTURE_SIDE, MAX_TEXT_CHARS, Range, field};
pub use load::{Override, load};
pub use method::Method;

use serde::{Deserialize, Serialize};

/// The version of the preset format this program reads and writes.
pub const SCHEMA: u32 = 1;

/// Everything that decides a picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Scene {
    /// Version of the preset format.
    pub schema: u32,
    /// Short name, as `--preset NAME` finds it.
    pub name: String,
    /// One line that says what there is to see.
    pub title: String,
    /// How light is traced.
    pub method: Method,
    /// What the geodesic pass shows.
    pub view: View,
    /// The hole.
    pub hole: Hole,
    /// Where the camera is and where it looks.
    pub camera: Camera,
    /// How the camera moves through the place where it is.
    pub observer: Observer,
    /// Which effects there are; without one of them the physics is broken on purpose.
    pub effects: Effects,
    /// The thin disk.
    pub disk: Disk,
    /// What lies at infinity.
    pub sky: Sky,
    /// The foreground probe.
    pub probe: Probe,
    /// The way from light to pixels.
    pub picture: Picture,
    /// Accuracy against time.
    pub quality: Quality,
}

/// What the geodesic pass shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum View {
    /// The light itself; unfinished rays are black.
    #[default]
    Colour,
    /// The light itself, with unfinished rays in magenta.
    Unfinished,
    /// What becomes of each ray: outcome, and number of crossings of the disk.
    Classes,
    /// Largest residual of the null constraint along each ray.
    Residual,
    /// Order of the image: half-turns about the hole up to what is seen first.
    Order,
    /// Observed over emitted frequency of what is seen first, disk or sky.
    Redshift,
    /// Backward error against the reference, in pixels, on a coarse grid.
    Error,
}

impl View {
    /// Every view.
    pub const ALL: [Self; 7] = [
        Self::Colour,
        Self::Unfinished,
        Self::Classes,
        Self::Residual,
        Self::Order,
        Self::Redshift,
        Self::Error,
    ];
}

/// The black hole; its Schwarzschild radius is the unit of length.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Hole {
    /// chi = a/M, in (-1, 1); positive turns with the disk.
    pub spin: f64,
}

/// Where the camera is and where it looks. With yaw, pitch and roll zero it looks at the hole's
/// centre, with decreasing theta up and growing phi to the right.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Camera {
    /// Boyer-Lindquist radius.
    pub r: f64,
    /// Angle from the disk normal.
    pub theta_deg: f64,
    /// Azimuth; at and inside the horizon Kerr's ingoing one.
    pub phi_deg: f64,
    /// Vertical field of view.
    pub fov_deg: f64,
    /// Turn to the right, first.
    pub yaw_deg: f64,
    /// Turn upward, second.
    pub pitch_deg: f64,
    /// Turn clockwise about the line of sight, last.
    pub roll_deg: f64,
}

/// How the camera moves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Observer {
    /// Which frame of reference.
    pub kind: ObserverKind,
    /// One more boost, in that frame: outward, toward growing theta, toward growing phi; units of
    /// c.
    pub velocity: [f64; 3],
}

/// Which effects there are. Switching one off breaks the physics on purpose, to show what it does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Effects {
    /// Light is bent; without, rays are straight lines of flat space.
    pub lensing: bool,
    /// The motion of the matter and of the camera shifts light.
    pub doppler: bool,
    /// The shift g multiplies bolometric intensity by g^4; without, it changes colour only.
    pub beaming: bool,
    /// The potentials at the source and at the camera shift light.
    pub gravitational_shift: bool,
    /// The camera's motion displaces directions; without, they are those of an observer with zero
    /// angular momentum.
    pub aberration: bool,
}

/// The thin emitting disk in the equatorial plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Disk {
    /// Whether there is one.
    pub enabled: bool,
    /// Inner edge; where it lies inside the innermost stable circular orbit, that orbit is the
    /// edge.
    pub inner: f64,
    /// Whether the inner edge is the innermost stable circular orbit, whatever `inner` says.
    pub follow_isco: bool,
    /// Outer edge.
    pub outer: f64,
    /// Radial profile of the flux.
    pub model: DiskModel,
    /// Temperature scale: T = temperature_k F^(1/4).
    pub temperature_k: f64,
    /// Artistic HDR scale of the emission.
    pub brightness: f64,
    /// Width over which the emission fades in at each edge, as a fraction of the edge's radius.
    pub edge_taper: f64,
    /// Share of the light from behind that passes through the disk.
    pub transmission: f64,
}

/// Radial profile of the disk's flux.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DiskModel {
    /// F = (r_in/r)^3 (1 - sqrt(r_in/r)).
    #[default]
    Newtonian,
    /// Relativistic, around Kerr: Page & Thorne 1974, with the same peak.
    PageThorne,
}

/// What lies at infinity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Sky {
    /// What is drawn there.
    pub mode: SkyMode,
    /// Which stars.
    pub seed: u32,
    /// Scale of the sky's light.
    pub brightness: f64,
    /// Whether one bright reference star is added, in any mode but `off`.
    pub reference_star: bool,
    /// Its angle from the disk normal.
    pub reference_theta_deg: f64,
    /// Its azimuth.
    pub reference_phi_deg: f64,
}

/// What is drawn at infinity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SkyMode {
    /// Deterministic stars.
    #[default]
    Stars,
    /// A celestial grid.
    Grid,
    /// Nothing.
    Off,
}

/// A small craft, drawn by ordinary projection in front of the traced light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Probe {
    /// Whether there is one.
    pub enabled: bool,
    /// Where it hovers.
    pub r: f64,
    /// Angle from the disk normal.
    pub theta_deg: f64,
    /// Azimuth.
    pub phi_deg: f64,
    /// Length of its body.
    pub size: f64,
    /// Whether its edges are smoothed, by four samples a pixel.
    pub antialias: bool,
}

/// The way from light to pixels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Picture {
    /// Width of the HDR picture, in pixels.
    pub width: u32,
    /// Height of the HDR picture, in pixels.
    pub height: u32,
    /// Width of the presentation grid, in cells.
    pub grid_width: u32,
    /// Height of the presentation grid, in cells.
    pub grid_height: u32,
    /// Exposure, in powers of two.
    pub exposure_ev: f64,
    /// Strength of the bloom; zero leaves the pass out.
    pub bloom: f64,
    /// Number of levels a perceptual channel is rounded to.
    pub levels: u32,
    /// Whether the 4x4 Bayer pattern spreads the rounding error.
    pub dither: bool,
    /// Whether reduction, quantization and nearest expansion are left out.
    pub bypass: bool,
}

/// Accuracy against time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Quality {
    /// Largest error that a method with a setting for it may make, in pixels of the picture: the
    /// turn of a pixel's ray that would explain it.
    pub max_error_px: f64,
    /// Scale of the article's step rule; 1.55 cheap, 0.85 balanced, 0.45 high.
    pub step_scale: f64,
    /// Most steps a ray may take.
    pub max_steps: u32,
    /// Most affine length a ray may cover.
    pub max_affine: f64,
}
