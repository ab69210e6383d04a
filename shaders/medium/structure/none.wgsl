// Matter without structure.
//
// Gives: matter_factors.

fn matter_factors(way: Way, ends: vec2<f32>, places: array<Places, MEDIUM_BLOCKS>) -> array<Factors, MEDIUM_BLOCKS> {
    var factors: array<Factors, MEDIUM_BLOCKS>;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        factors[i] = Factors(vec4<f32>(1.0), vec4<f32>(1.0));
    }
    return factors;
}
