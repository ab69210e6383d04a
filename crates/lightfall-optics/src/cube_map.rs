//! Cube maps of the sky, with the faces and texels of WebGPU: +x, -x, +y, -y, +z, -z, each row by
//! row.

use glam::DVec3;

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
