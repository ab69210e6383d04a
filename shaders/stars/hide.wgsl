// Dims the images of stars that lie behind the disk, by the ray of each. A kernel of its own, because
// few stars have an image in the picture: where neighbouring stars share their instructions, one of
// them would make all wait for its ray.
//
// Needs: BINDING_STAR_COUNT, BINDING_STAR_IMAGES, StarImage, WORKGROUP_SIZE, disk_transmission,
//     photon_from, stars, trace.
// Gives: hide.

@group(0) @binding(BINDING_STAR_IMAGES) var<storage, read_write> star_images: array<StarImage>;
// As in add_image.wgsl; the last number counts the images.
@group(0) @binding(BINDING_STAR_COUNT) var<storage, read> image_count: vec4<u32>;

// One invocation for each image. How its ray ends is known, at the star, and next to the shadow's
// edge better known than the ray tells.
@compute @workgroup_size(WORKGROUP_SIZE)
fn hide(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= min(image_count.w, min(stars.capacity, arrayLength(&star_images))) {
        return;
    }
    let ray = trace(photon_from(star_images[id.x].direction));
    let first = disk_transmission(length(ray.hits[0].position));
    let second = disk_transmission(length(ray.hits[1].position));
    star_images[id.x].flux *= select(1.0, first, ray.hit_count > 0u) * select(1.0, second, ray.hit_count > 1u);
}
