// The thin disk: where a ray crosses it, and how much its matter's motion shifts the light.

const HAS_DISK: bool = true;

// Bisections of a crossing's bracket.
const BISECTIONS: u32 = 10u;

// The cubic that has the segment's positions and velocities at its ends (Hermite), at a share t of its length.
fn hermite(segment: Segment, t: f32) -> vec3<f32> {
    let s = 1.0 - t;
    return (s * s * (1.0 + 2.0 * t)) * segment.x0 + (t * t * (3.0 - 2.0 * t)) * segment.x1
        + (segment.h * s * t) * (s * segment.v0 - t * segment.v1);
}

// Adds the segment's crossing of the annulus, if it has one; its g is left to shift_hits. A crossing belongs to the
// segment within which or at whose end it lies, never to the one that starts there: so none counts twice, and a camera
// in the plane does not see the disk at its own place. A ray in the plane has no crossing.
fn record_crossing(result: ptr<function, Trace>, segment: Segment) {
    let above = segment.x0.z > 0.0;
    let z1 = segment.x1.z;
    let crosses = segment.x0.z != 0.0 && (z1 == 0.0 || above != (z1 > 0.0)) && (*result).hit_count < 2u;
    var low = 0.0;
    var high = 1.0;
    // No turns where nothing is crossed: drivers that mask both sides of a branch do skip a loop.
    let turns = select(0u, BISECTIONS, crosses);
    for (var i = 0u; i < turns; i++) {
        let middle = 0.5 * (low + high);
        let beyond = (hermite(segment, middle).z > 0.0) != above;
        low = select(middle, low, beyond);
        high = select(high, middle, beyond);
    }
    let position = hermite(segment, 0.5 * (low + high));
    let r2 = dot(position, position);
    if crosses && r2 > square(scene.disk_inner) && r2 < square(scene.disk_outer) {
        if (*result).hit_count == 0u {
            (*result).hits[0].position = position;
        } else {
            (*result).hits[1].position = position;
        }
        (*result).hit_count += 1u;
    }
}

// Observed over emitted frequency of light from matter on a circular orbit (Cunningham 1975; for the orbit Bardeen,
// Press & Teukolsky 1972 eqs. 2.12 to 2.16 without spin):
//
//   g = 1 / (E u^t (1 - Omega lambda)),   Omega = sqrt(M / r^3),   u^t = 1 / sqrt(1 - 3 M / r),   lambda = L/E
//
// E is per unit frequency for the camera. The article's 1 + Omega L_n is the same: its L_n is that of the backward ray,
// which is -lambda.
fn disk_redshift(r: f32, energy: f32, lambda: f32) -> f32 {
    let m_over_r = MASS / max(r, 1.0);
    let omega = m_over_r * sqrt(m_over_r) / MASS;
    let inverse_ut = sqrt(max(1.0 - 3.0 * m_over_r, TINY));
    return disk_shift(inverse_ut / (energy * max(1.0 - omega * lambda, 1e-4)), r, lambda);
}

// Adds a crossing of the annulus, in order; E is per unit frequency for the camera, lambda = L/E. What comes after the
// second is left out.
fn add_hit(result: ptr<function, Trace>, position: vec3<f32>, energy: f32, lambda: f32) {
    let hit = Hit(position, disk_redshift(length(position), energy, lambda));
    if (*result).hit_count == 0u {
        (*result).hits[0] = hit;
    } else if (*result).hit_count == 1u {
        (*result).hits[1] = hit;
    }
    (*result).hit_count = min((*result).hit_count + 1u, 2u);
}

// Gives the recorded crossings their g.
fn shift_hits(result: ptr<function, Trace>, energy: f32, lambda: f32) {
    (*result).hits[0].g = disk_redshift(length((*result).hits[0].position), energy, lambda);
    (*result).hits[1].g = disk_redshift(length((*result).hits[1].position), energy, lambda);
}
