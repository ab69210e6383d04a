// Adds candidates to their lists.
//
// Gives: add_candidate, add_rough, candidate_counts, candidates.

// The size of an indirect dispatch of the kernel that finds the images of a list's candidates, and
// their number.
struct CandidateCount {
    groups_x: atomic<u32>,
    groups_y: u32,
    groups_z: u32,
    candidates: atomic<u32>,
}

// The counts of each list, and the numbers of rough candidates by the rank of their star.
struct CandidateCounts {
    lists: array<CandidateCount, CANDIDATE_LISTS>,
    rough: array<atomic<u32>, RANKS>,
    max_traced: u32,
}

@group(0) @binding(BINDING_CANDIDATES) var<storage, read_write> candidates: array<vec2<u32>>;
@group(0) @binding(BINDING_CANDIDATE_COUNT) var<storage, read_write> candidate_counts: CandidateCounts;

fn add_candidate(list: u32, cell: u32, star: u32, starts: u32) {
    let index = atomicAdd(&candidate_counts.lists[list].candidates, 1u);
    if index < min(mesh.capacity, arrayLength(&candidates) / CANDIDATE_LISTS) {
        candidates[list * mesh.capacity + index] = vec2<u32>(cell, (starts << STAR_BITS) | star);
        // The first candidate of each workgroup counts the workgroup.
        if index % WORKGROUP_SIZE == 0u {
            atomicAdd(&candidate_counts.lists[list].groups_x, 1u);
        }
    }
}

// Adds a candidate whose image rays find.
fn add_rough(cell: u32, star: u32, starts: u32) {
    atomicAdd(&candidate_counts.rough[rank_of(star)], 1u);
    add_candidate(ROUGH, cell, star, starts);
}
