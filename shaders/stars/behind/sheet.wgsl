// How much light from behind comes through a disk without thickness.
//
// Gives: transmission_along.

fn transmission_along(photon: Photon) -> f32 {
    let ray = trace(photon);
    let first = disk_transmission(length(ray.hits[0].position));
    let second = disk_transmission(length(ray.hits[1].position));
    return select(1.0, first, ray.hit_count > 0u) * select(1.0, second, ray.hit_count > 1u);
}
