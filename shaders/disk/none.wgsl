// No disk: no ray has a hit.
//
// Gives: HAS_DISK, add_hit, crosses_plane, disk_cover, disk_light, disk_transmission,
//     hit_footprints, in_annulus, near_annulus, plane_crossing, record_crossing, segment_delay,
//     shift_hits.

const HAS_DISK: bool = false;

fn crosses_plane(z0: f32, z1: f32) -> bool {
    return false;
}

fn in_annulus(r: f32) -> bool {
    return false;
}

fn near_annulus(r: f32) -> bool {
    return false;
}

fn plane_crossing(segment: Segment, crosses: bool) -> vec4<f32> {
    return vec4<f32>(0.0);
}

fn segment_delay(segment: Segment, share: f32) -> f32 {
    return 0.0;
}

fn record_crossing(result: ptr<function, Trace>, segment: Segment) {}

fn add_hit(result: ptr<function, Trace>, position: vec3<f32>, energy: f32, lambda: f32, delay: f32) {}

fn shift_hits(result: ptr<function, Trace>, energy: f32, lambda: f32) {}

fn disk_cover(r: f32) -> f32 {
    return 0.0;
}

fn disk_transmission(r: f32) -> f32 {
    return 1.0;
}

fn hit_footprints(ray: Trace) -> Footprints {
    let none = Footprint(vec3<f32>(0.0), vec3<f32>(0.0));
    return Footprints(none, none);
}

fn disk_light(photon: Photon, hit: Hit, footprint: Footprint) -> vec3<f32> {
    return vec3<f32>(0.0);
}
