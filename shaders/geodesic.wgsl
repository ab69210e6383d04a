// The picture's fragment entry: the light of each pixel. view/traced.wgsl takes a pixel to a
// photon, a ray and its light; view/error.wgsl reads a table instead.
//
// Needs: light_at.
// Gives: fragment.

// Below the largest half float, with room for the sums that bloom makes.
const MAX_LIGHT: f32 = 60000.0;

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let seen = light_at(position.xy);
    // Comparisons with NaN are false, so no NaN leaves the shader.
    let light = select(vec3<f32>(0.0), min(seen.rgb, vec3<f32>(MAX_LIGHT)), seen.rgb > vec3<f32>(0.0));
    return vec4<f32>(light, seen.a);
}
