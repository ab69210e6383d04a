// The light that the nodes of a chunk add: thermal radiation, whose source in the middle of an opaque layer
// is that of the surface of the thin disk.
//
// Gives: emission.

// The radiance of an opaque body at one of four places, as the camera sees it. The flux F in the
// matter's frame has the temperature T_scale F^(1/4). `factor` is that of the structure.
fn body_light(r: f32, g: f32, factor: f32) -> vec3<f32> {
    let flux = disk_flux(r) * factor;
    return thermal_colour(scene.disk.temperature * sqrt(sqrt(flux)) * g) * (flux * beaming_factor(g));
}

// The light of four places of the step, of which `share` arrives, where g is the whole shift of their light.
fn emission(way: Way, shares: vec4<f32>, photon: Photon, at: Places, share: vec4<f32>, factor: vec4<f32>, shift: vec4<f32>) -> vec3<f32> {
    let source = (scene.disk.brightness * share) * source_function(at.r, at.n_z, at.opening);
    let g = medium_shift(photon, at.r, at.n_z, shift);
    var light = vec3<f32>(0.0);
    for (var lane = 0u; lane < 4u; lane++) {
        let arriving = source[lane] * body_light(at.r[lane], g[lane], factor[lane]);
        weigh(way, shares[lane], at.r[lane], at.n_z[lane], shift[lane], arriving);
        light += arriving;
    }
    return light;
}
