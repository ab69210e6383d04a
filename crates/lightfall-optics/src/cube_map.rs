//! Cube maps of the sky, with the faces and texels of WebGPU: +x, -x, +y, -y, +z, -z, each row by
//! row.

use glam::DVec3;
use std::array;

/// Number of faces.
pub const FACES: usize = 6;

/// The vector from the centre of the cube [-1, 1]^3 to the place (`u`, `v`) on a face. Both run
/// from 0 to 1 as texture coordinates do, v downward. The vector is not of unit length.
///
/// # Panics
/// There is no such face.
pub fn place(face: usize, u: f64, v: f64) -> DVec3 {
    let (s, t) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    match face {
        0 => DVec3::new(1.0, -t, -s),
        1 => DVec3::new(-1.0, -t, s),
        2 => DVec3::new(s, 1.0, t),
        3 => DVec3::new(s, -1.0, -t),
        4 => DVec3::new(s, -t, 1.0),
        5 => DVec3::new(-s, -t, -1.0),
        _ => panic!("a cube has six faces; face {face} does not exist"),
    }
}

/// Face, column and row of a texel by its number.
pub fn face_column_row(size: usize, texel: usize) -> (usize, usize, usize) {
    (texel / (size * size), texel % size, texel / size % size)
}

/// The solid angle in steradians of the texel in `column` and `row` of a face of `size` texels a
/// side. The part of a face between its middle and (x, y) has atan(x y / sqrt(x^2 + y^2 + 1)).
pub fn solid_angle(size: usize, column: usize, row: usize) -> f64 {
    let edge = |index: usize| 2.0 * index as f64 / size as f64 - 1.0;
    let corner = |x: f64, y: f64| (x * y).atan2((x * x + y * y + 1.0).sqrt());
    let (left, right) = (edge(column), edge(column + 1));
    let (top, bottom) = (edge(row), edge(row + 1));
    corner(right, bottom) - corner(left, bottom) - corner(right, top) + corner(left, top)
}

/// The face that a direction points to, and the place (`u`, `v`) there: the inverse of [`place`].
pub fn face_and_place(direction: DVec3) -> (usize, f64, f64) {
    let size = direction.abs();
    let DVec3 { x, y, z } = direction;
    let (face, along, s, t) = if size.x >= size.y && size.x >= size.z {
        let side = if x < 0.0 { -1.0 } else { 1.0 };
        (usize::from(x < 0.0), size.x, -side * z, -y)
    } else if size.y >= size.z {
        let side = if y < 0.0 { -1.0 } else { 1.0 };
        (2 + usize::from(y < 0.0), size.y, x, side * z)
    } else {
        let side = if z < 0.0 { -1.0 } else { 1.0 };
        (4 + usize::from(z < 0.0), size.z, side * x, -y)
    };
    (face, 0.5 * (s / along + 1.0), 0.5 * (t / along + 1.0))
}

/// All texels of the levels of a cube map, face by face, and each face level by level: the order
/// `LayerMajor` of textures.
pub(crate) fn layer_major<T>(levels: &[Vec<T>]) -> impl Iterator<Item = &T> {
    (0..FACES).flat_map(move |face| {
        levels.iter().flat_map(move |texels| {
            let of_face = texels.len() / FACES;
            &texels[face * of_face..(face + 1) * of_face]
        })
    })
}

/// The next coarser level of texels, `size` a side: means of 2x2, weighted with solid angles.
pub(crate) fn halved<const N: usize>(texels: &[[f32; N]], size: usize) -> Vec<[f32; N]> {
    let half = size / 2;
    let of_face = half * half;
    let mut coarser = vec![[0.0; N]; FACES * of_face];
    for texel in 0..of_face {
        let (_, column, row) = face_column_row(half, texel);
        let four = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(right, down)| {
            let (column, row) = (2 * column + right, 2 * row + down);
            (row * size + column, solid_angle(size, column, row))
        });
        let all: f64 = four.iter().map(|(_, weight)| weight).sum();
        for face in 0..FACES {
            coarser[face * of_face + texel] = array::from_fn(|i| {
                let light = |at: usize| f64::from(texels[face * size * size + at][i]);
                let sum: f64 = four.iter().map(|(at, weight)| weight * light(*at)).sum();
                (sum / all) as f32
            });
        }
    }
    coarser
}
