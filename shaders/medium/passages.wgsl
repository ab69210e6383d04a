// What reaches the camera through matter with depth along each of an array of rays, for tests, measurements
// and the channels of pictures.
//
// Gives: GivenRay, passages.

// A ray, and those of the next pixels: unit looking directions.
struct GivenRay {
    direction: vec3<f32>,
    right: vec3<f32>,
    below: vec3<f32>,
}

struct PassageRecord {
    light: vec3<f32>,
    transmission: f32,
    ray: Trace,
    samples: u32,
    // How much the light changes with twice the samples.
    error: f32,
    // The luminance of the light, and the means of its places: light_sums.
    luminance: f32,
    means: vec4<f32>,
}

@group(0) @binding(BINDING_INPUT) var<storage, read> given_rays: array<GivenRay>;
@group(0) @binding(BINDING_OUTPUT) var<storage, read_write> passage_records: array<PassageRecord>;

@compute @workgroup_size(WORKGROUP_SIZE)
fn passages(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&given_rays) || id.x >= arrayLength(&passage_records) {
        return;
    }
    given_ray = given_rays[id.x];
    let photon = photon_from(given_ray.direction);
    chunk_parts = 2u;
    let finer = passage(photon);
    chunk_parts = 1u;
    light_sums = LightSums(0.0, vec4<f32>(0.0));
    let seen = passage(photon);
    passage_records[id.x] = PassageRecord(
        seen.light,
        seen.transmission,
        seen.ray,
        seen.samples,
        light_change(seen.light, finer.light),
        light_sums.luminance,
        light_sums.places / max(light_sums.luminance, TINY),
    );
}
