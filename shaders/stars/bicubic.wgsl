// The sky in a cell as the bicubic polynomial through the 16 points of the mesh about it.
//
// Gives: Row, cubic_slopes, cubic_weights, interpolated_image, jacobian_at, rows_about.

// The misses of a star by the rays through a row of four points: both components perpendicular to
// its direction.
struct Row {
    first: vec4<f32>,
    second: vec4<f32>,
}

// Weights of the values at -1, 0, 1 and 2 in the cubic polynomial through them (Lagrange's
// formula).
fn cubic_weights(x: f32) -> vec4<f32> {
    let offsets = vec4<f32>(x + 1.0, x, x - 1.0, x - 2.0);
    return offsets.yxxx * offsets.zzyy * offsets.wwwz * vec4<f32>(-1.0 / 6.0, 0.5, -0.5, 1.0 / 6.0);
}

// The derivatives of these weights.
fn cubic_slopes(x: f32) -> vec4<f32> {
    let offsets = vec4<f32>(x + 1.0, x, x - 1.0, x - 2.0);
    let pairs = offsets.zzyy * offsets.wwwz + offsets.yxxx * offsets.wwwz + offsets.yxxx * offsets.zzyy;
    return pairs * vec4<f32>(-1.0 / 6.0, 0.5, -0.5, 1.0 / 6.0);
}

fn row_of(start: u32, star: vec3<f32>, tangents: Tangents) -> Row {
    let points = array<vec2<f32>, 4>(
        components_across(tangents, mesh_points[start].sky - star),
        components_across(tangents, mesh_points[start + 1u].sky - star),
        components_across(tangents, mesh_points[start + 2u].sky - star),
        components_across(tangents, mesh_points[start + 3u].sky - star),
    );
    return Row(
        vec4<f32>(points[0].x, points[1].x, points[2].x, points[3].x),
        vec4<f32>(points[0].y, points[1].y, points[2].y, points[3].y),
    );
}

// The 16 points about a cell, from the upper left one.
fn rows_about(number: vec2<u32>, star: vec3<f32>, tangents: Tangents) -> array<Row, 4> {
    let columns = mesh.points.x;
    let start = (number.y - 1u) * columns + number.x - 1u;
    return array<Row, 4>(
        row_of(start, star, tangents),
        row_of(start + columns, star, tangents),
        row_of(start + 2u * columns, star, tangents),
        row_of(start + 3u * columns, star, tangents),
    );
}

// The miss of the star with these weights along x and along y.
fn missed_at(rows: array<Row, 4>, x: vec4<f32>, y: vec4<f32>) -> vec2<f32> {
    let first = y.x * rows[0].first + y.y * rows[1].first + y.z * rows[2].first + y.w * rows[3].first;
    let second = y.x * rows[0].second + y.y * rows[1].second + y.z * rows[2].second + y.w * rows[3].second;
    return vec2<f32>(dot(x, first), dot(x, second));
}

fn jacobian_at(rows: array<Row, 4>, place: vec2<f32>) -> mat2x2<f32> {
    return mat2x2<f32>(
        missed_at(rows, cubic_slopes(place.x), cubic_weights(place.y)),
        missed_at(rows, cubic_weights(place.x), cubic_slopes(place.y)),
    );
}

// One step of Newton's method toward the star's image.
fn next_place(rows: array<Row, 4>, place: vec2<f32>) -> vec2<f32> {
    let missed = missed_at(rows, cubic_weights(place.x), cubic_weights(place.y));
    return place + limited(newton_step(jacobian_at(rows, place), missed), 1.0);
}

// The interpolated place of a star's image, in cells from the cell's corner, and the length of the
// last step.
struct InterpolatedImage {
    place: vec2<f32>,
    last_step: f32,
}

// Newton's method from the middle of the cell.
fn interpolated_image(rows: array<Row, 4>, steps: u32) -> InterpolatedImage {
    var place = vec2<f32>(0.5);
    var last = place;
    for (var i = 0u; i < steps; i++) {
        last = place;
        place = next_place(rows, place);
    }
    return InterpolatedImage(place, distance(place, last));
}
