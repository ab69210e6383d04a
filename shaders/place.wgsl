// Where a pixel lies in the whole picture.
//
// Gives: corner_of, place_of.

// The middle of a pixel of the part that is drawn, in pixels from the upper left corner of the whole
// picture. The sum is one of integers, so a part gets exactly the places of the whole picture. A part of
// a picture whose columns go around may reach beyond the last column, where the first one follows.
fn place_of(pixel: vec2<u32>) -> vec2<f32> {
    return shown_place(corner_of(pixel) + 0.5);
}

// The upper left corner of a pixel of the part, in pixels from that of the whole picture.
fn corner_of(pixel: vec2<u32>) -> vec2<f32> {
    return vec2<f32>(pixel + scene.picture.origin);
}
