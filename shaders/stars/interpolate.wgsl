// Finds the images of candidates in smooth cells without rays, by the bicubic polynomial through
// the 16 points of the mesh about the cell. Two neighbouring cells have the same curve along their
// common side, because it depends only on the points along that side. An image next to a side
// belongs to the cell on its side of this curve, so exactly one cell accepts it.
//
// Gives: interpolate.

// From a quarter of a cell, three steps of Newton's method reach f32's precision.
const STEPS: u32 = 4u;
// Distance from a side, in cells, within which the curve along it decides.
const NEAR_SIDE: f32 = 1e-3;
// Along a side, the curve is replaced by its tangents at this many points.
const SIDE_GRID: f32 = 16.0;

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

// The cross product of the curve's direction and the star's miss: its sign tells the star's side.
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

// The angle swept about the hole, linear between the corners: enough to count half-turns.
fn turn_at(number: vec2<u32>, place: vec2<f32>) -> f32 {
    let corner = number.y * mesh.points.x + number.x;
    let below = corner + mesh.points.x;
    let upper = mix(mesh_points[corner].turn, mesh_points[corner + 1u].turn, place.x);
    return mix(upper, mix(mesh_points[below].turn, mesh_points[below + 1u].turn, place.x), place.y);
}

// One invocation for each candidate.
@compute @workgroup_size(WORKGROUP_SIZE)
fn interpolate(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= candidate_count(SMOOTH) {
        return;
    }
    let candidate = candidate_at(SMOOTH, id.x);
    let number = candidate.cell;
    let star = candidate.star;
    let direction = star_list[star].direction;
    let tangents = tangents_at(direction);
    let rows = rows_about(number, direction, tangents);
    let place = interpolated_image(rows, STEPS).place;
    let along = jacobian_at(rows, place);
    let area = along[0].x * along[1].y - along[0].y * along[1].x;
    let at = mesh_place(vec2<f32>(number) + place);
    if is_within(rows, place, sign(area)) && all(shown_place(at) == at) {
        let seen = mesh.spacing * mesh.spacing * pixel_solid_angle(at);
        let order = u32(max(turn_at(number, place), 0.0) / PI);
        add_image(star, order, pixel_direction(at), seen / max(abs(area), TINY));
    }
}
