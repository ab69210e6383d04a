//! The images of stars on the GPU: against their twin in f64, and the light that they add to the
//! picture.

mod images;
pub(crate) mod light;
mod magnification;
mod many;
mod mesh;
pub(crate) mod run;

use crate::gpu;
use glam::{DMat3, DVec2, DVec3, Vec3};
use lightfall_core::gpu::stars::{GpuStarImage, PackedStars};
use lightfall_core::optics::disk;
use lightfall_core::optics::reference::Reference;
use lightfall_core::optics::spectrum::{TABLE_MAX_TEMPERATURE, TABLE_MIN_TEMPERATURE};
use lightfall_core::optics::stars::images::{Inversion, StarImage};
use lightfall_core::optics::stars::{
    Catalogue, Depth, Star, ZERO_MAGNITUDE_FLUX, hole_from_celestial, luminance,
};
use lightfall_core::scene::{Scene, presets};
use run::{StarLight, StarRun};
use std::collections::HashMap;

/// The limit of the catalogue.
const LIMIT: f64 = 6.5;

const DEPTH: Depth = Depth {
    limit: LIMIT,
    last: f64::INFINITY,
};

/// The catalogue's stars, and how they lie about the hole in most of these tests.
fn bright_stars() -> (PackedStars, DMat3) {
    let list = PackedStars::new(Catalogue::built_in().stars());
    (list, hole_from_celestial(83.0, 5.0, 20.0))
}

/// The preset around a hole without spin.
fn preset(number: usize) -> Scene {
    let mut scene = presets::PRESETS[number - 1].plain_scene().clone();
    scene.hole.spin = 0.0;
    scene
}

/// A star of magnitude 0.
pub(crate) fn star_at(direction: DVec3) -> Star {
    Star {
        direction: direction.normalize().as_vec3(),
        magnitude: 0.0,
        temperature: 6500.0,
    }
}

/// A star of the list, with the rounding of its packed form.
pub(crate) struct UnpackedStar {
    /// Its unit direction.
    pub(crate) direction: Vec3,
    /// Its luminous flux at its own temperature: linear light times steradians.
    pub(crate) luminous_flux: f64,
    /// Its temperature in kelvin.
    pub(crate) temperature: f64,
}

/// A star of the list. Its last word holds the upper 18 bits of an f32, of whose exponents the least
/// is that of 2^-40, and 14 bits of the logarithm of its temperature.
pub(crate) fn star_of(list: &PackedStars, index: u32) -> UnpackedStar {
    let (words, _) = list.bytes().as_chunks::<4>();
    let word = |i: usize| u32::from_le_bytes(words[4 * index as usize + i]);
    let flux = (word(3) >> 14) + (87 << 12);
    let share = f64::from(word(3) & 0x3fff) / f64::from(0x3fff);
    let range: f64 = TABLE_MAX_TEMPERATURE / TABLE_MIN_TEMPERATURE;
    UnpackedStar {
        direction: Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(word(i)))),
        luminous_flux: f64::from(f32::from_bits(flux << 11)),
        temperature: TABLE_MIN_TEMPERATURE * range.powf(share),
    }
}

fn star_light(scene: &Scene) -> StarLight {
    let (list, turn) = bright_stars();
    StarRun::new(gpu(), scene, &list, turn, DEPTH).run()
}

/// An image in f64: its place in pixels, its luminous flux and its flux without the disk, its flux
/// behind it, and its temperature.
struct Truth {
    place: DVec2,
    luminous: f64,
    unhidden: f64,
    flux: f64,
    temperature: f64,
}

/// The images of the list's stars within the picture, by star and order.
fn truths(scene: &Scene, list: &PackedStars, turn: DMat3) -> HashMap<(u32, u32), Truth> {
    let inversion = Inversion::new(scene).unwrap();
    let reference = Reference::new(scene).unwrap();
    let size = scene.picture.size().as_dvec2();
    let camera_from_tetrad = scene.camera.tetrad_from_camera().transpose();
    let mut truths = HashMap::new();
    for number in 0..list.len() {
        let star = star_of(list, number);
        let direction = (turn * star.direction.as_dvec3()).normalize();
        for image in inversion.images(direction) {
            let StarImage {
                direction,
                order,
                shift,
                gain,
                ..
            } = image;
            let looking = camera_from_tetrad * direction;
            let Some(place) = scene.camera.pixel_of(looking, size) else {
                continue;
            };
            let luminous = star.luminous_flux * gain;
            let beside = (place - 0.5 * size).abs() - 0.5 * size;
            if beside.max_element() > 2.0 || luminous < 0.9 * limit_flux() {
                continue;
            }
            let passed: f64 = reference
                .trace(direction)
                .hits
                .iter()
                .flatten()
                .map(|hit| disk::transmission(scene, hit.r))
                .product();
            truths.insert(
                (number, order),
                Truth {
                    place,
                    luminous,
                    unhidden: luminous / luminance(star.temperature),
                    flux: luminous / luminance(star.temperature) * passed,
                    temperature: star.temperature * shift,
                },
            );
        }
    }
    truths
}

fn limit_flux() -> f64 {
    ZERO_MAGNITUDE_FLUX * 10_f64.powf(-0.4 * LIMIT)
}

fn place_of(scene: &Scene, image: &GpuStarImage) -> DVec2 {
    let size = scene.picture.size().as_dvec2();
    let direction = image.direction.as_dvec3();
    scene
        .camera
        .pixel_of(direction, size)
        .unwrap_or_else(|| panic!("{image:?}"))
}
