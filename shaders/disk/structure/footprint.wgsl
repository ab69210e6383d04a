// The footprints of a pixel on the disk, from the hits of the neighbouring pixels.
//
// Needs: Footprint, Footprints, Trace.
// Gives: hit_footprints.

fn footprint_of(position: vec3<f32>) -> Footprint {
    return Footprint(dpdx(position), dpdy(position));
}

fn shorter(a: Footprint, b: Footprint) -> Footprint {
    let right = dot(a.to_the_right, a.to_the_right) <= dot(b.to_the_right, b.to_the_right);
    let down = dot(a.downward, a.downward) <= dot(b.downward, b.downward);
    return Footprint(select(b.to_the_right, a.to_the_right, right), select(b.downward, a.downward, down));
}

// The footprints of both hits. All pixels must call it, before any branch. Where an image of the
// disk ends in front of another one, the neighbour's hit in that other image has another number
// from the front, but the same one from the back. Where the neighbour has no hit in the same image,
// the difference is huge, and structure_factor leaves it out.
fn hit_footprints(ray: Trace) -> Footprints {
    let two = ray.hit_count > 1u;
    let last = footprint_of(select(ray.hits[0].position, ray.hits[1].position, two));
    let first = footprint_of(ray.hits[0].position);
    let second = footprint_of(ray.hits[1].position);
    if two {
        return Footprints(first, shorter(second, last));
    }
    return Footprints(shorter(first, last), second);
}
