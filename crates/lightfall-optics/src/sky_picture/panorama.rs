//! A picture of the whole sky as a grid of longitudes and latitudes.

use super::SkyPictureFault;
use super::{MAX_WIDTH, MIN_WIDTH};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Rows that would be averaged over fewer pixels than this stay as they are.
const MIN_AVERAGED: f64 = 1.5;

/// Linear light, row by row from the north pole: the middle is at longitude 0, and longitudes grow
/// to the left.
pub(super) struct Panorama {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) light: Vec<[f32; 3]>,
}

/// Checks the size of a picture, before memory is taken for it.
///
/// # Errors
/// It is not twice as wide as high, too large or too small.
pub(super) fn check_size(width: u32, height: u32) -> Result<(), SkyPictureFault> {
    if u64::from(width) != 2 * u64::from(height) {
        return Err(SkyPictureFault::Shape { width, height });
    }
    if !(MIN_WIDTH..=MAX_WIDTH).contains(&width) {
        return Err(SkyPictureFault::Size { width, height });
    }
    Ok(())
}

/// The linear light of a level of sRGB (IEC 61966-2-1), both from 0 to 1.
pub(super) fn linear(level: f32) -> f32 {
    if level <= 0.040_45 {
        level / 12.92
    } else {
        ((level + 0.055) / 1.055).powf(2.4)
    }
}

impl Panorama {
    /// A picture of this size, which [`check_size`] has accepted.
    ///
    /// # Errors
    /// A channel of a pixel is no light.
    pub(super) fn new(
        [width, height]: [u32; 2],
        light: Vec<[f32; 3]>,
    ) -> Result<Self, SkyPictureFault> {
        let width = width as usize;
        let is_light = |channel: &f32| channel.is_finite() && *channel >= 0.0;
        let wrong = light.iter().position(|pixel| !pixel.iter().all(is_light));
        if let Some(at) = wrong {
            let value = light[at].into_iter().find(|channel| !is_light(channel));
            return Err(SkyPictureFault::NoLight {
                column: at % width,
                row: at / width,
                value: value.unwrap_or(f32::NAN),
            });
        }
        Ok(Self {
            width,
            height: height as usize,
            light,
        })
    }

    /// Averages each row over as many pixels as are as wide on the sky as a pixel at the equator, so
    /// that a few samples see all pixels next to a pole. The mean light of the row stays the same.
    pub(super) fn even_out_poles(&mut self) {
        let (width, height) = (self.width, self.height);
        let rows = self.light.par_chunks_exact_mut(width).enumerate();
        rows.for_each(|(row, light)| {
            let sine = (PI * (row as f64 + 0.5) / height as f64).sin();
            let length = (1.0 / sine).min(width as f64);
            if length >= MIN_AVERAGED {
                average_around(light, length);
            }
        });
    }

    /// The light in a direction on the picture's axes, linear between pixels.
    pub(super) fn sample(&self, direction: DVec3) -> [f32; 3] {
        let latitude = direction.z.atan2(direction.x.hypot(direction.y));
        let across = 0.5 - direction.y.atan2(direction.x) / TAU;
        let down = 0.5 - latitude / PI;
        let x = across * self.width as f64 - 0.5;
        let y = (down * self.height as f64 - 0.5).clamp(0.0, (self.height - 1) as f64);
        let (left, top) = (x.floor(), (y.floor() as usize).min(self.height - 2));
        let (right_share, lower_share) = ((x - left) as f32, (y - top as f64) as f32);
        // The columns go around.
        let column = |x: f64| (x as i64).rem_euclid(self.width as i64) as usize;
        let columns = [column(left), column(left + 1.0)];
        let [upper, lower] = [top, top + 1].map(|row| {
            let [a, b] = columns.map(|column| self.light[row * self.width + column]);
            mix(a, b, right_share)
        });
        mix(upper, lower, lower_share)
    }
}

fn mix(a: [f32; 3], b: [f32; 3], share: f32) -> [f32; 3] {
    std::array::from_fn(|i| a[i] + share * (b[i] - a[i]))
}

/// Replaces each pixel of a row, whose ends meet, by the mean of `length` pixels about it.
fn average_around(row: &mut [[f32; 3]], length: f64) {
    let width = row.len();
    // sums[i] is the sum of the first i pixels.
    let mut sums = vec![DVec3::ZERO; width + 1];
    for (i, pixel) in row.iter().enumerate() {
        sums[i + 1] = sums[i] + light(*pixel);
    }
    let own = row.to_vec();
    let sum_to = |x: f64| {
        let turns = (x / width as f64).floor();
        let within = x - turns * width as f64;
        let whole = (within as usize).min(width - 1);
        let part = within - whole as f64;
        turns * sums[width] + sums[whole] + part * light(own[whole])
    };
    for (i, pixel) in row.iter_mut().enumerate() {
        let middle = i as f64 + 0.5;
        let sum = sum_to(middle + 0.5 * length) - sum_to(middle - 0.5 * length);
        // The difference of two large sums may be below zero by their rounding.
        let mean = (sum / length).max(DVec3::ZERO);
        *pixel = mean.as_vec3().to_array();
    }
}

fn light([r, g, b]: [f32; 3]) -> DVec3 {
    DVec3::new(r.into(), g.into(), b.into())
}
