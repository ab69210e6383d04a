// Finds the images of candidates in smooth cells without following rays: the sky in such a cell is
// the bicubic polynomial through the 16 points of the mesh about it.
//
// Two neighbouring cells have the same curve along their common side, because it depends on the points
// along that side alone. An image next to a side belongs to the cell on whose side of this curve it
// lies, so that one cell accepts it, however both have rounded its place.
//
// Needs: PI, SMOOTH, TINY, Tangents, WORKGROUP_SIZE, add_image, candidate_at, candidate_number,
//     components_across, limited, mesh, mesh_place, mesh_points, newton_step, pixel_solid_angle,
//     seen_direction, star_list, tangents_at.
// Gives: interpolate.

// Newton's method doubles its digits in each step: from a quarter of a cell, three reach f32's.
const STEPS: u32 = 4u;
// Within this distance of a side, in cells, the curve along it decides.
const NEAR_SIDE: f32 = 1e-3;
// Along a side the curve is replaced by its tangents at this many points.
const SIDE_GRID: f32 = 16.0;

// By how much the rays through a row of four points miss a star, across its direction: both components.
struct Row {
    first: vec4<f32>,
    second: vec4<f32>,
}

// Weights of the values at -1, 0, 1 and 2 in the cubic polynomial through them (Lagrange's formula).
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

// By how much the star is missed with these weights along x and along y.
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

// The left or the right side of the cell, as a row.
fn column_of(rows: array<Row, 4>, is_right: bool) -> Row {
    let left = Row(
        vec4<f32>(rows[0].first.y, rows[1].first.y, rows[2].first.y, rows[3].first.y),
        vec4<f32>(rows[0].second.y, rows[1].second.y, rows[2].second.y, rows[3].second.y),
    );
    let right = Row(
        vec4<f32>(rows[0].first.z, rows[1].first.z, rows[2].first.z, rows[3].first.z),
        vec4<f32>(rows[0].second.z, rows[1].second.z, rows[2].second.z, rows[3].second.z),
    );
    return Row(select(left.first, right.first, is_right), select(left.second, right.second, is_right));
}

// The cross product, as a number, of the direction of the curve at a place on it and of the star's
// miss there. Its sign tells on which side of the curve the star lies.
fn side_of_star(curve: Row, place: f32) -> f32 {
    let anchor = round(place * SIDE_GRID) / SIDE_GRID;
    let weights = cubic_weights(anchor);
    let slopes = cubic_slopes(anchor);
    return dot(slopes, curve.first) * dot(weights, curve.second) - dot(slopes, curve.second) * dot(weights, curve.first);
}

// Whether a place belongs to the cell. `orientation` is the sign of the Jacobian's determinant.
fn is_within(rows: array<Row, 4>, place: vec2<f32>, orientation: f32) -> bool {
    let is_far = place > vec2<f32>(0.5);
    let from_side = abs(place - select(vec2<f32>(0.0), vec2<f32>(1.0), is_far));
    let row = Row(
        select(rows[1].first, rows[2].first, is_far.y),
        select(rows[1].second, rows[2].second, is_far.y),
    );
    let is_right = orientation * side_of_star(column_of(rows, is_far.x), place.y) >= 0.0;
    let is_below = orientation * side_of_star(row, place.x) < 0.0;
    let x_within = select(place.x >= 0.0 && place.x < 1.0, is_right != is_far.x, from_side.x < NEAR_SIDE);
    let y_within = select(place.y >= 0.0 && place.y < 1.0, is_below != is_far.y, from_side.y < NEAR_SIDE);
    return x_within && y_within;
}

// The angle swept about the hole: it serves to count half-turns, so straight lines between the corners
// will do.
fn turn_at(number: vec2<u32>, place: vec2<f32>) -> f32 {
    let corner = number.y * mesh.points.x + number.x;
    let below = corner + mesh.points.x;
    let upper = mix(mesh_points[corner].turn, mesh_points[corner + 1u].turn, place.x);
    return mix(upper, mix(mesh_points[below].turn, mesh_points[below + 1u].turn, place.x), place.y);
}

// One invocation for each candidate.
@compute @workgroup_size(WORKGROUP_SIZE)
fn interpolate(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= candidate_number(SMOOTH) {
        return;
    }
    let candidate = candidate_at(SMOOTH, id.x);
    let number = candidate.cell;
    let star = candidate.star;
    let direction = star_list[star].direction;
    let tangents = tangents_at(direction);
    let rows = rows_about(number, direction, tangents);
    var place = vec2<f32>(0.5);
    for (var i = 0u; i < STEPS; i++) {
        let missed = missed_at(rows, cubic_weights(place.x), cubic_weights(place.y));
        place += limited(newton_step(jacobian_at(rows, place), missed), 1.0);
    }
    let along = jacobian_at(rows, place);
    let area = along[0].x * along[1].y - along[0].y * along[1].x;
    if is_within(rows, place, sign(area)) {
        let at = mesh_place(vec2<f32>(number) + place);
        let seen = mesh.spacing * mesh.spacing * pixel_solid_angle(at);
        let order = u32(max(turn_at(number, place), 0.0) / PI);
        add_image(star, order, seen_direction(at), seen / max(abs(area), TINY));
    }
}
