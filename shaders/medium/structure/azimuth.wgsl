// The azimuth of a place on the way of a ray.
//
// Gives: turns_at.

// Azimuth in turns, where the ray has the state y.
fn turns_at(way: Way, share: f32, y: vec4<f32>) -> f32 {
    var angle = way.chi;
    if SPINNING {
        angle = add_angle(angle, azimuth_gain(way.motion, way.path, way.h, share, y.x, way.regular, way.ingoing));
        if way.ingoing {
            angle = add_angle(angle, azimuth_lag_to_infinity(way.motion, y.x));
        }
    }
    return (atan2_precise(y.w, y.z) + wrap_angle(angle)) * (0.5 / PI);
}
