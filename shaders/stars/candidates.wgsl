// The candidates: which stars may have an image in which cell of the mesh. Smooth cells, whose map to
// the sky is known from the mesh alone, have a list of their own.
//
// Needs: nothing.
// Gives: FROM_MIDDLE, MAX_STARTS, ROUGH, SMOOTH, STAR_BITS, WIDE, WIDEST.

// The lists, one after the other: each has room for `mesh.capacity` candidates. The last two hold cells
// alone: those whose stars are still to be found.
const SMOOTH: u32 = 0u;
const ROUGH: u32 = 1u;
const WIDE: u32 = 2u;
const WIDEST: u32 = 3u;

// A candidate is two numbers: that of the cell, and that of the star with, in its upper bits, the
// places from which the image is looked for: one for each triangle of the cell, and its middle.
const STAR_BITS: u32 = 29u;
const MAX_STARTS: u32 = 3u;
const FROM_MIDDLE: u32 = 4u;
