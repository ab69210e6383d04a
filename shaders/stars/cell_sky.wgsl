// What a cell of the mesh sees: its part of the sky, whether the map to the sky folds or is smooth, and
// the flux of the faintest star that counts there.
//
// Needs: Cell, MeshPoint, TINY, Triangle, mesh, mesh_place, mesh_points, pixel_solid_angle,
//     safe_normalize, stars, triangles_of.
// Gives: CellSky, MAX_INDEXED, depth_within, is_whole, sky_of.

// Corners of cells that lie farther apart on the sky, or differ by more in the angle swept about the
// hole, span the edge of the shadow or more than an order of images.
const MAX_SPAN: f32 = 1.2;
// How far outside a triangle a star may lie, as a share of the triangle, because the map from the
// picture to the sky is not as flat as the triangle is: where the map is flat, for rounding; in smooth
// cells; and in others.
const MIN_MARGIN: f32 = 0.01;
const MARGIN: f32 = 0.25;
const MAX_MARGIN: f32 = 1.0;
// Growth of the cell's outer radius per unit of margin.
const REACH: f32 = 3.2;
// Where neighbouring parts of the cell see the sky turned over, stars up to this far from the middle
// count.
const FOLD_REACH: f32 = 1.15;
// Largest ratio between the areas of a cell's corner triangles where the map does not fold.
const MAX_AREA_RATIO: f32 = 2.0;
// By how much, relative to its area, the sides of a cell that does not fold may differ, times its
// diagonal: next to the Einstein ring cells become slivers that are thinner than they are bent.
const MAX_BEND: f32 = 0.3;
// Largest fourth difference of a smooth cell's sky, in cells of the picture. Of it, a 12th is the
// error of the bicubic polynomial's slopes, and 0.023 that of its places: 5e-4 of the magnification and
// 6e-4 pixels of 960x540.
const MAX_FOURTH: f32 = 6e-3;
// The same of a cell whose sky the polynomial gives roughly, to a 40th of a cell.
const MAX_ROUGH_FOURTH: f32 = 1.0;
// By how much the magnification within a cell may exceed that of its smallest corner triangle: in a
// smooth cell, and in one that does not fold; there it also stays within a factor of that of the
// largest. Where the map folds it has no bound next to the fold, and elsewhere in the cell one by the
// largest. In random scenes with 190 000 images, none is found by eight times as much that is not found
// by these.
const SMOOTH_SAFETY: f32 = 1.5;
const SAFETY: f32 = 2.0;
const BENT_SAFETY: f32 = 8.0;
const FOLD_SAFETY: f32 = 4.0;
// The radius of the sky, in radians, up to which the index is searched. Farther away from a cell's
// middle, the faces' flat maps no longer bound its sky.
const MAX_INDEXED: f32 = 0.6;

// Gives the place of a star in a triangle: x and y are dot(along, d), where d is the difference
// between the place at which the star's direction meets the plane and the origin.
struct Solver {
    origin: vec3<f32>,
    normal: vec3<f32>,
    // Distance of the plane, times the length of `normal`.
    distance: f32,
    along_x: vec3<f32>,
    along_y: vec3<f32>,
}

// What a cell sees.
struct CellSky {
    triangles: array<Solver, 2>,
    // Whether the map from the picture to the sky folds in it, so that stars have several images or
    // none; and whether it may.
    is_caustic: bool,
    may_fold: bool,
    // Whether the points of the mesh give that map as precisely as rays would.
    is_smooth: bool,
    // Whether they give it at least roughly.
    is_bent: bool,
    // How far outside a triangle a star may lie, as a share of the triangle.
    margin: f32,
    middle: vec3<f32>,
    // Distance of the farthest star that counts from the middle.
    reach: f32,
    // Where the map folds: the direction across the sky's longer side, and how far a star may be that
    // way from the middle.
    across: vec3<f32>,
    width: f32,
    // Luminous flux of the faintest star that can be bright enough there.
    least_flux: f32,
}

fn solver_of(triangle: Triangle) -> Solver {
    let normal = cross(triangle.along_x, triangle.along_y);
    let area2 = max(dot(normal, normal), TINY);
    return Solver(
        triangle.origin,
        normal,
        dot(triangle.origin, normal),
        cross(triangle.along_y, normal) / area2,
        cross(normal, triangle.along_x) / area2,
    );
}

// How far within a triangle a star lies: its least barycentric coordinate.
fn depth_within(solver: Solver, star: vec3<f32>, is_above: bool) -> f32 {
    let slope = dot(star, solver.normal);
    let offset = star * (solver.distance / select(slope, TINY, abs(slope) < TINY)) - solver.origin;
    let x = dot(offset, solver.along_x);
    let y = dot(offset, solver.along_y);
    return select(min(min(1.0 - y, y - x), x), min(min(1.0 - x, x - y), y), is_above);
}

// Whether all corners see the sky, and parts of it that belong together.
fn is_whole(cell: Cell) -> bool {
    let turns = vec4<f32>(cell.corners[0].turn, cell.corners[1].turn, cell.corners[2].turn, cell.corners[3].turn);
    let gains = vec4<f32>(cell.corners[0].gain, cell.corners[1].gain, cell.corners[2].gain, cell.corners[3].gain);
    let most = max(max(turns.x, turns.y), max(turns.z, turns.w));
    let least = min(min(turns.x, turns.y), min(turns.z, turns.w));
    let down = distance(cell.corners[0].sky, cell.corners[3].sky);
    let up = distance(cell.corners[1].sky, cell.corners[2].sky);
    return all(gains >= vec4<f32>(0.0)) && most - least < MAX_SPAN && max(down, up) < MAX_SPAN;
}

// The area of the corner triangle between two sides, as a parallelogram, seen from `middle`.
fn signed_area(middle: vec3<f32>, side: vec3<f32>, next_side: vec3<f32>) -> f32 {
    return dot(middle, cross(side, next_side));
}

// How a cell's sky bends: its largest second difference across its longer side, in radians; and its
// largest second and fourth differences in cells of the picture.
struct Bending {
    angle: f32,
    second: f32,
    fourth: f32,
}

// Stands for a difference that takes points which see no sky, or another part of it.
const UNKNOWN: f32 = 1e9;

// A difference of directions in cells of the picture: the larger component.
fn in_cells(solver: Solver, difference: vec3<f32>) -> f32 {
    return max(abs(dot(solver.along_x, difference)), abs(dot(solver.along_y, difference)));
}

// Whether a point sees a part of the sky that belongs to a corner's.
fn belongs(point: MeshPoint, corner: MeshPoint) -> bool {
    return point.gain >= 0.0 && abs(point.turn - corner.turn) < MAX_SPAN;
}

// From the rows and columns of the mesh through the cell's corners, and two points beyond the corners
// each way: the cell must not be at the rim of the mesh.
fn bending_of(cell: Cell, number: vec2<u32>, solver: Solver, across: vec3<f32>) -> Bending {
    let columns = mesh.points.x;
    let first = number.y * columns + number.x;
    let corner = cell.corners[0];
    // The corners of the 16 points about the cell, which lie on none of the four lines.
    let diagonal = belongs(mesh_points[first - columns - 1u], corner)
        && belongs(mesh_points[first - columns + 2u], corner)
        && belongs(mesh_points[first + 2u * columns - 1u], corner)
        && belongs(mesh_points[first + 2u * columns + 2u], corner);
    var bending = Bending(0.0, 0.0, select(UNKNOWN, 0.0, diagonal));
    // Two rows, then two columns.
    for (var line = 0u; line < 4u; line++) {
        let is_row = line < 2u;
        let along = select(columns, 1u, is_row);
        let start = first + (line & 1u) * select(1u, columns, is_row) - 2u * along;
        let far_left = mesh_points[start];
        let left = mesh_points[start + along];
        let middle = mesh_points[start + 2u * along].sky;
        let next = mesh_points[start + 3u * along].sky;
        let right = mesh_points[start + 4u * along];
        let far_right = mesh_points[start + 5u * along];
        let before = left.sky - 2.0 * middle + next;
        let after = middle - 2.0 * next + right.sky;
        let far_before = far_left.sky - 2.0 * left.sky + middle;
        let far_after = next - 2.0 * right.sky + far_right.sky;
        let sees_left = belongs(left, corner);
        let sees_right = belongs(right, corner);
        let sees_all = sees_left && sees_right && belongs(far_left, corner) && belongs(far_right, corner);
        let second = max(select(0.0, in_cells(solver, before), sees_left), select(0.0, in_cells(solver, after), sees_right));
        let fourth = max(in_cells(solver, far_before - 2.0 * before + after), in_cells(solver, before - 2.0 * after + far_after));
        bending.angle = max(bending.angle, select(0.0, abs(dot(before, across)), sees_left));
        bending.angle = max(bending.angle, select(0.0, abs(dot(after, across)), sees_right));
        bending.second = max(bending.second, select(UNKNOWN, second, sees_left || sees_right));
        bending.fourth = max(bending.fourth, select(UNKNOWN, fourth, sees_all));
    }
    return bending;
}

fn sky_of(cell: Cell, number: vec2<u32>) -> CellSky {
    let corners = array<vec3<f32>, 4>(cell.corners[0].sky, cell.corners[1].sky, cell.corners[2].sky, cell.corners[3].sky);
    let middle = safe_normalize(corners[0] + corners[1] + corners[2] + corners[3]);
    var radius = 0.0;
    var gain = 0.0;
    for (var i = 0u; i < 4u; i++) {
        radius = max(radius, distance(corners[i], middle));
        gain = max(gain, cell.corners[i].gain);
    }
    let top = corners[1] - corners[0];
    let bottom = corners[3] - corners[2];
    let left = corners[2] - corners[0];
    let right = corners[3] - corners[1];
    let areas = vec4<f32>(
        signed_area(middle, top, left),
        signed_area(middle, top, right),
        signed_area(middle, bottom, left),
        signed_area(middle, bottom, right),
    );
    let sizes = abs(areas);
    let largest = max(max(sizes.x, sizes.y), max(sizes.z, sizes.w));
    let smallest = min(min(sizes.x, sizes.y), min(sizes.z, sizes.w));
    let is_caustic = !(all(areas > vec4<f32>(0.0)) || all(areas < vec4<f32>(0.0)));
    let place = mesh_place(vec2<f32>(number) + 0.5);
    let solid_angle = mesh.spacing * mesh.spacing * pixel_solid_angle(place);
    let bend = distance(top, bottom) * (radius + radius);
    let triangles = triangles_of(cell);
    let solvers = array<Solver, 2>(solver_of(triangles[0]), solver_of(triangles[1]));
    // Where the map folds, the sky's part of a cell may be much longer than it is wide.
    let down = corners[3] - corners[0];
    let up = corners[2] - corners[1];
    let axis = safe_normalize(select(up, down, dot(down, down) > dot(up, up)));
    let across = safe_normalize(cross(middle, axis));
    var width = 0.0;
    for (var i = 0u; i < 4u; i++) {
        width = max(width, abs(dot(corners[i] - middle, across)));
    }
    let bending = bending_of(cell, number, solvers[0], across);
    // Between its corners the map differs from a triangle by up to an eighth of the second differences
    // along both axes, and a quarter of that along one and the other. Twice as much is safe.
    let margin = MIN_MARGIN + 0.5 * bending.second + 0.5 * in_cells(solvers[0], right - left);
    let folds = largest > MAX_AREA_RATIO * smallest || bend > MAX_BEND * smallest;
    let is_smooth = !is_caustic && !folds && margin < MARGIN && bending.fourth < MAX_FOURTH;
    let is_bent = !is_caustic && !is_smooth && bending.fourth < MAX_ROUGH_FOURTH;
    let reach = select(1.0 + REACH * min(margin, MAX_MARGIN), FOLD_REACH, is_caustic) * radius;
    let beyond = 0.5 * (bending.angle + abs(dot(left - right, across)));
    let rough_area = select(max(smallest / SAFETY, largest / BENT_SAFETY), largest / FOLD_SAFETY, is_caustic);
    let area = select(rough_area, smallest / SMOOTH_SAFETY, is_smooth);
    let least_flux = stars.flux_limit * area / max(gain * solid_angle, TINY);
    return CellSky(
        solvers,
        is_caustic,
        is_caustic || folds,
        is_smooth,
        is_bent,
        min(margin, MAX_MARGIN),
        middle,
        reach,
        across,
        min(width + beyond, reach),
        least_flux,
    );
}
