// Adds the light of each image of a star to the squares about it, which are single pixels except in
// very large pictures. Sums are whole numbers, so the order of additions does not matter.
//
// Gives: splat.

// Maximum width of an image in squares, for pictures of up to 8192 lines.
const MAX_WIDTH: u32 = 32u;
// Maximum light of an image on a square, in units: eight of them fit into a sum.
const MAX_UNITS: f32 = 536870912.0;

@group(0) @binding(BINDING_STAR_IMAGES) var<storage, read> star_images: array<StarImage>;
// As in add_image.wgsl; the last number counts the images.
@group(0) @binding(BINDING_STAR_COUNT) var<storage, read> image_count: vec4<u32>;
// Red, green and blue of each square, row by row.
@group(0) @binding(BINDING_STAR_SUMS) var<storage, read_write> star_sums: array<atomic<u32>>;

// The cubic B-spline, wider by the stretch: zero at twice the stretch from its middle.
fn profile(distance: f32, stretch: f32) -> f32 {
    let x = abs(distance) / stretch;
    let wide = max(2.0 - x, 0.0);
    let narrow = max(1.0 - x, 0.0);
    return wide * wide * wide - 4.0 * narrow * narrow * narrow;
}

// One invocation for each image.
@compute @workgroup_size(WORKGROUP_SIZE)
fn splat(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= min(image_count.w, min(stars.capacity, arrayLength(&star_images))) {
        return;
    }
    let image = star_images[id.x];
    if !is_positive(image.flux) {
        return;
    }
    let light = thermal_colour(image.temperature) * (image.flux * scene.sky.brightness * stars.unit);
    // From here on lengths are in squares.
    let side = f32(max(stars.sums_side, 1u));
    let place = project(image.direction) / side;
    let stretch = max(stars.stretch / side, 1.0);
    // The squares within the profile on each axis, and the sum of their weights, which normalises
    // them.
    let first = ceil(place - (2.0 * stretch + 0.5));
    let width = min(u32(ceil(4.0 * stretch)), MAX_WIDTH);
    var sums = vec2<f32>(0.0);
    for (var i = 0u; i < width; i++) {
        let offset = first + (f32(i) + 0.5) - place;
        sums += vec2<f32>(profile(offset.x, stretch), profile(offset.y, stretch));
    }
    let whole = 1.0 / max(sums.x * sums.y, 1e-30);
    // The squares of the part that is drawn. Places are those of the whole picture, so that every part
    // gets the light that the whole picture has there.
    let size = vec2<i32>(ceil(scene.picture.size / side));
    let corner = vec2<i32>(scene.picture.origin / max(stars.sums_side, 1u));
    for (var row = 0u; row < width; row++) {
        for (var column = 0u; column < width; column++) {
            let middle = first + vec2<f32>(f32(column), f32(row)) + 0.5;
            let shown = shown_place(middle * side);
            let at = vec2<i32>(floor(shown / side)) - corner;
            if any(at < vec2<i32>(0)) || any(at >= size) {
                continue;
            }
            let weight = profile(middle.x - place.x, stretch) * profile(middle.y - place.y, stretch) * whole;
            let share = light * (weight / (side * side * pixel_solid_angle(shown)));
            let units = select(vec3<f32>(0.0), min(share, vec3<f32>(MAX_UNITS)), are_positive(share));
            let index = 3u * u32(at.y * size.x + at.x);
            if index + 2u < arrayLength(&star_sums) {
                let rounded = vec3<u32>(units + 0.5);
                atomicAdd(&star_sums[index], rounded.x);
                atomicAdd(&star_sums[index + 1u], rounded.y);
                atomicAdd(&star_sums[index + 2u], rounded.z);
            }
        }
    }
}
