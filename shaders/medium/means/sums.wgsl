// Where the light of matter comes from: sums over its places, weighted by the luminance that reaches the
// camera.
//
// Gives: LightSums, light_sums, weigh.

struct LightSums {
    luminance: f32,
    // Radius, height above the plane, observed over emitted frequency, and delay, times the luminance.
    places: vec4<f32>,
}

var<private> light_sums: LightSums;

// ITU-R BT.709-6, item 3.2.
const LUMINANCE: vec3<f32> = vec3<f32>(0.2126, 0.7152, 0.0722);

// Adds the light that reaches the camera from a place of the step.
fn weigh(way: Way, share: f32, r: f32, n_z: f32, g: f32, light: vec3<f32>) {
    let luminance = dot(LUMINANCE, light);
    let delay = way.delay + crossing_delay(way.motion, way.step, way.h, share, 1.0 / r - way.motion.base);
    light_sums.luminance += luminance;
    light_sums.places += luminance * vec4<f32>(r, r * n_z, g, delay);
}
