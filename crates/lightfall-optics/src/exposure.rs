//! A light meter: chooses the exposure for the light that a scene's camera sees, with a few rays.
//!
//! The exposure makes the mean level of the screen over the disk a fixed one. Levels saturate at
//! white, so a small part of the disk that is a thousand times brighter leaves the rest visible.
//! The sky counts a little, so that the exposure changes smoothly when the disk leaves the picture.

use crate::limb::Limb;
use crate::lut::srgb;
use crate::medium::{Medium, Tolerance};
use crate::photometry::DISK_HDR_SCALE;
use crate::reference::Reference;
use crate::shift::Shift;
use crate::sky_picture::{SkyPicture, picture_from_hole};
use crate::trace::{Hit, Outcome};
use crate::{disk, spectrum};
use glam::{DVec2, DVec3};
use lightfall_model::geometry::bisection::bisection;
use lightfall_model::geometry::observer::{ObserverError, Photon};
use lightfall_model::scene::{Effects, Scene, SkyMode};

/// Rays with which the meter begins, and the most that it traces where they hardly meet the disk.
const RAYS: u32 = 320;
const MAX_RAYS: u32 = 2560;
/// Rays to the disk that give its mean level. Where a bright line is all of it, as deep inside the
/// hole, a few rays would give another level for every turn of the camera.
const ENOUGH_ON_DISK: f64 = 24.0;
/// How many directions are tried for each ray where a picture cuts off most of its circle.
const MAX_TRIES: u32 = 16;
/// The places of the rays in the picture are multiples of these numbers, less whole pictures: an
/// even distribution without rows and columns (Roberts 2018, "The Unreasonable Effectiveness of
/// Quasirandom Sequences"), so a moving edge passes the rays one by one.
const RAY_SPACING: DVec2 = DVec2::new(0.754_877_666_246_692_7, 0.569_840_290_998_053_3);
/// Mean level of the screen over the disk, from 0 for black to 1 for white.
const TARGET_LEVEL: f64 = 0.56;
/// Weight of a ray to the sky, where a ray to the disk has the weight one.
const SKY_WEIGHT: f64 = 0.02;
/// Temperature of the sky's light, in kelvin, and the exposure for a sky alone, unshifted.
const SKY_TEMPERATURE: f64 = 6500.0;
const SKY_EXPOSURE: f64 = 1.2;
/// A picture of the sky counts as it is, seen in patches of a few degrees, the 16 x 16 of a face. But
/// a dark one, such as a map of stars, counts as no darker than this share of the sky of other modes:
/// night stays night.
const PICTURE_SIDE: usize = 16;
const MIN_PICTURE_LIGHT: f64 = 0.25;
/// The exposures that the meter chooses. A longer one would turn the sky white.
const RANGE: [f64; 2] = [-12.0, 7.0];
/// Halvings of that range, and the fraction of a power of two to which the result is rounded.
const HALVINGS: u32 = 16;
const PARTS: f64 = 1000.0;

/// Nodes of a chunk of matter with depth, and how well its light is integrated: an exposure needs
/// no more. The matter counts as smooth, so that lumps that pass do not change the exposure.
const MEDIUM_NODES: usize = 4;
const MEDIUM_TOLERANCE: Tolerance = Tolerance {
    relative: 0.05,
    end_depth: 6.0,
};

/// The largest change of the exposure by effects that are switched off, in powers of two: no switch
/// turns the picture black or white.
const MAX_SWITCHED: f64 = 1.5;

/// Light that the meter sees.
struct Sample {
    weight: f64,
    /// The largest channel of the linear light.
    light: f64,
}

/// The scene with the exposure that its light meter chooses, if the scene has automatic exposure
/// and the meter sees any light; else the scene as it is.
pub fn exposed(scene: &Scene) -> Scene {
    let mut exposed = scene.clone();
    if scene.picture.automatic_exposure
        && let Ok(Some(metered)) = metered_exposure(scene)
    {
        exposed.picture.exposure_ev = metered;
    }
    exposed
}

/// The exposure, in powers of two, for the light that the scene's camera sees, with the scene's
/// bias. Effects that are switched off count as on, so that a switch shows what it changes; this
/// moves the exposure by no more than 1.5 powers of two. `None` if the meter sees no light, and in
/// views whose colours do not depend on the exposure.
///
/// # Errors
/// If the scene's observer cannot exist.
pub fn metered_exposure(scene: &Scene) -> Result<Option<f64>, ObserverError> {
    biased(scene, MAX_RAYS)
}

/// As [`metered_exposure`], with few rays in every scene: for one that moves.
///
/// # Errors
/// As [`metered_exposure`].
pub fn roughly_metered_exposure(scene: &Scene) -> Result<Option<f64>, ObserverError> {
    biased(scene, RAYS)
}

fn biased(scene: &Scene, max_rays: u32) -> Result<Option<f64>, ObserverError> {
    let metered = meter(scene, max_rays)?;
    Ok(metered.map(|exposure| exposure + scene.picture.exposure_bias))
}

/// The exposure without the scene's bias.
fn meter(scene: &Scene, max_rays: u32) -> Result<Option<f64>, ObserverError> {
    let own = measure(scene, max_rays)?;
    if scene.effects == Effects::default() {
        return Ok(own);
    }
    let with_effects = Scene {
        effects: Effects::default(),
        ..scene.clone()
    };
    let with_effects = measure(&with_effects, max_rays);
    let switched = |(own, whole): (f64, f64)| whole.clamp(own - MAX_SWITCHED, own + MAX_SWITCHED);
    Ok(own.zip(with_effects?).map(switched).or(own))
}

fn measure(scene: &Scene, max_rays: u32) -> Result<Option<f64>, ObserverError> {
    if !scene.view.shows_light() {
        return Ok(None);
    }
    let samples = samples(scene, max_rays)?;
    let weight: f64 = samples.iter().map(|sample| sample.weight).sum();
    if samples
        .iter()
        .all(|sample| sample.weight * sample.light <= 0.0)
    {
        return Ok(None);
    }
    let curve = scene.picture.tone_curve;
    let mean_level = |exposure: f64| {
        let scale = exposure.exp2();
        let levels = samples
            .iter()
            .map(|sample| sample.weight * srgb(curve.level(scale * sample.light)));
        levels.sum::<f64>() / weight
    };
    let is_dark = |exposure: f64| mean_level(exposure) < TARGET_LEVEL;
    let [low, high] = bisection(RANGE, HALVINGS, is_dark);
    Ok(Some((0.5 * (low + high) * PARTS).round() / PARTS))
}

/// What the meter's rays see.
fn samples(scene: &Scene, max_rays: u32) -> Result<Vec<Sample>, ObserverError> {
    let reference = Reference::new(scene)?;
    let (profile, shift) = (disk::Profile::new(scene), Shift::new(scene));
    let lit = disk::lit(scene);
    let axes = scene.camera.tetrad_from_camera();
    let size = scene.picture.size().as_dvec2();
    // Light of an unshifted sky that alone would give SKY_EXPOSURE.
    let sky_light = linear(TARGET_LEVEL) / SKY_EXPOSURE.exp2() * scene.sky.brightness;
    // A scene that can be drawn has its picture.
    let picture = SkyPicture::of(scene).ok().flatten();
    let picture_axes = picture_from_hole(scene);
    let limb = Limb::new(scene);
    let medium = Medium::smooth(scene, MEDIUM_NODES);
    let disk_light = |photon: &Photon, hit: Hit| {
        let flux = profile.flux(hit.r);
        let seen = spectrum::colour(hit.g * disk::temperature(&lit, flux));
        let limb = limb.factor(photon, hit.r);
        let scale = flux * shift.beaming_factor(hit.g) * limb * lit.brightness * DISK_HDR_SCALE;
        DVec3::from(seen) * scale * disk::cover(scene, hit.r)
    };
    let mut samples = Vec::new();
    let mut add = |weight: f64, light: f64| {
        if weight > 0.0 && light.is_finite() {
            let light = light.max(0.0);
            samples.push(Sample { weight, light });
        }
    };
    let mut on_disk = 0.0;
    let shown = (0..MAX_TRIES * max_rays).filter_map(|i| {
        let share = (0.5 + f64::from(i) * RAY_SPACING).fract();
        scene.camera.spread(share, size)
    });
    for (looking, i) in shown.zip(0..max_rays) {
        let shines = scene.disk.enabled || scene.jet.enabled;
        let enough = !shines || on_disk >= ENOUGH_ON_DISK;
        if i >= RAYS && enough {
            break;
        }
        let direction = axes * looking;
        let trace = reference.trace(direction);
        let photon = reference.photon(direction.normalize());
        let (mut light, mut transmission, mut uncovered) = (DVec3::ZERO, 1.0, 1.0);
        if let Some(medium) = &medium {
            let passage = medium.seen(&photon, MEDIUM_TOLERANCE);
            (light, uncovered) = (passage.light, (-passage.depth).exp());
        } else {
            for hit in trace.hits.into_iter().flatten() {
                light += transmission * disk_light(&photon, hit);
                transmission *= disk::transmission(scene, hit.r);
                uncovered *= 1.0 - disk::cover(scene, hit.r);
            }
        }
        let covered = if !scene.disk.enabled && light.max_element() > 0.0 {
            // Nothing but jets shines, and they hide little.
            1.0
        } else {
            1.0 - uncovered
        };
        on_disk += covered;
        // Per covered share, so that a ray at the disk's edge sees the light next to the edge.
        add(covered, light.max_element() / covered.max(1e-9));
        if trace.outcome == Outcome::Sky && scene.sky.mode != SkyMode::Off {
            let (r, n) = reference.camera();
            let lambda = r * n.cross(photon.w).z / photon.energy;
            let g = shift.of_sky(1.0 / photon.energy, lambda).abs();
            let seen = DVec3::from(spectrum::colour(g * SKY_TEMPERATURE)).max_element();
            let mut light = sky_light * seen;
            if let (Some(picture), Some(direction)) = (&picture, trace.sky) {
                let level = picture.level_of_side(PICTURE_SIDE);
                let own = picture.light(picture_axes * direction, g, level);
                light = (scene.sky.brightness * own.max_element()).max(MIN_PICTURE_LIGHT * light);
            }
            light *= shift.beaming_factor(g);
            add(SKY_WEIGHT * uncovered, light);
        }
    }
    Ok(samples)
}

/// The linear level of sRGB's level.
fn linear(level: f64) -> f64 {
    ((level + 0.055) / 1.055).powf(2.4)
}
