// Finds the image of each rough candidate by rays: Broyden's method from the cell's linear map
// (Broyden 1965, "A class of methods for solving nonlinear simultaneous equations"), then five rays
// for the last step and the magnification.
//
// Only the cell that contains an image accepts it. Two cells that find the same image next to their
// common side must agree in spite of rounding: the last step begins at the nearest point of a grid,
// and its rays depend on nothing else. Along the sides of cells its points are farther apart, so
// that rounding seldom decides which one is nearest.
//
// Gives: refine_image.

// Maximum number of rays from one start, before the last five.
const MAX_RAYS: u32 = 10u;
const LAST_RAYS: u32 = 5u;
// Lengths in cells: the longest step; the step at which a search has converged, and at which it is
// accepted after MAX_RAYS; the longest last step; and the smallest distance between two images of a
// star in a cell.
const LONGEST_STEP: f32 = 2.0;
const CLOSE: f32 = 5e-4;
const LEAST_CLOSE: f32 = 0.05;
const LONGEST_LAST_STEP: f32 = 0.05;
const APART: f32 = 0.03;
// Distance to which a search may leave its cell where the map folds.
const FOLD_PATIENCE: f32 = 3.0;
// Points of the grid along the side of a cell, and for images less than NEAR_SIDE from a side.
const GRID: f32 = 4096.0;
const SIDE_GRID: f32 = 16.0;
const NEAR_SIDE: f32 = 1e-3;
// A miss, in radians, at which a search has converged in any case.
const ROUNDING: f32 = 3e-7;
// The smallest width on the sky, in radians, of the area between the rays about an image: rounding
// hides a smaller one. It limits the magnification next to a caustic to some thousands.
const MIN_WIDTH: f32 = 4e-7;

// A search for an image from one start. Places are in cells of the mesh.
struct Search {
    // The place of the next ray, and of the last ray that reached the sky.
    place: vec2<f32>,
    last: vec2<f32>,
    // The miss of the star by that last ray.
    missed: vec2<f32>,
    // The derivatives of `missed` along x and y.
    jacobian: mat2x2<f32>,
    rays: u32,
    state: u32,
}

const SEARCHING: u32 = 0u;
const FOUND: u32 = 1u;
const FAILED: u32 = 2u;

// A search that starts at the interpolated place.
fn search_from_mesh(number: vec2<u32>, star: vec3<f32>, tangents: Tangents) -> Search {
    let rows = rows_about(number, star, tangents);
    let local = interpolated_image(rows, INTERPOLATION_STEPS).place;
    let place = vec2<f32>(number) + local;
    return Search(place, place, vec2<f32>(0.0), jacobian_at(rows, local), 0u, SEARCHING);
}

fn search_from(start: u32, cell: Cell, number: vec2<u32>, star: vec3<f32>, tangents: Tangents) -> Search {
    if (1u << start) == FROM_MESH {
        return search_from_mesh(number, star, tangents);
    }
    var triangles = triangles_of(cell);
    let triangle = triangles[start & 1u];
    let along_x = components_across(tangents, triangle.along_x);
    let along_y = components_across(tangents, triangle.along_y);
    let jacobian = mat2x2<f32>(along_x, along_y);
    // Within the cell: where the map folds, a triangle does not tell how far outside a star is.
    let by_triangle = newton_step(jacobian, components_across(tangents, triangle.origin - star));
    let local = select(vec2<f32>(0.5), clamp(by_triangle, vec2<f32>(0.0), vec2<f32>(1.0)), start < 2u);
    let place = vec2<f32>(number) + local;
    return Search(place, place, vec2<f32>(0.0), jacobian, 0u, SEARCHING);
}

// The distance of a place from a cell, along the axis on which it is farther.
fn distance_outside(place: vec2<f32>, number: vec2<u32>) -> f32 {
    let off = abs(place - vec2<f32>(number) - 0.5) - 0.5;
    return max(0.0, max(off.x, off.y));
}

// Takes the result of the ray through `place`, and chooses the next one. The search fails when the
// image is farther outside the cell than twice the step and `patience`, in cells.
fn continue_search(
    search: ptr<function, Search>,
    number: vec2<u32>,
    patience: f32,
    sees_sky: bool,
    missed: vec2<f32>,
) {
    let is_first = (*search).rays == 0u;
    (*search).rays += 1u;
    let done = (*search).rays >= MAX_RAYS;
    if !sees_sky {
        // Back toward the sky.
        (*search).place = 0.5 * ((*search).place + (*search).last);
        (*search).state = select(SEARCHING, FAILED, is_first || done);
        return;
    }
    if !is_first {
        let taken = (*search).place - (*search).last;
        let unexplained = (missed - (*search).missed - (*search).jacobian * taken) / max(dot(taken, taken), TINY);
        (*search).jacobian += mat2x2<f32>(unexplained * taken.x, unexplained * taken.y);
    }
    (*search).last = (*search).place;
    (*search).missed = missed;
    let step = limited(newton_step((*search).jacobian, missed), LONGEST_STEP);
    (*search).place += step;
    let size = length(step);
    let close = size < CLOSE || length(missed) < ROUNDING || done && size < LEAST_CLOSE;
    // Other cells find images that are clearly outside of this one.
    let elsewhere = distance_outside((*search).place, number) > select(max(2.0 * size, patience), 2.0 * size, close) + CLOSE;
    (*search).state = select(select(SEARCHING, FOUND, close), FAILED, elsewhere || done && !close || !is_below(size, 1e6));
}

// The rays about an image: one through the middle, and those on each side that reach the sky.
struct Cross {
    middle: vec2<f32>,
    // The result and the direction of the ray through the middle.
    missed: vec2<f32>,
    turn: f32,
    sky: vec3<f32>,
    looking: vec3<f32>,
    // The changes of the sky and of the looking direction from left to right and from top to
    // bottom, and the distances, in cells.
    sky_x: vec3<f32>,
    sky_y: vec3<f32>,
    looking_x: vec3<f32>,
    looking_y: vec3<f32>,
    lengths: vec2<f32>,
}

fn cross_about(middle: vec2<f32>) -> Cross {
    let zero = vec3<f32>(0.0);
    return Cross(middle, vec2<f32>(0.0), 0.0, zero, zero, zero, zero, zero, zero, vec2<f32>(0.0));
}

// The point of the grid from which the last step begins.
fn anchor_of(place: vec2<f32>) -> vec2<f32> {
    let from_side = abs(place - round(place));
    let grid = select(GRID, SIDE_GRID, min(from_side.x, from_side.y) < NEAR_SIDE);
    return round(place * grid) / grid;
}

// Adds the image that a cross has measured, if the cell contains it.
fn add_found(measured: Cross, number: vec2<u32>, star: u32, tangents: Tangents) {
    let lengths = measured.lengths;
    if !(is_positive(lengths.x) && is_positive(lengths.y)) {
        return;
    }
    let along_x = components_across(tangents, measured.sky_x) / lengths.x;
    let along_y = components_across(tangents, measured.sky_y) / lengths.y;
    let step = limited(newton_step(mat2x2<f32>(along_x, along_y), measured.missed), LONGEST_LAST_STEP);
    let place = measured.middle + step;
    let corner = vec2<f32>(number);
    let at = mesh_place(place);
    if any(place < corner) || any(place >= corner + 1.0) || any(shown_place(at) != at) {
        return;
    }
    let seen = length(cross(measured.looking_x, measured.looking_y));
    let narrowest = MIN_WIDTH * max(length(measured.sky_x), length(measured.sky_y));
    let shown = max(length(cross(measured.sky_x, measured.sky_y)), narrowest);
    let order = u32(max(measured.turn, 0.0) / PI);
    let share = step / lengths;
    let direction = safe_normalize(measured.looking + share.x * measured.looking_x + share.y * measured.looking_y);
    add_image(star, order, direction, seen / max(shown, TINY));
}

// One invocation for each candidate.
@compute @workgroup_size(WORKGROUP_SIZE)
fn refine_image(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= candidate_count(ROUGH) {
        return;
    }
    let candidate = candidate_at(ROUGH, id.x);
    let number = candidate.cell;
    let star = candidate.star;
    let starts = candidate.starts;
    if rank_of(star) >= first_dropped_rank() {
        return;
    }
    let direction = star_list[star].direction;
    let tangents = tangents_at(direction);
    let cell = cell_at(number);
    let half_step = mesh.half_step / mesh.spacing;
    // Where the map folds, the first steps may lead far astray.
    let patience = select(0.0, FOLD_PATIENCE, (starts & FROM_MIDDLE) != 0u);

    // The results of the searches from earlier starts.
    var found = vec4<f32>(-1e6);
    for (var start = 0u; start < MAX_STARTS; start++) {
        if (starts & (1u << start)) == 0u {
            continue;
        }
        var search = search_from(start, cell, number, direction, tangents);
        var measured = cross_about(search.place);
        // The next ray of the cross: through the middle, right, left, below or above.
        var arm = 0u;
        // One loop for all rays, so that the shader contains the tracer once.
        for (var i = 0u; i < MAX_RAYS + LAST_RAYS && search.state != FAILED && arm < LAST_RAYS; i++) {
            let measures = search.state == FOUND;
            let side = select(-1.0, 1.0, (arm & 1u) == 1u);
            let axis = select(vec2<f32>(0.0, 1.0), vec2<f32>(1.0, 0.0), arm < 3u);
            let offset = select(0.0, side * half_step, measures && arm > 0u);
            let place = select(search.place, measured.middle, measures) + offset * axis;
            let looking = pixel_direction(mesh_place(place));
            let ray = trace(photon_from(looking));
            let sky = in_list(ray.sky);
            let sees_sky = ray.outcome == OUTCOME_SKY && dot(sky, direction) > 0.0;
            let missed = components_across(tangents, sky - direction);
            if !measures {
                continue_search(&search, number, patience, sees_sky, missed);
                let nearest = min(distance(search.place, found.xy), distance(search.place, found.zw));
                if search.state == FOUND {
                    search.state = select(FOUND, FAILED, nearest < APART);
                    measured = cross_about(anchor_of(search.place));
                }
            } else if arm == 0u {
                measured.missed = missed;
                measured.turn = ray.turn;
                measured.sky = sky;
                measured.looking = looking;
                search.state = select(FAILED, FOUND, sees_sky);
                arm = 1u;
            } else {
                let sky_step = select(0.0, side, sees_sky) * (sky - measured.sky);
                let looking_step = select(0.0, side, sees_sky) * (looking - measured.looking);
                measured.sky_x += axis.x * sky_step;
                measured.sky_y += axis.y * sky_step;
                measured.looking_x += axis.x * looking_step;
                measured.looking_y += axis.y * looking_step;
                measured.lengths += select(0.0, half_step, sees_sky) * axis;
                arm += 1u;
            }
        }
        if arm == LAST_RAYS {
            found = vec4<f32>(search.place, found.xy);
            add_found(measured, number, star, tangents);
        }
    }
}
