// The disk model `newtonian`: relative flux F = (r_in / r)^3 (1 - sqrt(r_in / r)), without torque
// at the inner edge (Shakura & Sunyaev 1973). Zero inside the edge.
//
// Gives: disk_flux.

fn disk_flux(r: f32) -> f32 {
    let x = scene.disk.inner / max(r, TINY);
    return max(x * x * x * (1.0 - sqrt(x)), 0.0);
}
