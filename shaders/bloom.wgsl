// BLOOM: blurs the picture's light. The base is the picture, or the means of squares of k x k pixels,
// where k is the larger of rows / 1080 and columns / 8192, rounded up. From the base, each level of a
// pyramid has half the rows of the one before; from the smallest level back up, each one is mixed
// into the one above. DEVELOP mixes the largest level into the picture.
//
// Gives: bloom_base, bloom_first, bloom_shrink, bloom_spread, over_all.

struct Bloom {
    // Size of the whole picture, and upper left corner of the part that is drawn, in pixels.
    // Where the columns go around, the corner may lie left of the picture.
    whole: vec2<u32>,
    origin: vec2<i32>,
    // Share of the base's width and height that the picture fills: its last squares may reach beyond.
    filled: vec2<f32>,
    // Side of the squares of pixels that are one texel of the base.
    square: u32,
}

@group(0) @binding(BINDING_BLOOM) var<uniform> bloom: Bloom;
// What a step reads: the picture, the base or a level.
@group(0) @binding(BINDING_BLOOM_SOURCE) var source: texture_2d<f32>;
@group(0) @binding(BINDING_BLOOM_SAMPLER) var smooth_sampler: sampler;

// Light that every pixel has at least, so that no level is black.
const MIN_LIGHT: f32 = 0.0001;

struct Place {
    @builtin(position) position: vec4<f32>,
    // The place on the target, from 0 to 1 to the right and downward.
    @location(0) across: vec2<f32>,
}

// A triangle that covers the whole target.
@vertex
fn over_all(@builtin(vertex_index) index: u32) -> Place {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return Place(vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0), vec2<f32>(corner.x, 1.0 - corner.y));
}

// A texel of the base: the mean of a square of pixels. The texel is that of the whole picture,
// whichever part of it is drawn.
@fragment
fn bloom_base(place: Place) -> @location(0) vec4<f32> {
    let first = vec2<u32>(place.position.xy) * bloom.square;
    let end = min(first + bloom.square, bloom.whole);
    var light = vec3<f32>(0.0);
    for (var y = first.y; y < end.y; y++) {
        for (var x = first.x; x < end.x; x++) {
            light += textureLoad(source, vec2<i32>(vec2<u32>(x, y)) - bloom.origin, 0).rgb;
        }
    }
    let size = vec2<f32>(end - first);
    return vec4<f32>(light / (size.x * size.y), 1.0);
}

// Thirteen samples about a place: its middle, the corners of the square one texel around it, and the
// corners and middles of the sides of the square two texels around it (Jimenez 2014, "Next Generation
// Post Processing in Call of Duty: Advanced Warfare").
struct Samples {
    middle: vec3<f32>,
    // Sums of the inner corners, and of the three outer samples at each outer corner.
    inner: vec3<f32>,
    outer: mat4x3<f32>,
}

fn texels_at(across: vec2<f32>, texels: vec2<f32>) -> vec3<f32> {
    let texel = 1.0 / vec2<f32>(textureDimensions(source));
    return textureSampleLevel(source, smooth_sampler, across + texels * texel, 0.0).rgb;
}

fn samples_at(across: vec2<f32>) -> Samples {
    let left = texels_at(across, vec2<f32>(-2.0, 0.0));
    let right = texels_at(across, vec2<f32>(2.0, 0.0));
    let above = texels_at(across, vec2<f32>(0.0, -2.0));
    let below = texels_at(across, vec2<f32>(0.0, 2.0));
    return Samples(
        texels_at(across, vec2<f32>(0.0)),
        texels_at(across, vec2<f32>(-1.0, -1.0)) + texels_at(across, vec2<f32>(1.0, -1.0))
            + texels_at(across, vec2<f32>(-1.0, 1.0)) + texels_at(across, vec2<f32>(1.0, 1.0)),
        mat4x3<f32>(
            texels_at(across, vec2<f32>(-2.0, -2.0)) + left + above,
            texels_at(across, vec2<f32>(2.0, -2.0)) + right + above,
            texels_at(across, vec2<f32>(-2.0, 2.0)) + left + below,
            texels_at(across, vec2<f32>(2.0, 2.0)) + right + below,
        ),
    );
}

// The five squares of four samples that the samples make: the inner one has half of the weight, and
// the four that meet in the middle an eighth each.
const INNER_WEIGHT: f32 = 0.5 / 4.0;
const OUTER_WEIGHT: f32 = 0.125 / 4.0;

// A square's light, reduced the more the brighter it is, so that a single bright pixel does not
// flicker when it moves (Karis 2013, "Tone Mapping").
fn reduced(light: vec3<f32>) -> vec3<f32> {
    return light / (1.0 + dot(light, vec3<f32>(0.2126, 0.7152, 0.0722)) / 4.0);
}

// The largest level, from the base.
@fragment
fn bloom_first(place: Place) -> @location(0) vec4<f32> {
    let seen = samples_at(place.across * bloom.filled);
    let light = reduced(seen.inner * INNER_WEIGHT)
        + reduced((seen.outer[0] + seen.middle) * OUTER_WEIGHT)
        + reduced((seen.outer[1] + seen.middle) * OUTER_WEIGHT)
        + reduced((seen.outer[2] + seen.middle) * OUTER_WEIGHT)
        + reduced((seen.outer[3] + seen.middle) * OUTER_WEIGHT);
    return vec4<f32>(max(light, vec3<f32>(MIN_LIGHT)), 1.0);
}

// A level from the one above.
@fragment
fn bloom_shrink(place: Place) -> @location(0) vec4<f32> {
    let seen = samples_at(place.across);
    let outer = seen.outer * vec4<f32>(1.0);
    return vec4<f32>(seen.inner * INNER_WEIGHT + (outer + 4.0 * seen.middle) * OUTER_WEIGHT, 1.0);
}

// What a level adds to the one above, which the pipeline mixes into it.
@fragment
fn bloom_spread(place: Place) -> @location(0) vec4<f32> {
    return vec4<f32>(bloom_blurred(source, smooth_sampler, place.across), 1.0);
}
