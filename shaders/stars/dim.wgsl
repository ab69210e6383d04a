// Dims the images of stars behind the disk or the jets, with a ray for each image. In a kernel over all stars,
// most invocations would wait for a neighbour's ray.
//
// Gives: dim.

@group(0) @binding(BINDING_STAR_IMAGES) var<storage, read_write> star_images: array<StarImage>;
// As in add_image.wgsl; the last number counts the images.
@group(0) @binding(BINDING_STAR_COUNT) var<storage, read> image_count: vec4<u32>;

// The outcome of the ray is ignored: next to the shadow's edge rounding may change it.
@compute @workgroup_size(WORKGROUP_SIZE)
fn dim(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= min(image_count.w, min(stars.capacity, arrayLength(&star_images))) {
        return;
    }
    star_images[id.x].flux *= transmission_along(photon_from(star_images[id.x].direction));
}
