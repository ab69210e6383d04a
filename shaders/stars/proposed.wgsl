// The candidates that `propose` has listed, for the kernels that find their images.
//
// Needs: BINDING_CANDIDATES, BINDING_CANDIDATE_COUNT, ROUGH, STAR_BITS, cell_number, mesh.
// Gives: candidate_at, candidate_number.

// A star that may have an image in a cell, and the places from which it is looked for.
struct Candidate {
    cell: vec2<u32>,
    star: u32,
    starts: u32,
}

@group(0) @binding(BINDING_CANDIDATES) var<storage, read> candidates: array<vec2<u32>>;
// As in propose.wgsl, for each list; the last number counts its candidates.
@group(0) @binding(BINDING_CANDIDATE_COUNT) var<storage, read> candidate_counts: array<vec4<u32>, 4>;

// Maximum number of candidates whose images are looked for by rays: more than any picture from outside
// the horizon has. It keeps a frame from lasting seconds.
const MAX_ROUGH: u32 = 65536u;

// How many candidates of a list count.
fn candidate_number(list: u32) -> u32 {
    let room = min(mesh.capacity, arrayLength(&candidates) / 4u);
    return min(candidate_counts[list].w, select(room, min(room, MAX_ROUGH), list == ROUGH));
}

// A candidate of a list.
fn candidate_at(list: u32, index: u32) -> Candidate {
    let packed = candidates[list * mesh.capacity + index];
    let star = packed.y & ((1u << STAR_BITS) - 1u);
    return Candidate(cell_number(packed.x), star, packed.y >> STAR_BITS);
}
