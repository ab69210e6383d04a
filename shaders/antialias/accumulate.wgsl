// ACCUMULATE: adds a frame to the sum of earlier frames, and writes the mean.
//
// Gives: accumulate.

struct Accumulation {
    // The number of the frame, from zero.
    frame: u32,
}

@group(0) @binding(BINDING_ACCUMULATION) var<uniform> accumulation: Accumulation;
@group(0) @binding(BINDING_ACCUMULATION_LIGHT) var light: texture_2d<f32>;
// The sum of earlier frames; undefined for the first frame.
@group(0) @binding(BINDING_ACCUMULATION_SUM) var before: texture_2d<f32>;

struct Sums {
    @location(0) mean: vec4<f32>,
    @location(1) sum: vec4<f32>,
}

@fragment
fn accumulate(@builtin(position) position: vec4<f32>) -> Sums {
    let at = vec2<u32>(position.xy);
    var sum = textureLoad(light, at, 0);
    if accumulation.frame > 0u {
        sum += textureLoad(before, at, 0);
    }
    return Sums(sum / f32(accumulation.frame + 1u), sum);
}
