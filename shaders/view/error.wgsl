// The view `error`: backward error against the f64 reference, in pixels of the picture, on a coarse
// grid that the CPU computes (crates/lightfall-core/src/accuracy/picture.rs). This shader traces
// nothing. The scale is logarithmic, from dark violet at 1e-4 pixel or less through green to bright
// yellow at 1 or more. Magenta: no rotation of the ray explains the answer. Black: nothing is seen.
// Grey: the error is not known yet.
//
// Needs: BINDING_ERROR_MAP, ERROR_COLUMNS, ERROR_ROWS, LOG10_2, MAGENTA, UNEXPLAINED, UNKNOWN,
//     UNSEEN, mark, scene.
// Gives: light_at.

@group(0) @binding(BINDING_ERROR_MAP) var<uniform> errors: array<vec4<f32>, ERROR_COLUMNS * ERROR_ROWS / 4u>;

// Linear sRGB of a colour in Oklab (Ottosson 2020), in which equal distances look equal.
fn from_oklab(lightness: f32, a: f32, b: f32) -> vec3<f32> {
    let l = lightness + 0.3963377774 * a + 0.2158037573 * b;
    let m = lightness - 0.1055613458 * a - 0.0638541728 * b;
    let s = lightness - 0.0894841775 * a - 1.2914855480 * b;
    let cones = vec3<f32>(l * l * l, m * m * m, s * s * s);
    return vec3<f32>(
        dot(vec3<f32>(4.0767416621, -3.3077115913, 0.2309699292), cones),
        dot(vec3<f32>(-1.2684380046, 2.6097574011, -0.3413193965), cones),
        dot(vec3<f32>(-0.0041960863, -0.7034186147, 1.7076147010), cones),
    );
}

// The colour at a position in 0..1. Lightness grows linearly, so that the scale can also be read
// without its hues.
fn scale_colour(position: f32) -> vec3<f32> {
    let t = position;
    return from_oklab(0.30 + 0.65 * t, 0.04 + t * (0.32 * t - 0.42), -0.13 + t * (0.09 + 0.22 * t));
}

fn light_at(place: vec2<f32>) -> vec4<f32> {
    let grid = vec2<f32>(f32(ERROR_COLUMNS), f32(ERROR_ROWS));
    let cell = vec2<u32>(clamp(place / scene.picture.size * grid, vec2<f32>(0.0), grid - 1.0));
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
    let position = 0.25 * LOG10_2 * log2(max(error, 1e-4)) + 1.0;
    return mark(scale_colour(clamp(position, 0.0, 1.0)));
}
