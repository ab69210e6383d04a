//! From a picture of the sky to a cube map with all its levels.

use super::colour::{NEUTRAL_TEMPERATURE, temperature};
use super::panorama::Panorama;
use crate::cube_map::{FACES, halved, place};
use half::f16;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Maximum number of texels along one side of a face. With its levels such a map takes 268 MB.
const MAX_SIDE: usize = 2048;

/// Texels along one side of a face: a power of two, so that each level halves the one before, and at
/// least a quarter of the picture's columns, so that no detail is lost.
fn side_for(width: usize) -> usize {
    (width / 4).next_power_of_two().min(MAX_SIDE)
}

/// The levels of the cube map, 0 the finest, and the texels along a side of a face of that one. A
/// texel is the mean of the picture over its area. Each level is the mean of the finer one's light,
/// weighted with solid angles.
pub(super) fn levels(mut picture: Panorama) -> (usize, Vec<Vec<[u16; 4]>>) {
    picture.even_out_poles();
    let side = side_for(picture.width);
    // In the middle of a face a texel is 2 / side wide, and a pixel of the picture 2 pi / width.
    let pixels = picture.width as f64 / (PI * side as f64);
    let samples = pixels.ceil() as usize + 1;
    let mut light = vec![[0.0; 3]; FACES * side * side];
    let rows = light.par_chunks_exact_mut(side).enumerate();
    rows.for_each(|(row, texels)| {
        let (face, row) = (row / side, row % side);
        for (column, light) in texels.iter_mut().enumerate() {
            *light = mean(&picture, face, [column, row], (side, samples));
        }
    });
    drop(picture);
    let texels = |light: &[[f32; 3]]| -> Vec<[u16; 4]> {
        let light = light.par_iter().copied();
        light.map(texel).collect()
    };
    let mut levels = vec![texels(&light)];
    let mut size = side;
    while size > 1 {
        light = halved(&light, size);
        size /= 2;
        levels.push(texels(&light));
    }
    (side, levels)
}

/// The mean light of a texel, of `samples` times `samples` places in it.
fn mean(
    picture: &Panorama,
    face: usize,
    at: [usize; 2],
    (side, samples): (usize, usize),
) -> [f32; 3] {
    let mut sum = [0.0; 3];
    for i in 0..samples * samples {
        let [u, v] = [(at[0], i % samples), (at[1], i / samples)].map(|(texel, part)| {
            (texel as f64 + (part as f64 + 0.5) / samples as f64) / side as f64
        });
        let light = picture.sample(place(face, u, v));
        for (sum, channel) in sum.iter_mut().zip(light) {
            *sum += channel;
        }
    }
    sum.map(|channel| channel / (samples * samples) as f32)
}

/// A texel of these channels. Half floats end at 65 504.
fn texel(light: [f32; 3]) -> [u16; 4] {
    let ratio = temperature(light.map(f64::from)) / NEUTRAL_TEMPERATURE;
    let [r, g, b] = light.map(|channel| channel.min(f16::MAX.to_f32()));
    [r, g, b, ratio.ln() as f32].map(|channel| f16::from_f32(channel).to_bits())
}
