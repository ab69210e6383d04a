// The difference of two pictures of light, amplified. Both have the size of the HDR picture.
//
// Gives: difference.

struct Difference {
    // The factor of |left - right|.
    gain: f32,
}

// Below the largest half float.
const MAX_DIFFERENCE: f32 = 60000.0;

@group(0) @binding(BINDING_DIFFERENCE) var<uniform> settings: Difference;
@group(0) @binding(BINDING_DIFFERENCE_LEFT) var left: texture_2d<f32>;
@group(0) @binding(BINDING_DIFFERENCE_RIGHT) var right: texture_2d<f32>;

@fragment
fn difference(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = vec2<u32>(position.xy);
    let gap = abs(textureLoad(left, pixel, 0).rgb - textureLoad(right, pixel, 0).rgb);
    return vec4<f32>(min(settings.gain * gap, vec3<f32>(MAX_DIFFERENCE)), 1.0);
}
