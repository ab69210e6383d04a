// No disk: no ray crosses anything and nothing shines.
//
// Needs: Hit, Segment, Trace.
// Gives: HAS_DISK, add_hit, crosses_plane, disk_cover, disk_light, disk_transmission, in_annulus,
//     plane_crossing, record_crossing, shift_hits.

const HAS_DISK: bool = false;

fn crosses_plane(z0: f32, z1: f32) -> bool {
    return false;
}

fn in_annulus(r: f32) -> bool {
    return false;
}

fn plane_crossing(segment: Segment, crosses: bool) -> vec3<f32> {
    return vec3<f32>(0.0);
}

fn record_crossing(result: ptr<function, Trace>, segment: Segment) {}

fn add_hit(result: ptr<function, Trace>, position: vec3<f32>, energy: f32, lambda: f32) {}

fn shift_hits(result: ptr<function, Trace>, energy: f32, lambda: f32) {}

fn disk_cover(r: f32) -> f32 {
    return 0.0;
}

fn disk_transmission(r: f32) -> f32 {
    return 1.0;
}

fn disk_light(hit: Hit) -> vec3<f32> {
    return vec3<f32>(0.0);
}
