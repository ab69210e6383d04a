//! Where a direction lies on a cube map.

use glam::DVec3;

/// The face that a direction points to, and the place there: the inverse of [`place`](lightfall_core::optics::cube_map::place).
pub(crate) fn face_and_place(direction: DVec3) -> (usize, f64, f64) {
    let size = direction.abs();
    let DVec3 { x, y, z } = direction;
    let (face, along, s, t) = if size.x >= size.y && size.x >= size.z {
        if x >= 0.0 {
            (0, size.x, -z, -y)
        } else {
            (1, size.x, z, -y)
        }
    } else if size.y >= size.z {
        if y >= 0.0 {
            (2, size.y, x, z)
        } else {
            (3, size.y, x, -z)
        }
    } else if z >= 0.0 {
        (4, size.z, x, -y)
    } else {
        (5, size.z, -x, -y)
    };
    (face, 0.5 * (s / along + 1.0), 0.5 * (t / along + 1.0))
}

/// The number of the texel that a direction points to, in a cube map of `size` texels a side.
pub(crate) fn texel(size: usize, direction: DVec3) -> usize {
    let (face, u, v) = face_and_place(direction);
    let index = |place: f64| ((place * size as f64) as usize).min(size - 1);
    (face * size + index(v)) * size + index(u)
}
