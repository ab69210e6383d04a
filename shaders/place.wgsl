// Where a pixel lies in the whole picture.
//
// Gives: corner_of, place_of.

// The middle of a pixel of the part that is drawn, in pixels from the upper left corner of the whole
// picture. The sum is one of integers, so a part gets exactly the places of the whole picture.
fn place_of(pixel: vec2<u32>) -> vec2<f32> {
    return corner_of(pixel) + 0.5;
}

// The upper left corner of a pixel of the part, in pixels of the whole picture. A part of a picture whose
// columns go around may reach beyond the last column, where the first one follows.
fn corner_of(pixel: vec2<u32>) -> vec2<f32> {
    let at = pixel + scene.picture.origin;
    return vec2<f32>(vec2<u32>(at.x % max(u32(scene.picture.whole.x), 1u), at.y));
}
