// The ray's differential: how far the rays of the next pixels are from it, to first order. Structure is
// filtered by it, in every entry that has neighbours, without asking them.
//
// The deviation e of a neighbour follows the linearised equations of mino_motion.wgsl,
//
//   e_u''  = e_u (A + u dA/du) + u dA,   A = 2 B W - K' S,   dA = 2 dB W + 2 B (dE + dB u^2) - dK' S,
//   e_z''  = dp n_z + p e_z,             p = stiffness - 2 axial n_z^2,
//   e_xy'' = (dp - d axial) n_xy + (p - axial) e_xy,
//
// with one kick in the middle of each step. d is the difference of the two rays' constants. The
// deviation along the ray is no part of the footprint, so a difference in Mino time does not matter, and
// that of chi is left out.
//
// Gives: Neighbour, Neighbours, carried, deviation_at, neighbours_of.

// The state of a neighbour and its slope times the step, and its constants, less those of the ray.
struct Neighbour {
    y: vec4<f32>,
    dy: vec4<f32>,
    // E, B, K', and the stiffness and the axial constant.
    energies: vec3<f32>,
    polar: vec2<f32>,
}

struct Neighbours {
    right: Neighbour,
    below: Neighbour,
}

// The neighbour whose photon differs by this much.
fn neighbour(photon: Photon, change: PhotonChange, orbit: KerrRay, ray: Ray, h: f32) -> Neighbour {
    var beside_photon = photon;
    beside_photon.energy += change.energy;
    beside_photon.radial += change.radial;
    beside_photon.w += change.w;
    let beside = kerr_ray(beside_photon);
    let c = beside.constants;
    let o = orbit.constants;
    let dy = h * vec4<f32>(beside.scale * (photon.radial + change.radial), -beside.w.z, -beside.w.xy);
    let energies = vec3<f32>(c.energy - o.energy, c.drag - o.drag, c.k_prime - o.k_prime);
    let polar = vec2<f32>(c.stiffness - o.stiffness, c.axial - o.axial);
    return Neighbour(vec4<f32>(0.0), dy - ray.dy, energies, polar);
}

// All rays must call it before any branch.
fn neighbours_of(photon: Photon, orbit: KerrRay, ray: Ray, h: f32) -> Neighbours {
    let changes = photon_changes(photon);
    return Neighbours(
        neighbour(photon, changes[0], orbit, ray, h),
        neighbour(photon, changes[1], orbit, ray, h),
    );
}

// The neighbour at the end of the ray's step.
fn carried_neighbour(n: Neighbour, way: Way, middle: vec4<f32>) -> Neighbour {
    let m = way.motion;
    let c = m.constants;
    let v = middle.x;
    let u = m.base + v;
    let e = n.y + 0.5 * n.dy;
    let w = quadratic(m.w, v);
    let s = quadratic(m.s, v);
    let a = 2.0 * c.drag * w - c.k_prime * s;
    let a_u = 2.0 * c.drag * (m.w.y + 2.0 * m.w.z * v) - c.k_prime * (m.s.y + 2.0 * m.s.z * v);
    let da = 2.0 * n.energies.y * w + 2.0 * c.drag * (n.energies.x + n.energies.y * u * u) - n.energies.z * s;
    let p = c.stiffness - 2.0 * c.axial * middle.y * middle.y;
    let dp = n.polar.x - 2.0 * n.polar.y * middle.y * middle.y - 4.0 * c.axial * middle.y * e.y;
    let kick = vec4<f32>(
        e.x * (a + u * a_u) + u * da,
        dp * middle.y + p * e.y,
        (dp - n.polar.y) * middle.zw + (p - c.axial) * e.zw,
    );
    let dy = n.dy + way.h * way.h * kick;
    return Neighbour(e + 0.5 * dy, dy, n.energies, n.polar);
}

fn carried(way: Way) -> Neighbours {
    let middle = curve_at(way.path, 0.5);
    return Neighbours(carried_neighbour(way.neighbours.right, way, middle), carried_neighbour(way.neighbours.below, way, middle));
}

// The deviation of a neighbour in (ln r, phi, n_z), across the ray whose tangent is `along`, where the ray
// has the state y. Lengths are those of a sphere with the radius one.
fn deviation_at(n: Neighbour, share: f32, y: vec4<f32>, u: f32, along: vec3<f32>) -> vec3<f32> {
    let e = n.y + share * n.dy;
    let across2 = max(dot(y.zw, y.zw), TINY);
    let deviation = vec3<f32>(-e.x / u, (y.z * e.w - y.w * e.z) / across2, e.y);
    let metric = vec3<f32>(1.0, across2, 1.0 / across2);
    let share_along = dot(metric * along, deviation) / max(dot(metric * along, along), TINY);
    return deviation - share_along * along;
}
