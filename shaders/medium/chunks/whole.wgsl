// Chunks of a ray as the rules of the depth have them.
//
// Gives: parts_of_chunk.

fn parts_of_chunk() -> u32 {
    return 1u;
}
