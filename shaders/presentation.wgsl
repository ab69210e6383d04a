// From the tone-mapped picture to the screen: as cells, by area reduction, quantization with an
// ordered dither, and expansion; or without cells, by scaling and rounding to 8 bits with noise.
// render/presentation.rs fills the uniform and decides where the picture lies on the output.
//
// Gives: expand, fit, pixelate.

struct Presentation {
    // Size of the HDR picture, in pixels.
    picture: vec2<u32>,
    // Size of the presentation grid, in cells. A scene's cell is at least one pixel of its picture;
    // a picture that is drawn coarser for a moment may have fewer pixels than cells.
    grid: vec2<u32>,
    // Offset and size of the image on the output, in output pixels.
    offset: vec2<f32>,
    extent: vec2<f32>,
    // Number of levels that a perceptual channel is rounded to, and whether the dither is on (1) or
    // off (0).
    levels: f32,
    dither: u32,
    // Whether the picture has bloom (1) or not (0).
    bloom: u32,
}

@group(0) @binding(BINDING_PRESENTATION) var<uniform> presentation: Presentation;
@group(0) @binding(BINDING_PRESENTATION_SOURCE) var source: texture_2d<f32>;

// Light of a pixel of the picture. Alpha, zero in the shadow, removes the light that bloom has added
// there.
fn light_of(pixel: vec2<u32>) -> vec3<f32> {
    let texel = textureLoad(source, pixel, 0);
    return select(1.0, texel.a, presentation.bloom != 0u) * texel.rgb;
}

// Rank, 0 to 15, of a cell in the 4x4 Bayer pattern: the bits of x xor y and of y, interleaved.
fn bayer(cell: vec2<u32>) -> f32 {
    let p = cell & vec2<u32>(3u);
    let q = vec2<u32>(p.x ^ p.y, p.y);
    return f32(((q.x & 1u) << 3u) | ((q.y & 1u) << 2u) | (q.x & 2u) | ((q.y & 2u) >> 1u));
}

// Mean of the linear light on a cell; pixels that it partly covers count by that part. The scene's
// limits keep the pixels of a cell within the bound of the loops.
fn cell_mean(cell: vec2<u32>) -> vec3<f32> {
    let pixels_per_cell = vec2<f32>(presentation.picture) / vec2<f32>(presentation.grid);
    let low = vec2<f32>(cell) * pixels_per_cell;
    let high = min(low + pixels_per_cell, vec2<f32>(presentation.picture));
    let first = vec2<u32>(low);
    let last = min(vec2<u32>(ceil(high)), presentation.picture);
    var light = vec3<f32>(0.0);
    var area = 0.0;
    for (var j = 0u; j < MAX_PIXELS_TOUCHED; j++) {
        let y = first.y + j;
        if y >= last.y {
            break;
        }
        let height = min(high.y, f32(y + 1u)) - max(low.y, f32(y));
        for (var i = 0u; i < MAX_PIXELS_TOUCHED; i++) {
            let x = first.x + i;
            if x >= last.x {
                break;
            }
            let covered = max(height * (min(high.x, f32(x + 1u)) - max(low.x, f32(x))), 0.0);
            light += covered * light_of(vec2<u32>(x, y));
            area += covered;
        }
    }
    return light / max(area, 1e-6);
}

// Light at a place of the picture, in pixels, by linear interpolation between pixels.
fn interpolated_light(place: vec2<f32>) -> vec3<f32> {
    let last = vec2<f32>(presentation.picture) - 1.0;
    let clamped = clamp(place - 0.5, vec2<f32>(0.0), last);
    let low = vec2<u32>(clamped);
    let high = min(low + vec2<u32>(1u), vec2<u32>(last));
    let share = clamped - vec2<f32>(low);
    let above = mix(light_of(low), light_of(vec2<u32>(high.x, low.y)), share.x);
    let below = mix(light_of(vec2<u32>(low.x, high.y)), light_of(high), share.x);
    return mix(above, below, share.y);
}

// The light of a cell: the mean of its pixels, or interpolated where there are fewer pixels than
// cells.
fn cell_light(cell: vec2<u32>) -> vec3<f32> {
    if any(presentation.picture < presentation.grid) {
        let middle = (vec2<f32>(cell) + 0.5) / vec2<f32>(presentation.grid);
        return interpolated_light(middle * vec2<f32>(presentation.picture));
    }
    return cell_mean(cell);
}

// Rounds perceptual channel values to the levels. The dither is the same in every frame. It fades
// below the first level above black, where it would turn a faint glow into a lattice of single
// cells.
fn quantize(linear: vec3<f32>, cell: vec2<u32>) -> vec3<f32> {
    let top = max(presentation.levels - 1.0, 1.0);
    let level = srgb_encode(linear) * top;
    let dithered = (bayer(cell) + 0.5) / 16.0;
    let share = select(vec3<f32>(0.0), min(level, vec3<f32>(1.0)), presentation.dither != 0u);
    let rounded = min(floor(level + mix(vec3<f32>(0.5), vec3<f32>(dithered), share)), vec3<f32>(top));
    return srgb_decode(rounded / top);
}

@fragment
fn pixelate(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let cell = vec2<u32>(position.xy);
    return vec4<f32>(quantize(cell_light(cell), cell), 1.0);
}

// Position of an output pixel in the image, 0 to 1 in each direction; the bars lie outside.
fn image_position(position: vec4<f32>) -> vec2<f32> {
    return (position.xy - presentation.offset) / max(presentation.extent, vec2<f32>(1.0));
}

fn is_outside(uv: vec2<f32>) -> bool {
    return any(uv < vec2<f32>(0.0)) || any(uv >= vec2<f32>(1.0));
}

// Enlarges the cells by the nearest one.
@fragment
fn expand(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let uv = image_position(position);
    if is_outside(uv) {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    let cell = min(vec2<u32>(uv * vec2<f32>(presentation.grid)), presentation.grid - vec2<u32>(1u));
    return vec4<f32>(textureLoad(source, cell, 0).rgb, 1.0);
}

// Scales the tone-mapped picture itself, if the cells are bypassed, or shows it pixel by pixel.
@fragment
fn fit(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let uv = image_position(position);
    if is_outside(uv) {
        return vec4<f32>(0.0, 0.0, 0.0, 1.0);
    }
    var light: vec3<f32>;
    if all(presentation.extent == vec2<f32>(presentation.picture)) {
        light = light_of(vec2<u32>(position.xy - presentation.offset));
    } else {
        light = interpolated_light(uv * vec2<f32>(presentation.picture));
    }
    return vec4<f32>(srgb_decode(to_levels(srgb_encode(light), 255.0, position.xy) / 255.0), 1.0);
}
