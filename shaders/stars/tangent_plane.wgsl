// The tangent plane of the sky at a star, and steps in the picture toward the star's image.
//
// Gives: Tangents, components_across, limited, newton_step, tangents_at.

// Two unit vectors perpendicular to a star's direction.
struct Tangents {
    first: vec3<f32>,
    second: vec3<f32>,
}

fn tangents_at(star: vec3<f32>) -> Tangents {
    let size = abs(star);
    let least = min(size.x, min(size.y, size.z));
    let axis = select(select(vec3<f32>(0.0, 0.0, 1.0), vec3<f32>(0.0, 1.0, 0.0), size.y == least), vec3<f32>(1.0, 0.0, 0.0), size.x == least);
    let first = safe_normalize(cross(star, axis));
    return Tangents(first, cross(star, first));
}

// The components of a small difference of directions in the tangent plane.
fn components_across(tangents: Tangents, difference: vec3<f32>) -> vec2<f32> {
    return vec2<f32>(dot(difference, tangents.first), dot(difference, tangents.second));
}

// The step that undoes `missed`, by the derivatives along x and y.
fn newton_step(jacobian: mat2x2<f32>, missed: vec2<f32>) -> vec2<f32> {
    let area = determinant(jacobian);
    let x = missed.y * jacobian[1].x - missed.x * jacobian[1].y;
    let y = missed.x * jacobian[0].y - missed.y * jacobian[0].x;
    return vec2<f32>(x, y) / select(area, TINY, abs(area) < TINY);
}

// A step of at most this length.
fn limited(step: vec2<f32>, longest: f32) -> vec2<f32> {
    return step * min(1.0, longest / max(length(step), TINY));
}
