// The view `order`: the order of the image, which is the number of whole half-turns about the hole
// up to the first source on the ray, disk or sky. Order 0 is grey, 1 orange, 2 blue, 3 and more
// white, which colour-blind people can tell apart. The sky is darker than the disk. A ray that ends
// at the horizon without a crossing is black.
//
// Gives: light_along.

fn order_colour(order: f32) -> vec3<f32> {
    var colour = vec3<f32>(0.20);
    colour = select(colour, vec3<f32>(0.79, 0.35, 0.0), order >= 1.0);
    colour = select(colour, vec3<f32>(0.0, 0.17, 0.45), order >= 2.0);
    return select(colour, vec3<f32>(0.95), order >= 3.0);
}

fn light_along(photon: Photon) -> vec4<f32> {
    let ray = trace(photon);
    let seen = ray.hit_count > 0u;
    if ray.outcome == OUTCOME_UNFINISHED && !seen {
        return mark(MAGENTA);
    }
    if ray.outcome == OUTCOME_CAPTURED && !seen {
        return mark(vec3<f32>(0.0));
    }
    // A camera in the disk's plane sees the disk after whole half-turns, which count as the lower
    // order.
    return mark(select(0.25, 1.0, seen) * order_colour(floor((ray.turn - 1e-5) / PI)));
}
