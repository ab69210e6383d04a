//! Vectors and frames in Minkowski's space.

use glam::{DMat3, DMat4, DVec3, DVec4, Vec4Swizzles};

/// The product of two vectors with components on an orthonormal frame, of signature -+++.
pub fn minkowski(p: DVec4, q: DVec4) -> f64 {
    p.yzw().dot(q.yzw()) - p.x * q.x
}

/// The components of a vector on an orthonormal frame, whose axes are the columns.
pub fn components(frame: &DMat4, p: DVec4) -> DVec4 {
    let [u, e1, e2, e3] = axes(frame);
    DVec4::new(
        -minkowski(u, p),
        minkowski(e1, p),
        minkowski(e2, p),
        minkowski(e3, p),
    )
}

/// The columns of a frame.
pub(super) fn axes(frame: &DMat4) -> [DVec4; 4] {
    [frame.x_axis, frame.y_axis, frame.z_axis, frame.w_axis]
}

/// The pure boost to a body with the spatial four-velocity `momentum` = gamma v: its columns are the
/// body's axes. Without cancellation at any speed.
pub fn boost(momentum: DVec3) -> DMat4 {
    let gamma = (1.0 + momentum.length_squared()).sqrt();
    let along = momentum / (gamma + 1.0);
    let axis = |i: usize| {
        let unit = DVec3::AXES[i];
        DVec4::from((momentum[i], unit + momentum[i] * along))
    };
    DMat4::from_cols(DVec4::from((gamma, momentum)), axis(0), axis(1), axis(2))
}

/// The frame with its axes made orthonormal again, the four-velocity first (Gram-Schmidt).
pub(super) fn orthonormal(frame: &DMat4) -> DMat4 {
    let mut axes = axes(frame);
    for i in 0..4 {
        let mut p = axes[i];
        for (j, &other) in axes.iter().enumerate().take(i) {
            let sign = if j == 0 { -1.0 } else { 1.0 };
            p -= sign * minkowski(p, other) * other;
        }
        axes[i] = p / minkowski(p, p).abs().sqrt();
    }
    let [u, e1, e2, e3] = axes;
    DMat4::from_cols(u, e1, e2, e3)
}

/// The frame boosted, without rotation, to the four-velocity `to`: p + ((u + w).p/(1 + gamma)) (u +
/// w) of its spatial axes, with gamma = -u.w.
pub(super) fn carried_to(frame: &DMat4, to: DVec4) -> DMat4 {
    let [u, e1, e2, e3] = axes(frame);
    let gamma = -minkowski(u, to);
    let carried = |e: DVec4| e + minkowski(to, e) / (1.0 + gamma) * (u + to);
    orthonormal(&DMat4::from_cols(to, carried(e1), carried(e2), carried(e3)))
}

/// A rotation as a transformation that leaves the four-velocity.
pub(super) fn spatial(rotation: DMat3) -> DMat4 {
    let column = |i: usize| DVec4::from((0.0, rotation.col(i)));
    DMat4::from_cols(DVec4::X, column(0), column(1), column(2))
}

/// How far the axes are from orthonormal ones, with the first along time and to the future.
pub(super) fn deviation(frame: &DMat4) -> f64 {
    let axes = axes(frame);
    let mut most = if axes[0].x > 0.0 { 0.0 } else { f64::INFINITY };
    for i in 0..4 {
        for j in 0..=i {
            let product = match (i, j) {
                (0, 0) => -1.0,
                (i, j) if i == j => 1.0,
                _ => 0.0,
            };
            most = f64::max(most, (minkowski(axes[i], axes[j]) - product).abs());
        }
    }
    // A component that is not a number makes no product a number.
    if frame.is_finite() { most } else { f64::NAN }
}

/// The largest component of the axes, which is at least one.
pub(super) fn largest(frame: &DMat4) -> f64 {
    largest_of(frame.to_cols_array())
}

/// The largest of some numbers without their signs.
pub(super) fn largest_of<const N: usize>(numbers: [f64; N]) -> f64 {
    numbers.into_iter().fold(0.0, |most, x| most.max(x.abs()))
}
