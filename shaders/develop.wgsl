// DEVELOP: from the picture's light to what a screen shows of it: bloom, exposure and the tone curve.
// The result is linear light from 0 to 1, with the alpha of the picture's shader.
//
// Gives: develop.

struct Development {
    // Size of the whole picture, and upper left corner of the part that is drawn, in pixels.
    // Where the columns go around, the corner may lie left of the picture.
    whole: vec2<u32>,
    origin: vec2<i32>,
    // The factor of light.
    exposure: f32,
    // Share of the light that bloom spreads.
    bloom: f32,
    // Middle and radius of the circle of a fisheye picture, in pixels of the whole picture. In other
    // projections the circle is larger than any picture.
    axis: vec2<f32>,
    radius: f32,
}

@group(0) @binding(BINDING_DEVELOPMENT) var<uniform> development: Development;
@group(0) @binding(BINDING_DEVELOPMENT_LIGHT) var light: texture_2d<f32>;
// The largest level of the bloom, over the whole picture.
@group(0) @binding(BINDING_DEVELOPMENT_BLOOM) var bloom: texture_2d<f32>;
@group(0) @binding(BINDING_DEVELOPMENT_SAMPLER) var bloom_sampler: sampler;

@fragment
fn develop(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = vec2<u32>(position.xy);
    let seen = textureLoad(light, pixel, 0);
    var shown = seen.rgb;
    if HAS_BLOOM {
        let place = vec2<f32>(vec2<i32>(pixel) + development.origin) + 0.5;
        let wide = bloom_blurred(bloom, bloom_sampler, place / vec2<f32>(development.whole));
        // At the edge of the circle, the light of the pixel itself already has this factor.
        let coverage = clamp(development.radius - distance(place, development.axis) + 0.5, 0.0, 1.0);
        shown = mix(shown, coverage * wide, development.bloom);
    }
    return vec4<f32>(toned(max(shown, vec3<f32>(0.0)) * development.exposure), seen.a);
}
