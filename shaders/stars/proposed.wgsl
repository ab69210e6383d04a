// The candidates that `propose` has listed, for the kernels that find their images.
//
// Needs: BINDING_CANDIDATES, BINDING_CANDIDATE_COUNT, CANDIDATE_LISTS, Candidate, RANKS, ROUGH,
//     mesh, unpacked_candidate.
// Gives: candidate_at, candidate_number, first_rank_left_out.

@group(0) @binding(BINDING_CANDIDATES) var<storage, read> candidates: array<vec2<u32>>;
// As `CandidateCounts` in add_candidate.wgsl: the last number of a list counts its candidates.
struct ProposedCounts {
    lists: array<vec4<u32>, CANDIDATE_LISTS>,
    rough: array<u32, RANKS>,
    // How many rough candidates rays follow at most.
    max_traced: u32,
}

@group(0) @binding(BINDING_CANDIDATE_COUNT) var<storage, read> candidate_counts: ProposedCounts;

// How many candidates a list has.
fn candidate_number(list: u32) -> u32 {
    return min(candidate_counts.lists[list].w, min(mesh.capacity, arrayLength(&candidates) / CANDIDATE_LISTS));
}

// The rank of the first stars whose rough candidates would be too many; brighter ones count. It depends
// on how many candidates there are and not on their order.
fn first_rank_left_out() -> u32 {
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
