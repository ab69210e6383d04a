// PRINT: the levels of a file, from the developed picture. PRINT and FIT give a pixel the same eight bits.
//
// Gives: print.

struct Print {
    // Upper left corner of the part of the picture that is drawn, in pixels of the whole picture. Where
    // the columns go around, the corner may lie left of the picture.
    origin: vec2<i32>,
    // The highest level.
    top: f32,
    // Whether the picture has bloom (1) or not (0).
    bloom: u32,
}

@group(0) @binding(BINDING_PRINT) var<uniform> printed: Print;
@group(0) @binding(BINDING_PRINT_SOURCE) var developed: texture_2d<f32>;

@fragment
fn print(@builtin(position) position: vec4<f32>) -> @location(0) vec4<u32> {
    let pixel = vec2<u32>(position.xy);
    let texel = textureLoad(developed, pixel, 0);
    // Alpha, zero in the shadow, removes the light that bloom has added there.
    let light = select(1.0, texel.a, printed.bloom != 0u) * texel.rgb;
    let place = vec2<f32>(vec2<i32>(pixel) + printed.origin) + 0.5;
    return vec4<u32>(vec3<u32>(to_levels(srgb_encode(light), printed.top, place)), u32(printed.top));
}
