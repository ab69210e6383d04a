// The source of a scattering layer whose faces emit the flux F. The twin in f64, which gives the
// sources, is optics/medium/source.rs.
//
// Gives: source_function.

// The source function over F/pi.
fn source_function(r: vec4<f32>, n_z: vec4<f32>, opening: vec4<f32>) -> vec4<f32> {
    let zeta = clamp(n_z / max(opening, vec4<f32>(TINY)), vec4<f32>(-1.0), vec4<f32>(1.0));
    let z2 = zeta * zeta;
    // The share of the column between the middle and zeta, twice.
    let column = (35.0 / 16.0) * zeta * (1.0 - z2 * (1.0 - z2 * (0.6 - z2 / 7.0)));
    let from_face = 0.25 * vertical_depth(r) * max(1.0 - column * column, vec4<f32>(0.0));
    return thick_disk.emission_scale * (0.41344 + 0.12829 * sqrt(from_face) + 0.7434 * from_face + thick_disk.thin_emission);
}
