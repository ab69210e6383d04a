// Computes the light of a star's image and adds the image to the list, which has no fixed order.
//
// Gives: add_image.

// The size of an indirect dispatch over the images in the list, and the number of images, including
// those for which the list has no room.
struct ImageCount {
    groups_x: atomic<u32>,
    groups_y: u32,
    groups_z: u32,
    images: atomic<u32>,
}

@group(0) @binding(BINDING_STAR_IMAGES) var<storage, read_write> star_images: array<StarImage>;
@group(0) @binding(BINDING_STAR_COUNT) var<storage, read_write> image_count: ImageCount;

// Adds the image seen in `direction` (right, up, forward), unless it is outside the picture or the
// side that is searched, or too faint.
fn add_image(star: u32, order: u32, direction: vec3<f32>, magnification: f32) {
    if !is_own_image(direction) {
        return;
    }
    let photon = photon_from(direction);
    let g = min(sky_shift(photon), MAX_SHIFT);
    let gain = magnification * beaming_factor(g);
    let light = star_list[star].light;
    let luminous = unpacked_flux(light) * gain;
    if !is_at_least(luminous, stars.flux_limit) {
        return;
    }
    let temperature = unpacked_temperature(light);
    let flux = luminous / max(dot(thermal_colour(temperature), LUMINANCE), 1e-6);
    let index = atomicAdd(&image_count.images, 1u);
    if index < min(stars.capacity, arrayLength(&star_images)) {
        star_images[index] = StarImage(in_picture(direction), flux, temperature * g, star, order);
        atomicMax(&image_count.groups_x, index / WORKGROUP_SIZE + 1u);
    }
}
