// From the tone-mapped picture to the cells on the screen: area reduction, quantization with an
// ordered pattern, and expansion. The CPU fills `Presentation` (src/render/presentation.rs) and
// works out where the cells lie.

struct Presentation {
    // Size of the HDR picture, in pixels.
    picture: vec2<u32>,
    // Size of the presentation grid, in cells.
    grid: vec2<u32>,
    // Where the image lies on the output: offset and size, in output pixels.
    offset: vec2<f32>,
    extent: vec2<f32>,
    // Number of levels a perceptual channel is rounded to, and whether the pattern is on.
    levels: f32,
    dither: u32,
}

@group(0) @binding(0) var<uniform> presentation: Presentation;
@group(0) @binding(1) var source: texture_2d<f32>;
@group(0) @binding(2) var source_sampler: sampler;

// One cell averages at most this many picture pixels along each axis; Scene's limits keep within
// it.
const MAX_PIXELS_PER_CELL: u32 = 65u;

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}

// sRGB transfer function and its inverse (IEC 61966-2-1).
fn srgb_encode(linear: vec3<f32>) -> vec3<f32> {
    let c = clamp(linear, vec3<f32>(0.0), vec3<f32>(1.0));
    return select(1.055 * pow(c, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * c, c <= vec3<f32>(0.0031308));
}

fn srgb_decode(encoded: vec3<f32>) -> vec3<f32> {
    return select(pow((encoded + 0.055) / 1.055, vec3<f32>(2.4)), encoded / 12.92, encoded <= vec3<f32>(0.04045));
}

// Rank, 0 to 15, of a cell in the 4x4 Bayer pattern: the bits of x xor y and of y, interleaved from
// the lowest up.
fn bayer(cell: vec2<u32>) -> f32 {
    let p = cell & vec2<u32>(3u);
    let q = vec2<u32>(p.x ^ p.y, p.y);
    return f32(((q.x & 1u) << 3u) | ((q.y & 1u) << 2u) | (q.x & 2u) | ((q.y & 2u) >> 1u));
}

// Mean of the linear light that falls on a cell; a pixel that the cell covers in part counts by the
// part.
fn reduce(cell: vec2<u32>) -> vec3<f32> {
    let pixels_per_cell = vec2<f32>(presentation.picture) / vec2<f32>(presentation.grid);
    let low = vec2<f32>(cell) * pixels_per_cell;
    let high = min(low + pixels_per_cell, vec2<f32>(presentation.picture));
    let first = vec2<u32>(low);
    let last = min(vec2<u32>(ceil(high)), presentation.picture);
    var light = vec3<f32>(0.0);
    var area = 0.0;
    for (var j = 0u; j < MAX_PIXELS_PER_CELL; j++) {
        let y = first.y + j;
        if y >= last.y {
            break;
        }
        let height = min(high.y, f32(y + 1u)) - max(low.y, f32(y));
        for (var i = 0u; i < MAX_PIXELS_PER_CELL; i++) {
            let x = first.x + i;
            if x >= last.x {
                break;
            }
            let covered = max(height * (min(high.x, f32(x + 1u)) - max(low.x, f32(x))), 0.0);
            light += covered * textureLoad(source, vec2<u32>(x, y), 0).rgb;
            area += covered;
        }
    }
    return light / max(area, 1e-6);
}

// Rounds perceptual channel values to the levels; the pattern stands still, so that a still picture
// does.
fn quantize(linear: vec3<f32>, cell: vec2<u32>) -> vec3<f32> {
    let top = max(presentation.levels - 1.0, 1.0);
    let threshold = select(0.5, (bayer(cell) + 0.5) / 16.0, presentation.dither != 0u);
    let rounded = min(floor(srgb_encode(linear) * top + threshold), vec3<f32>(top)) / top;
    return srgb_decode(rounded);
}

@fragment
fn pixelate(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let cell = vec2<u32>(position.xy);
    return vec4<f32>(quantize(reduce(cell), cell), 1.0);
}

// Output pixel -> position in the image, 0 to 1; outside of it lie the bars.
fn place(position: vec4<f32>) -> vec2<f32> {
    return (position.xy - presentation.offset) / max(presentation.extent, vec2<f32>(1.0));
}

fn outside(uv: vec2<f32>) -> bool {
    return any(uv < vec2<f32>(0.0)) || any(uv >= vec2<f32>(1.0));
}

// Nearest expansion of the cells.
@fragment
fn expand(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let uv = place(position);
    if outside(uv) {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    let cell = min(vec2<u32>(uv * vec2<f32>(presentation.grid)), presentation.grid - vec2<u32>(1u));
    return vec4<f32>(textureLoad(source, cell, 0).rgb, 1.0);
}

// The tone-mapped picture itself, when the cells are bypassed.
@fragment
fn fit(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let uv = place(position);
    let colour = textureSampleLevel(source, source_sampler, clamp(uv, vec2<f32>(0.0), vec2<f32>(1.0)), 0.0).rgb;
    return vec4<f32>(select(colour, vec3<f32>(0.0), outside(uv)), 1.0);
}
