// The light of point sources on each pixel, as the star passes have summed it.
//
// Gives: point_light.

// Red, green and blue of each square in units of starlight.light_unit. A square is a pixel, except
// in very large pictures.
@group(0) @binding(BINDING_STAR_SUMS) var<storage, read> star_sums: array<u32>;

// Light of the point sources whose images fall on a pixel. It is added to the pixel once, after its
// rays are averaged, and no offset of the rays moves it.
fn point_light(pixel: vec2<u32>) -> vec3<f32> {
    let at = vec2<u32>((vec2<f32>(pixel) + 0.5) * starlight.squares_per_pixel);
    let first = 3u * (at.y * starlight.columns + at.x);
    let sums = vec3<u32>(star_sums[first], star_sums[first + 1u], star_sums[first + 2u]);
    return starlight.light_unit * vec3<f32>(sums);
}
