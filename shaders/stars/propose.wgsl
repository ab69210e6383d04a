// Looks for the stars that may have an image in each cell of the mesh.
//
// The cells of an index over the sky list their stars: a cell of the mesh searches those that its own
// sky touches. Cells that see more sky than MAX_NARROW are left to a second kernel. For those that see
// more than MAX_INDEXED, a third one searches the list of all stars instead, until the first star that is
// too faint: such a cell shows its sky so small that few stars are bright enough.
//
// Needs: BINDING_CANDIDATES, BINDING_CANDIDATE_COUNT, BINDING_STAR_INDEX, CellSky, FROM_MIDDLE,
//     MAX_INDEXED, MESH_RIM, ROUGH, SMOOTH, STAR_BITS, STAR_INDEX_SIDE, WIDE, WIDEST, WIDE_GROUPS,
//     WORKGROUP_SIZE, cell_at, cell_number, depth_within, is_whole, mesh, mesh_cells, sky_of,
//     square, star_list, stars, unpacked_flux.
// Gives: propose, propose_wide, propose_widest.

// Invocations that share a wide cell.
const WIDE_LANES: u32 = 8u;
// The part of the sky, in radians, that one invocation searches.
const MAX_NARROW: f32 = 0.025;
// How many stars of the list, the brightest ones, a widest cell searches. Next to the inner horizon
// light is shifted to the blue so far that all stars are bright in all cells.
const MAX_LISTED: u32 = 1024u;
// Least component, along a face's axis, of a direction on that face: 1/sqrt(3), rounded down.
const FACE_EDGE: f32 = 0.577;

// The number of candidates in a list, and before it the number of workgroups that find their images,
// as an indirect dispatch reads it.
struct CandidateCount {
    groups_x: atomic<u32>,
    groups_y: u32,
    groups_z: u32,
    candidates: atomic<u32>,
}

// For each cell of the index, where its stars begin, and at last where they end, in pairs of numbers;
// and then, as pairs, the places of the stars on their face, from 0 to 1, and their numbers.
@group(0) @binding(BINDING_STAR_INDEX) var<storage, read> star_index: array<u32>;
@group(0) @binding(BINDING_CANDIDATES) var<storage, read_write> candidates: array<vec2<u32>>;
@group(0) @binding(BINDING_CANDIDATE_COUNT) var<storage, read_write> candidate_counts: array<CandidateCount, 4>;

fn add_candidate(list: u32, cell: u32, star: u32, starts: u32) {
    let index = atomicAdd(&candidate_counts[list].candidates, 1u);
    if index < min(mesh.capacity, arrayLength(&candidates) / 4u) {
        candidates[list * mesh.capacity + index] = vec2<u32>(cell, (starts << STAR_BITS) | star);
        atomicMax(&candidate_counts[list].groups_x, index / WORKGROUP_SIZE + 1u);
    }
}

// The list's star becomes a candidate if it may have an image in this cell that is bright enough.
fn propose_star(sky: CellSky, cell: u32, star: u32) {
    let direction = star_list[star].direction;
    let from_middle = direction - sky.middle;
    if dot(from_middle, from_middle) > square(sky.reach) || unpacked_flux(star_list[star].light) < sky.least_flux {
        return;
    }
    let above = depth_within(sky.triangles[0], direction, true) >= -sky.margin;
    let below = depth_within(sky.triangles[1], direction, false) >= -sky.margin;
    let may_turn_over = sky.is_caustic && abs(dot(from_middle, sky.across)) < sky.width;
    if !(above || below || may_turn_over) {
        return;
    }
    let both = select(0u, 1u, above) | select(0u, 2u, below);
    let either = select(2u, 1u, above);
    let starts = select(select(either, both, sky.may_fold), both | FROM_MIDDLE, sky.is_caustic);
    add_candidate(select(ROUGH, SMOOTH, sky.is_smooth), cell, star, starts);
}

// The number of stars that count.
fn star_count() -> u32 {
    return min(stars.counts[0], arrayLength(&star_list));
}

// The part of one side of a face that a sky covers, from -1 to 1: `across` is its middle's component
// along that side, `nearest` and `farthest` the least and the largest component along the face's axis.
fn covered(across: f32, radius: f32, nearest: f32, farthest: f32) -> vec2<f32> {
    let low = across - radius;
    let high = across + radius;
    return vec2<f32>(low / select(nearest, farthest, low > 0.0), high / select(farthest, nearest, high > 0.0));
}

// The cells of the index along a side, from the first to the one after the last.
fn touched_cells(part: vec2<f32>) -> vec2<u32> {
    let side = f32(STAR_INDEX_SIDE);
    let places = floor(0.5 * side * (part + 1.0)) + vec2<f32>(0.0, 1.0);
    return vec2<u32>(clamp(places, vec2<f32>(0.0), vec2<f32>(side)));
}

// Every `step`th star, from the one with number `lane` on.
fn propose_from_index(sky: CellSky, cell: u32, lane: u32, step: u32) {
    // A little more than the radius, for rounding.
    let radius = sky.reach + 1e-4;
    for (var face = 0u; face < 6u; face++) {
        let axis = face >> 1u;
        let turned = select(select(sky.middle.zxy, sky.middle.yzx, axis == 1u), sky.middle, axis == 0u);
        let along = select(turned.x, -turned.x, (face & 1u) == 1u);
        if along + radius < FACE_EDGE {
            continue;
        }
        let nearest = max(along - radius, FACE_EDGE);
        let part_x = covered(turned.y, radius, nearest, along + radius);
        let part_y = covered(turned.z, radius, nearest, along + radius);
        let columns = touched_cells(part_x);
        let rows = touched_cells(part_y);
        // The stars of a row of cells follow each other.
        for (var row = rows.x; row < rows.y; row++) {
            let start = (face * STAR_INDEX_SIDE + row) * STAR_INDEX_SIDE;
            let end = min(star_index[start + columns.y], arrayLength(&star_index) / 2u);
            for (var i = star_index[start + columns.x] + lane; i < end; i += step) {
                let place = 2.0 * unpack2x16unorm(star_index[2u * i]) - 1.0;
                if place.x < part_x.x || place.x > part_x.y || place.y < part_y.x || place.y > part_y.y {
                    continue;
                }
                let star = star_index[2u * i + 1u];
                if star < star_count() {
                    propose_star(sky, cell, star);
                }
            }
        }
    }
}

// One invocation for each cell. Wide ones are listed.
@compute @workgroup_size(WORKGROUP_SIZE)
fn propose(@builtin(global_invocation_id) id: vec3<u32>) {
    let cells = mesh_cells();
    let number = cell_number(id.x);
    // Cells at the rim of the mesh, beyond the picture, only serve their neighbours.
    if any(number < vec2<u32>(MESH_RIM)) || any(number + MESH_RIM >= cells) || !is_whole(cell_at(number)) {
        return;
    }
    let sky = sky_of(cell_at(number), number);
    if sky.reach < MAX_NARROW {
        propose_from_index(sky, id.x, 0u, 1u);
    } else {
        add_candidate(select(WIDEST, WIDE, sky.reach < MAX_INDEXED), id.x, 0u, 0u);
    }
}

// The invocations of a workgroup share the stars of a wide cell.
@compute @workgroup_size(WIDE_LANES)
fn propose_wide(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let count = min(atomicLoad(&candidate_counts[WIDE].candidates), mesh.capacity);
    for (var i = group.x; i < count; i += WIDE_GROUPS) {
        let cell = candidates[WIDE * mesh.capacity + i].x;
        let number = cell_number(cell);
        propose_from_index(sky_of(cell_at(number), number), cell, lane, WIDE_LANES);
    }
}

// The same for the widest, from the brightest star to the first that is too faint.
@compute @workgroup_size(WORKGROUP_SIZE)
fn propose_widest(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let count = min(atomicLoad(&candidate_counts[WIDEST].candidates), mesh.capacity);
    for (var i = group.x; i < count; i += WIDE_GROUPS) {
        let cell = candidates[WIDEST * mesh.capacity + i].x;
        let number = cell_number(cell);
        let sky = sky_of(cell_at(number), number);
        for (var star = lane; star < min(star_count(), MAX_LISTED); star += WORKGROUP_SIZE) {
            if unpacked_flux(star_list[star].light) < sky.least_flux {
                break;
            }
            propose_star(sky, cell, star);
        }
    }
}
