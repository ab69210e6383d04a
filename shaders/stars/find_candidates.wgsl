// Finds the candidates of each cell of the mesh. An index divides the sky into cells that list
// their stars, in layers by brightness. A cell of the mesh searches the index cells that its own
// sky touches, down to the layer whose stars are too faint. A second kernel divides cells whose sky
// is wider than MAX_NARROW into parts. There, cells that see much of the sky but only its bright
// stars search the list of all stars, up to the first that is too faint.
//
// Gives: find_candidates, find_wide_candidates.

// The largest reach, in radians, that one invocation searches.
const MAX_NARROW: f32 = 0.015;
// The parts into which a wide cell's sky is divided.
const PARTS: u32 = 8u;
// The reach, in radians, from which on cells that show bright stars alone search the list.
const MIN_LISTED: f32 = 0.14;
// The smallest component along a face's axis of a direction on it: 1/sqrt(3), rounded down.
const FACE_EDGE: f32 = 0.577;

// For each cell of each layer, the start of its stars, and at last the end, counted in pairs of
// numbers; then a pair for each star: its place on its face, from 0 to 1, and its number.
@group(0) @binding(BINDING_STAR_INDEX) var<storage, read> star_index: array<u32>;

// Adds a star as a candidate if it may have an image in this cell that is bright enough.
fn consider_star(sky: CellSky, cell: u32, star: u32) {
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
    if sky.is_smooth || sky.is_bent {
        add_candidate(select(BENT, SMOOTH, sky.is_smooth), cell, star, starts);
    } else {
        add_rough(cell, star, starts);
    }
}

// The number of stars.
fn star_count() -> u32 {
    return min(stars.counts[0], arrayLength(&star_list));
}

// The range of one coordinate of a face, from -1 to 1, that a cell's sky covers: `across` is its
// middle's component along it, `nearest` and `farthest` bound that along the face's axis.
fn covered(across: f32, radius: f32, nearest: f32, farthest: f32) -> vec2<f32> {
    let low = across - radius;
    let high = across + radius;
    return vec2<f32>(low / select(nearest, farthest, low > 0.0), high / select(farthest, nearest, high > 0.0));
}

// The range of index cells along a side of a face, from the first to the one after the last.
fn touched_cells(part: vec2<f32>, side: u32) -> vec2<u32> {
    let places = floor(0.5 * f32(side) * (part + 1.0)) + vec2<f32>(0.0, 1.0);
    return vec2<u32>(clamp(places, vec2<f32>(0.0), vec2<f32>(f32(side))));
}

// The number of a layer's cells along a side of a face, and in all.
fn layer_side(layer: u32) -> u32 {
    return FIRST_INDEX_SIDE << layer;
}

fn layer_cells(layer: u32) -> u32 {
    return 6u * layer_side(layer) * layer_side(layer);
}

// The number of layers with stars as bright as this.
fn layer_count(least_flux: f32) -> u32 {
    var first = 0u;
    for (var layer = 0u; layer < INDEX_LAYERS; layer++) {
        if first >= star_count() || unpacked_flux(star_list[first].light) < least_flux {
            return layer;
        }
        // A layer has as many stars as cells.
        first += layer_cells(layer);
    }
    return INDEX_LAYERS;
}

// Searches one of several parts of a cell's sky, of interleaved rows of the index.
fn search_index(sky: CellSky, cell: u32, part: u32, parts: u32) {
    // A little more than the reach, for rounding.
    let radius = sky.reach + 1e-4;
    let layers = layer_count(sky.least_flux);
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
        // The start of the layer's numbers.
        var layer_start = 0u;
        for (var layer = 0u; layer < layers; layer++) {
            let side = layer_side(layer);
            let columns = touched_cells(part_x, side);
            let rows = touched_cells(part_y, side);
            // The stars of a row of cells follow each other.
            for (var row = rows.x + part; row < rows.y; row += parts) {
                let start = layer_start + (face * side + row) * side;
                let end = min(star_index[start + columns.y], arrayLength(&star_index) / 2u);
                for (var i = star_index[start + columns.x]; i < end; i++) {
                    let place = 2.0 * unpack2x16unorm(star_index[2u * i]) - 1.0;
                    if place.x < part_x.x || place.x > part_x.y || place.y < part_y.x || place.y > part_y.y {
                        continue;
                    }
                    let star = star_index[2u * i + 1u];
                    if star < star_count() {
                        consider_star(sky, cell, star);
                    }
                }
            }
            layer_start += layer_cells(layer) + 1u;
        }
    }
}

// Searches the list of all stars, from the brightest on.
fn search_list(sky: CellSky, cell: u32, part: u32) {
    for (var star = part; star < star_count(); star += PARTS) {
        if unpacked_flux(star_list[star].light) < sky.least_flux {
            break;
        }
        consider_star(sky, cell, star);
    }
}

// One invocation for each cell. Wide ones are listed.
@compute @workgroup_size(WORKGROUP_SIZE)
fn find_candidates(@builtin(global_invocation_id) id: vec3<u32>) {
    let cells = mesh_cells();
    let number = cell_number(id.x);
    // Cells at the rim of the mesh, beyond the picture, serve only their neighbours.
    if any(number < vec2<u32>(MESH_RIM)) || any(number + MESH_RIM >= cells) || !is_whole(cell_at(number)) {
        return;
    }
    let sky = sky_of(cell_at(number), number);
    if sky.reach < MAX_NARROW {
        search_index(sky, id.x, 0u, 1u);
    } else {
        for (var part = 0u; part < PARTS; part++) {
            add_candidate(WIDE, id.x, part, 0u);
        }
    }
}

// One invocation for each part of a wide cell.
@compute @workgroup_size(WORKGROUP_SIZE)
fn find_wide_candidates(@builtin(global_invocation_id) id: vec3<u32>) {
    let count = min(atomicLoad(&candidate_counts.lists[WIDE].candidates), mesh.capacity);
    for (var i = id.x; i < count; i += WIDE_GROUPS * WORKGROUP_SIZE) {
        let task = candidates[WIDE * mesh.capacity + i];
        let number = cell_number(task.x);
        let sky = sky_of(cell_at(number), number);
        if sky.reach < MIN_LISTED || sky.reach < MAX_INDEXED && layer_count(sky.least_flux) > 1u {
            search_index(sky, task.x, task.y, PARTS);
        } else {
            search_list(sky, task.x, task.y);
        }
    }
}
