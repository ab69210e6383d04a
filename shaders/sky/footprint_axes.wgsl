// The ellipse that a footprint covers on the sky.
//
// Gives: Axes, footprint_axes.

// The longest footprint, in radians: at the edge of the shadow a pixel can contain the whole sky.
const MAX_FOOTPRINT: f32 = 1.0;

// The principal axes of a footprint: the longer one, and the lengths of both.
struct Axes {
    long: vec3<f32>,
    lengths: vec2<f32>,
}

// The longer axis is at the angle theta from `to_the_right`, where tan(2 theta) = 2
// right.down/(right.right - down.down).
fn footprint_axes(footprint: Footprint) -> Axes {
    let right = dot(footprint.to_the_right, footprint.to_the_right);
    let down = dot(footprint.downward, footprint.downward);
    let both = dot(footprint.to_the_right, footprint.downward);
    let middle = 0.5 * (right + down);
    let half_difference = 0.5 * (right - down);
    let spread = sqrt(half_difference * half_difference + both * both);
    let cos_double = clamp(half_difference / max(spread, TINY), -1.0, 1.0);
    let cosine = sqrt(0.5 + 0.5 * cos_double);
    let sine = select(1.0, -1.0, both < 0.0) * sqrt(0.5 - 0.5 * cos_double);
    let long = cosine * footprint.to_the_right + sine * footprint.downward;
    let lengths = sqrt(max(vec2<f32>(middle + spread, middle - spread), vec2<f32>(0.0)));
    let shrink = min(1.0, MAX_FOOTPRINT / max(lengths.x, TINY));
    return Axes(shrink * long, min(lengths, vec2<f32>(MAX_FOOTPRINT)));
}
