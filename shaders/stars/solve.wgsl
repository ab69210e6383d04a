// Finds the images of each star by inversion: a function gives the star's image of each order.
//
// Gives: solve.

// One invocation for each star.
@compute @workgroup_size(WORKGROUP_SIZE)
fn solve(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let star = id.y * groups.x * WORKGROUP_SIZE + id.x;
    if star >= min(stars.counts[0], arrayLength(&star_list)) {
        return;
    }
    let direction = star_list[star].direction;
    // Relative to the nearer direction on the line through the camera and the hole.
    let outward = -dot(direction, stars.behind);
    let side = select(1.0, -1.0, outward > 0.0);
    let off = vec4<f32>(direction - side * stars.behind, side);
    let on_axes = vec3<f32>(outward, dot(stars.along_theta, off), dot(stars.along_phi, off));
    for (var order = 0u; order < STAR_ORDERS; order++) {
        // The counts do not grow with the order.
        if star >= stars.counts[order] {
            break;
        }
        let image = frame_image(on_axes, order);
        if image.w > 0.0 {
            let one_seen = vec4<f32>(1.0, image.xyz);
            let seen = vec3<f32>(dot(stars.right, one_seen), dot(stars.up, one_seen), dot(stars.forward, one_seen));
            // Solid angles go with the inverse square of the frequency.
            let frequency = dot(stars.frequency, one_seen);
            add_image(star, order, safe_normalize(seen), image.w / max(frequency * frequency, 1e-30));
        }
    }
}
