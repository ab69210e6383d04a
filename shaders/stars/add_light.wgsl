// What the kernels share that add the light of images of stars to squares: the images, their profile
// and the sums. Sums are whole numbers, so the order of additions does not matter.
//
// Gives: add_light, image_count, image_light, profile, star_images.

// Maximum light of an image on a square, in units: eight of them fit into a sum.
const MAX_UNITS: f32 = 536870912.0;

@group(0) @binding(BINDING_STAR_IMAGES) var<storage, read> star_images: array<StarImage>;
// As in add_image.wgsl; the last number counts the images.
@group(0) @binding(BINDING_STAR_COUNT) var<storage, read> image_count: vec4<u32>;
// Red, green and blue of each square, row by row.
@group(0) @binding(BINDING_STAR_SUMS) var<storage, read_write> star_sums: array<atomic<u32>>;

// The light of an image, in units.
fn image_light(image: StarImage) -> vec3<f32> {
    return thermal_colour(image.temperature) * (image.flux * scene.sky.brightness * stars.unit);
}

// The cubic B-spline of a width: zero at twice the width from its middle.
fn profile(distance: f32, width: f32) -> f32 {
    let x = abs(distance) / width;
    let wide = max(2.0 - x, 0.0);
    let narrow = max(1.0 - x, 0.0);
    return wide * wide * wide - 4.0 * narrow * narrow * narrow;
}

// Adds light to a square, given as its number in the order of the sums.
fn add_light(square: u32, light: vec3<f32>) {
    let units = select(vec3<f32>(0.0), min(light, vec3<f32>(MAX_UNITS)), are_positive(light));
    let index = 3u * square;
    if index + 2u < arrayLength(&star_sums) {
        let rounded = vec3<u32>(units + 0.5);
        atomicAdd(&star_sums[index], rounded.x);
        atomicAdd(&star_sums[index + 1u], rounded.y);
        atomicAdd(&star_sums[index + 2u], rounded.z);
    }
}
