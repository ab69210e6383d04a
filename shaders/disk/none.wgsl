// No disk: nothing is crossed and nothing shines.

fn record_crossing(result: ptr<function, Trace>, segment: Segment) {}

fn shift_hits(result: ptr<function, Trace>, energy: f32, lambda: f32) {}

fn disk_light(hit: Hit) -> vec3<f32> {
    return vec3<f32>(0.0);
}
