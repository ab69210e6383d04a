// The view `error`: backward error against the f64 reference, in pixels, on a coarse grid that
// accuracy/picture.rs computes. The scale is logarithmic, from dark violet at 1e-4 pixel or less
// through green to bright yellow at 1 or more. Magenta: no turn of the ray explains the answer.
// Black: nothing is seen. Grey: the error is not known yet.
//
// Gives: light_at.

@group(0) @binding(BINDING_ERROR_MAP) var<uniform> errors: array<vec4<f32>, ERROR_COLUMNS * ERROR_ROWS / 4u>;

fn light_at(place: vec2<f32>) -> vec4<f32> {
    let grid = vec2<f32>(f32(ERROR_COLUMNS), f32(ERROR_ROWS));
    let cell = vec2<u32>(clamp(place / scene.picture.whole * grid, vec2<f32>(0.0), grid - 1.0));
    let index = cell.y * ERROR_COLUMNS + cell.x;
    let error = errors[index / 4u][index % 4u];
    if error == UNKNOWN {
        return mark(vec3<f32>(0.05));
    }
    if error == UNSEEN {
        return mark(vec3<f32>(0.0));
    }
    if error >= UNEXPLAINED {
        return mark(MAGENTA);
    }
    return mark(error_colour(error));
}
