// Candidates: pairs of a cell of the mesh and a star that may have an image there.
//
// Gives: BENT, Candidate, FROM_MESH, FROM_MIDDLE, INTERPOLATION_STEPS, MAX_STARTS, ROUGH, SMOOTH,
//     STAR_BITS, WIDE, rank_of, unpacked_candidate.

// The lists, each with room for `mesh.capacity` candidates: in smooth cells, where the mesh
// interpolates the map to the sky precisely; those whose images rays find; in bent cells, still to
// be tested; and parts of wide cells whose stars are still to be found.
const SMOOTH: u32 = 0u;
const ROUGH: u32 = 1u;
const BENT: u32 = 2u;
const WIDE: u32 = 3u;

// A candidate is two numbers: the cell's, and the star's with a bit in its upper bits for each
// start of the search: the cell's two triangles, its middle, and the interpolated place.
const STAR_BITS: u32 = 28u;
const MAX_STARTS: u32 = 4u;
const FROM_MIDDLE: u32 = 4u;
const FROM_MESH: u32 = 8u;
// Steps of Newton's method to the interpolated place in a bent cell.
const INTERPOLATION_STEPS: u32 = 6u;

// A star that may have an image in a cell, and the starts of the search.
struct Candidate {
    cell: vec2<u32>,
    star: u32,
    starts: u32,
}

fn unpacked_candidate(packed: vec2<u32>) -> Candidate {
    return Candidate(cell_number(packed.x), packed.y & ((1u << STAR_BITS) - 1u), packed.y >> STAR_BITS);
}

// The rank of a star: four for each doubling of its number, which counts from the brightest.
fn rank_of(star: u32) -> u32 {
    // The exponent and two bits of the mantissa.
    return min((bitcast<u32>(f32(star + 1u)) >> 21u) - (127u << 2u), RANKS - 1u);
}
