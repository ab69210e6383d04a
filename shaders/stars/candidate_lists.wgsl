// The lists of candidates, for the kernels that find their images.
//
// Gives: candidate_at, candidate_count, first_dropped_rank.

@group(0) @binding(BINDING_CANDIDATES) var<storage, read> candidates: array<vec2<u32>>;
// As `CandidateCounts` in add_candidate.wgsl: the last number of a list counts its candidates.
struct CandidateCounts {
    lists: array<vec4<u32>, CANDIDATE_LISTS>,
    rough: array<u32, RANKS>,
    // Maximum number of rough candidates that rays follow.
    max_traced: u32,
}

@group(0) @binding(BINDING_CANDIDATE_COUNT) var<storage, read> candidate_counts: CandidateCounts;

// The number of candidates in a list.
fn candidate_count(list: u32) -> u32 {
    return min(candidate_counts.lists[list].w, min(mesh.capacity, arrayLength(&candidates) / CANDIDATE_LISTS));
}

// The rank from which on rough candidates are dropped because there are too many.
fn first_dropped_rank() -> u32 {
    if candidate_counts.lists[ROUGH].w <= candidate_counts.max_traced {
        return RANKS;
    }
    var sum = 0u;
    for (var rank = 0u; rank < RANKS; rank++) {
        sum += candidate_counts.rough[rank];
        if sum > candidate_counts.max_traced {
            return rank;
        }
    }
    return RANKS;
}

// A candidate of a list.
fn candidate_at(list: u32, index: u32) -> Candidate {
    return unpacked_candidate(candidates[list * mesh.capacity + index]);
}
