// Adds the light of each image of a star to the squares about it, as splat.wgsl does, in projections
// that show a small circle of the sky as an ellipse: the profile is round on the sky.
//
// Gives: splat.

// The weight of an image at a place, for each steradian, when its profile has the width `scale` in
// radians.
fn weight_at(place: vec2<f32>, image: vec3<f32>, tangents: Tangents, scale: f32) -> f32 {
    let direction = pixel_direction(place);
    let across = components_across(tangents, direction - image);
    let weight = profile(across.x, scale) * profile(across.y, scale);
    return select(0.0, weight, is_on_sky(place) && dot(direction, image) > 0.0);
}

// One invocation for each image.
@compute @workgroup_size(WORKGROUP_SIZE)
fn splat(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= min(image_count.w, min(stars.capacity, arrayLength(&star_images))) {
        return;
    }
    let image = star_images[id.x];
    let stretch = max(stars.stretch, f32(stars.sums_side));
    if !is_positive(image.flux) || !is_in_view(image.direction, 2.0 * stretch) {
        return;
    }
    let light = image_light(image);
    let tangents = tangents_at(image.direction);
    let scale = stretch * sqrt(scene.picture.middle_solid_angle);
    // The squares about the image; from the middle of a diagonal to its corner is the root of two.
    let side = f32(max(stars.sums_side, 1u));
    let place_of_image = project(image.direction);
    let reach = image_reach(place_of_image, 2.83 * stretch) / side + 1.0;
    let middle = place_of_image / side;
    let all = ceil(scene.picture.whole / side);
    let first = floor(middle - reach);
    let count = vec2<u32>(clamp(ceil(2.0 * reach) + 1.0, vec2<f32>(1.0), all));
    var sum = 0.0;
    for (var row = 0u; row < count.y; row++) {
        for (var column = 0u; column < count.x; column++) {
            let place = (first + vec2<f32>(f32(column), f32(row)) + 0.5) * side;
            sum += weight_at(place, image.direction, tangents, scale) * pixel_solid_angle(place);
        }
    }
    let whole = 1.0 / max(sum * side * side, TINY);
    // The squares of the whole picture and of the part that is drawn, as in splat.wgsl.
    let squares = vec2<i32>(all);
    let size = vec2<i32>(ceil(scene.picture.size / side));
    let corner = vec2<i32>(scene.picture.origin / max(stars.sums_side, 1u));
    for (var row = 0u; row < count.y; row++) {
        for (var column = 0u; column < count.x; column++) {
            let place = (first + vec2<f32>(f32(column), f32(row)) + 0.5) * side;
            let shown = vec2<i32>(floor(shown_place(place) / side));
            if any(shown < vec2<i32>(0)) || any(shown >= squares) {
                continue;
            }
            let at = shown - corner;
            if at.y < 0 || at.y >= size.y {
                continue;
            }
            let share = light * (weight_at(place, image.direction, tangents, scale) * whole);
            // A part that goes around begins left of the first column, and may have a column twice.
            for (var x = select(at.x, at.x + squares.x, at.x < 0); x < size.x; x += squares.x) {
                add_light(u32(at.y * size.x + x), share);
            }
        }
    }
}
