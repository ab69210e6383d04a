// The candidates: which stars may have an image in which cell of the mesh.
//
// Needs: RANKS, cell_number.
// Gives: BENT, Candidate, FROM_MESH, FROM_MIDDLE, MAX_STARTS, PREDICTION_STEPS, ROUGH, SMOOTH,
//     STAR_BITS, WIDE, rank_of, unpacked_candidate.

// The lists, one after the other, each with room for `mesh.capacity` candidates: candidates in smooth
// cells, whose map to the sky follows from the mesh alone; candidates whose images rays find; candidates
// that the mesh has not yet tested for an image in the cell; and cells whose stars are not yet found.
const SMOOTH: u32 = 0u;
const ROUGH: u32 = 1u;
const BENT: u32 = 2u;
const WIDE: u32 = 3u;

// A candidate is two numbers: that of the cell, and that of the star with, in its upper bits, the
// places from which the image is looked for: one for each triangle of the cell, its middle, and where
// the mesh has it.
const STAR_BITS: u32 = 28u;
const MAX_STARTS: u32 = 4u;
const FROM_MIDDLE: u32 = 4u;
const FROM_MESH: u32 = 8u;
// Steps of Newton's method to where the mesh has the image of a candidate in a bent cell.
const PREDICTION_STEPS: u32 = 6u;

// A star that may have an image in a cell, and the places from which it is looked for.
struct Candidate {
    cell: vec2<u32>,
    star: u32,
    starts: u32,
}

fn unpacked_candidate(packed: vec2<u32>) -> Candidate {
    return Candidate(cell_number(packed.x), packed.y & ((1u << STAR_BITS) - 1u), packed.y >> STAR_BITS);
}

// Rough candidates are counted by the rank of their stars, four ranks for each doubling of the star's
// number: the list of stars has the brightest first.
fn rank_of(star: u32) -> u32 {
    // The exponent and two bits of the mantissa.
    return min((bitcast<u32>(f32(star + 1u)) >> 21u) - (127u << 2u), RANKS - 1u);
}
