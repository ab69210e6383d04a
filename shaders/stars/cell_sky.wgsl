// The sky of a cell of the mesh: its extent, whether the map from the picture to the sky folds or
// is smooth there, and the flux of the faintest star that can be seen.
//
// Gives: CellSky, MAX_INDEXED, depth_within, is_whole, sky_of.

// Cells whose corners lie farther apart on the sky, or differ by more in the angle swept about the
// hole, span the edge of the shadow or several orders of images.
const MAX_SPAN: f32 = 1.2;
// The margin about a triangle, as a share of it, for stars that the curved map brings into the
// cell: the least, for rounding; the largest in smooth cells; and the largest in others.
const MIN_MARGIN: f32 = 0.01;
const MARGIN: f32 = 0.25;
const MAX_MARGIN: f32 = 1.0;
// Growth of the cell's outer radius per unit of margin.
const REACH: f32 = 3.2;
// The reach of a cell in which the map folds, in radii of its sky.
const FOLD_REACH: f32 = 1.15;
// Largest ratio between the areas of a cell's corner triangles where the map does not fold.
const MAX_AREA_RATIO: f32 = 2.0;
// The largest product of diagonal and difference of opposite sides, relative to the area, in a cell
// that does not fold: next to the Einstein ring cells are thinner than they are bent.
const MAX_BEND: f32 = 0.3;
// The largest fourth difference of a smooth cell's sky, in cells of the picture. The error of the
// polynomial's slopes is a 12th of it, 5e-4, that of its places 0.023 of it, 6e-4 pixels of
// 960x540.
const MAX_FOURTH: f32 = 6e-3;
// The same in a cell where the polynomial is accurate to a 40th of a cell.
const MAX_ROUGH_FOURTH: f32 = 1.0;
// Bounds of the magnification within a cell: relative to that of its smallest corner triangle in a
// smooth cell, and in any cell that does not fold; there also relative to the largest triangle's;
// relative to the largest where the map folds, away from the fold itself. In random scenes with 190
// 000 images, bounds eight times as large find no further image.
const SMOOTH_SAFETY: f32 = 1.5;
const SAFETY: f32 = 2.0;
const BENT_SAFETY: f32 = 8.0;
const FOLD_SAFETY: f32 = 4.0;
// The largest reach, in radians, for which the index is searched: farther out, the faces' flat maps
// do not bound a cell's sky.
const MAX_INDEXED: f32 = 0.6;

// Gives the place of a star in a triangle: x and y are dot(along, d), where d leads from the origin to
// the star in the triangle's plane.
struct Solver {
    origin: vec3<f32>,
    normal: vec3<f32>,
    // Distance of the plane, times the length of `normal`.
    distance: f32,
    along_x: vec3<f32>,
    along_y: vec3<f32>,
}

// The sky of a cell.
struct CellSky {
    triangles: array<Solver, 2>,
    // Whether the map from the picture to the sky folds, so that stars have several images or none;
    // and whether it may fold.
    is_caustic: bool,
    may_fold: bool,
    // Whether the mesh interpolates that map as precisely as rays.
    is_smooth: bool,
    // Whether it does so roughly.
    is_bent: bool,
    // The margin about a triangle, as a share of it.
    margin: f32,
    middle: vec3<f32>,
    // The largest distance of a star from the middle.
    reach: f32,
    // Where the map folds: the direction across the longer side of the sky, and the largest
    // distance from the middle in that direction.
    across: vec3<f32>,
    width: f32,
    // Luminous flux of the faintest star that can be seen.
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

// The depth of a star within a triangle: its smallest barycentric coordinate.
fn depth_within(solver: Solver, star: vec3<f32>, is_above: bool) -> f32 {
    let slope = dot(star, solver.normal);
    let offset = star * (solver.distance / select(slope, TINY, abs(slope) < TINY)) - solver.origin;
    let x = dot(offset, solver.along_x);
    let y = dot(offset, solver.along_y);
    return select(min(min(1.0 - y, y - x), x), min(min(1.0 - x, x - y), y), is_above);
}

// Whether all corners see the sky, in one image of it.
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

// The curvature of a cell's map to the sky: its largest second difference across the sky's longer
// side, in radians, and its largest second and fourth differences in cells of the picture.
struct Bending {
    angle: f32,
    second: f32,
    fourth: f32,
}

// Stands for a difference that would need points which see no sky, or another image of it.
const UNKNOWN: f32 = 1e9;

// The larger component of a difference of directions, in cells of the picture.
fn in_cells(solver: Solver, difference: vec3<f32>) -> f32 {
    return max(abs(dot(solver.along_x, difference)), abs(dot(solver.along_y, difference)));
}

// Whether a point sees the sky in the same image as a corner.
fn belongs(point: MeshPoint, corner: MeshPoint) -> bool {
    return point.gain >= 0.0 && abs(point.turn - corner.turn) < MAX_SPAN;
}

// From the rows and columns of the mesh through the cell's corners, with two points beyond each
// corner: the cell must not be at the rim of the mesh.
fn bending_of(cell: Cell, number: vec2<u32>, solver: Solver, across: vec3<f32>) -> Bending {
    let columns = mesh.points.x;
    let first = number.y * columns + number.x;
    let corner = cell.corners[0];
    // The corners of the 16 points about the cell, which are not on the four lines.
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
    let is_caustic = !(all_positive(areas) || all_positive(-areas));
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
    // The margin is twice the largest difference of the map from a triangle: an eighth of the
    // second differences along both axes, and a quarter of the mixed one.
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
