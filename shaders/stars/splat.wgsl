// Adds the light of each image of a star to the squares about it, which are single pixels except in
// very large pictures.
//
// Gives: splat.

// Maximum width of an image in squares, for pictures of up to 8192 lines.
const MAX_WIDTH: u32 = 32u;

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
    let light = image_light(image);
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
            add_light(u32(at.y * size.x + at.x), light * (weight / (side * side * pixel_solid_angle(shown))));
        }
    }
}
