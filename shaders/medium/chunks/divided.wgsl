// Chunks of a ray that may be divided, to see how much the light changes.
//
// Gives: chunk_parts, parts_of_chunk.

// At most 2.
var<private> chunk_parts: u32 = 1u;

fn parts_of_chunk() -> u32 {
    return min(chunk_parts, 2u);
}
