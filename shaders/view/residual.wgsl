// The view `residual`: the largest residual of the null constraint along the ray, on a logarithmic
// scale from black at 1e-8 or less through violet, orange and yellow to white at 1 or more, one
// colour every two powers of ten. A method in closed form has no residual. The residual is not the
// error of the ray.
//
// Gives: light_along.

fn residual_colour(residual: f32) -> vec3<f32> {
    let position = clamp(0.5 * log2(max(residual, 1e-8)) * LOG10_2 + 4.0, 0.0, 4.0);
    var colour = mix(vec3<f32>(0.0), vec3<f32>(0.10, 0.01, 0.25), clamp(position, 0.0, 1.0));
    colour = mix(colour, vec3<f32>(0.75, 0.12, 0.04), clamp(position - 1.0, 0.0, 1.0));
    colour = mix(colour, vec3<f32>(0.95, 0.65, 0.02), clamp(position - 2.0, 0.0, 1.0));
    return mix(colour, vec3<f32>(1.0), clamp(position - 3.0, 0.0, 1.0));
}

fn light_along(photon: Photon) -> vec4<f32> {
    return mark(residual_colour(trace(photon).residual));
}
