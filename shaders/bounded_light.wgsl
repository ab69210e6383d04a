// Light as the picture can hold it.
//
// Gives: bounded_light.

// Below the largest half float, with room for the sums that bloom makes.
const MAX_LIGHT: f32 = 60000.0;

// Light that is not positive, or NaN, is none.
fn bounded_light(light: vec3<f32>) -> vec3<f32> {
    return select(vec3<f32>(0.0), min(light, vec3<f32>(MAX_LIGHT)), are_positive(light));
}
