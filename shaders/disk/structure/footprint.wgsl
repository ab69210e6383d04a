// The footprints of a ray on the disk, from the hits of the neighbouring rays.
//
// Gives: hit_footprints.

fn shorter(a: Footprint, b: Footprint) -> Footprint {
    let right = dot(a.to_the_right, a.to_the_right) <= dot(b.to_the_right, b.to_the_right);
    let down = dot(a.downward, a.downward) <= dot(b.downward, b.downward);
    return Footprint(select(b.to_the_right, a.to_the_right, right), select(b.downward, a.downward, down));
}

// The footprints of both hits. All rays must call it before any branch. Where one image of the disk
// ends in front of another, a neighbour's hit in the same image has another index from the front,
// but the same one from the back. A difference between images is huge; structure_factor ignores it.
fn hit_footprints(ray: Trace) -> Footprints {
    let two = ray.hit_count > 1u;
    let last = differences(select(ray.hits[0].position, ray.hits[1].position, two));
    let first = differences(ray.hits[0].position);
    let second = differences(ray.hits[1].position);
    if two {
        return Footprints(first, shorter(second, last));
    }
    return Footprints(shorter(first, last), second);
}
