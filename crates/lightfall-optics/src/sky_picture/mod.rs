//! A picture of the whole sky from a file, as the sky mode `picture` shows it: read, checked, drawn
//! anew on a cube map, and given temperatures by which its light is shifted.

pub mod colour;
#[cfg(not(target_arch = "wasm32"))]
mod cube;
mod error;
#[cfg(not(target_arch = "wasm32"))]
mod exr_file;
#[cfg(not(target_arch = "wasm32"))]
mod jpeg;
#[cfg(not(target_arch = "wasm32"))]
mod panorama;
#[cfg(not(target_arch = "wasm32"))]
mod png_file;
#[cfg(not(target_arch = "wasm32"))]
mod radiance;
#[cfg(not(target_arch = "wasm32"))]
mod read;

pub use error::{SkyPictureError, SkyPictureFault};

use crate::cube_map::{face_and_place, face_column_row, layer_major, solid_angle};
use crate::stars::{galactic_from_celestial, hole_from_celestial};
use colour::{NEUTRAL_TEMPERATURE, shifted};
use glam::{DMat3, DVec3};
use half::f16;
use lightfall_model::scene::{Scene, SkyFrame, SkyMode};
use std::f64::consts::FRAC_PI_2;
use std::sync::{Arc, Mutex, PoisonError};

/// Maximum width of a picture that is read, in pixels: with 12 bytes a pixel it takes 1.6 GB until
/// its cube map is made.
pub const MAX_WIDTH: u32 = 16_384;

/// Minimum width of a picture that is read, in pixels.
pub const MIN_WIDTH: u32 = 8;

/// Maximum size of the file of a picture, in bytes.
pub const MAX_FILE_BYTES: u64 = 1 << 30;

/// Maximum number of pictures that are kept: one for each of two compared scenes.
const MAX_KEPT: usize = 2;

/// A picture of the whole sky as a cube map with all its levels.
///
/// A texel is [r, g, b, ln(T / 6500 K)] in half floats: linear light, and the temperature of the
/// thermal light that has the same ratio of red to blue. Seen with the frequency ratio g, it is the
/// light g^4 [`shifted`] (rgb, T, g).
#[derive(Debug)]
pub struct SkyPicture {
    /// The name of its file, without folders.
    pub name: String,
    /// The SHA-256 of the file, in hexadecimal digits.
    pub sha256: String,
    /// Width and height of the picture in the file, in pixels.
    pub size: [u32; 2],
    /// Texels along one side of a face of the finest level, a power of two.
    side: usize,
    /// The levels, 0 the finest, face by face in WebGPU's order.
    levels: Vec<Vec<[u16; 4]>>,
}

/// The pictures that are kept by their paths, the most recently used last.
static KEPT: Mutex<Vec<(String, Arc<SkyPicture>)>> = Mutex::new(Vec::new());

impl SkyPicture {
    /// The picture that the scene's sky shows; `None` in other modes of the sky. A picture that was
    /// read before is not read again.
    ///
    /// # Errors
    /// The scene names no file, or the file cannot be read or holds no picture of a whole sky.
    pub fn of(scene: &Scene) -> Result<Option<Arc<Self>>, SkyPictureError> {
        if scene.sky.mode != SkyMode::Picture {
            return Ok(None);
        }
        let path = &scene.sky.picture;
        if path.is_empty() {
            return Err(SkyPictureError::NoFile);
        }
        // Held while a file is read, so that no other thread reads it a second time.
        let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
        let picture = match kept.iter().position(|(known, _)| known == path) {
            Some(index) => kept.remove(index).1,
            None => {
                let read = read(path);
                let refused = |fault| SkyPictureError::Refused {
                    path: path.clone(),
                    fault,
                };
                Arc::new(read.map_err(refused)?)
            }
        };
        if kept.len() >= MAX_KEPT {
            kept.remove(0);
        }
        kept.push((path.clone(), Arc::clone(&picture)));
        Ok(Some(picture))
    }

    /// Texels along one side of a face of the finest level.
    pub fn side(&self) -> usize {
        self.side
    }

    /// Number of levels. The last one has one texel a face.
    pub fn level_count(&self) -> usize {
        self.levels.len()
    }

    /// Width of a texel of the finest level, in radians: a quarter turn over the texels of a face.
    pub fn texel_width(&self) -> f64 {
        FRAC_PI_2 / self.side as f64
    }

    /// All texels, face by face, and each face level by level: what a texture of the format
    /// `Rgba16Float` takes in the order `LayerMajor`.
    pub fn half_floats(&self) -> impl Iterator<Item = [u16; 4]> {
        layer_major(&self.levels).copied()
    }

    /// The light that comes from a direction on the picture's axes, seen with the frequency ratio
    /// `g`, without beaming: that of one texel of a level.
    ///
    /// # Panics
    /// There are [`SkyPicture::level_count`] levels.
    pub fn light(&self, direction: DVec3, g: f64, level: usize) -> DVec3 {
        let size = self.side >> level;
        let (face, u, v) = face_and_place(direction);
        let index = |place: f64| ((place * size as f64) as usize).min(size - 1);
        let texel = self.levels[level][(face * size + index(v)) * size + index(u)];
        let [red, green, blue, ln_ratio] = texel.map(number);
        let temperature = NEUTRAL_TEMPERATURE * ln_ratio.exp();
        shifted(DVec3::new(red, green, blue), temperature, g)
    }

    /// The mean light of the whole sky, unshifted.
    pub fn mean_light(&self) -> DVec3 {
        let (mut sum, mut all) = (DVec3::ZERO, 0.0);
        for (texel, light) in self.levels[0].iter().enumerate() {
            let (_, column, row) = face_column_row(self.side, texel);
            let weight = solid_angle(self.side, column, row);
            let [r, g, b, _] = light.map(number);
            sum += weight * DVec3::new(r, g, b);
            all += weight;
        }
        sum / all
    }

    /// The level whose faces have at most this number of texels a side.
    pub fn level_of_side(&self, side: usize) -> usize {
        (0..self.levels.len())
            .find(|level| self.side >> level <= side.max(1))
            .unwrap_or(self.levels.len() - 1)
    }
}

/// The matrix from the hole's frame to the axes of the scene's picture of the sky. It is no rotation
/// where the picture is seen from outside.
pub fn picture_from_hole(scene: &Scene) -> DMat3 {
    let sky = &scene.sky;
    let celestial = hole_from_celestial(sky.ra_deg, sky.dec_deg, sky.roll_deg).transpose();
    let frame = match sky.frame {
        SkyFrame::Equatorial => DMat3::IDENTITY,
        SkyFrame::Galactic => galactic_from_celestial(),
    };
    let side = if sky.mirror { -1.0 } else { 1.0 };
    DMat3::from_diagonal(DVec3::new(1.0, side, 1.0)) * frame * celestial
}

fn number(half: u16) -> f64 {
    f16::from_bits(half).to_f64()
}

#[cfg(not(target_arch = "wasm32"))]
fn read(path: &str) -> Result<SkyPicture, SkyPictureFault> {
    read::read(std::path::Path::new(path))
}

/// A page has no files of the visitor's.
#[cfg(target_arch = "wasm32")]
fn read(_: &str) -> Result<SkyPicture, SkyPictureFault> {
    Err(SkyPictureFault::InBrowser)
}
