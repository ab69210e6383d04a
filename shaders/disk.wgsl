// The thin disk: where a ray crosses it, and how much its matter's motion shifts the light.

const HAS_DISK: bool = true;

// Bisections of a crossing's bracket.
const BISECTIONS: u32 = 10u;

// The cubic that has the segment's positions and velocities at its ends (Hermite), at a share t of
// its length.
fn hermite(segment: Segment, t: f32) -> vec3<f32> {
    let s = 1.0 - t;
    return (s * s * (1.0 + 2.0 * t)) * segment.x0 + (t * t * (3.0 - 2.0 * t)) * segment.x1
        + (segment.h * s * t) * (s * segment.v0 - t * segment.v1);
}

// Whether a step from the height z0 to z1 crosses the plane. A crossing belongs to the step within
// which or at whose end it lies, never to the one that starts there: so none counts twice, and a
// camera in the plane does not see the disk at its own place. A ray in the plane has no crossing.
fn crosses_plane(z0: f32, z1: f32) -> bool {
    return z0 != 0.0 && (z1 == 0.0 || (z0 > 0.0) != (z1 > 0.0));
}

fn in_annulus(r: f32) -> bool {
    return r > scene.disk_inner && r < scene.disk_outer;
}

// Where the segment crosses the plane, if it does.
fn plane_crossing(segment: Segment, crosses: bool) -> vec3<f32> {
    let above = segment.x0.z > 0.0;
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
    return hermite(segment, 0.5 * (low + high));
}

// Adds the segment's crossing of the annulus, if it has one, where positions are r n; its g is left
// to shift_hits.
fn record_crossing(result: ptr<function, Trace>, segment: Segment) {
    let crosses = crosses_plane(segment.x0.z, segment.x1.z) && (*result).hit_count < MAX_HITS;
    let position = plane_crossing(segment, crosses);
    if crosses && in_annulus(length(position)) {
        if (*result).hit_count == 0u {
            (*result).hits[0].position = position;
        } else {
            (*result).hits[1].position = position;
        }
        (*result).hit_count += 1u;
    }
}

// Observed over emitted frequency of light from matter on a circular orbit (Cunningham 1975;
// Bardeen, Press & Teukolsky 1972 eqs. 2.12, 2.13 and 2.16 for the orbit), with y = sqrt(M / r) and
// lambda = L/E:
//
//   g = 1 / (E u^t (1 - Omega lambda)),   Omega = y^3 / (M (1 + chi y^3)),
//   u^t = (1 + chi y^3) / sqrt(1 - 3 y^2 + 2 chi y^3)
//
// E is per unit frequency for the camera. The article's 1 + Omega L_n is the same: its L_n is that
// of the backward ray, which is -lambda. The root's argument is taken as (1 - y)^2 (1 + 2 y) - 2 (1
// - chi) y^3, which keeps its digits for chi -> 1, r -> M (crates/lightfall-core/src/geometry/kerr.rs has the same).
fn disk_redshift(r: f32, energy: f32, lambda: f32) -> f32 {
    let outside = max(r, MASS);
    let y = sqrt(MASS / outside);
    let y3 = y * y * y;
    let one_minus_y = (outside - MASS) / (outside * (1.0 + y));
    let root2 = one_minus_y * one_minus_y * (1.0 + 2.0 * y) - 2.0 * scene.spin_gap * y3;
    // 1 + chi y^3, with chi = a / M.
    let stretch = 1.0 + scene.spin_length / MASS * y3;
    let omega = y3 / (MASS * stretch);
    let g = sqrt(max(root2, TINY)) / (stretch * max(energy * (1.0 - omega * lambda), 1e-6));
    return disk_shift(g, r, lambda);
}

// Adds a crossing of the annulus, in order; E is per unit frequency for the camera, lambda = L/E.
// What comes after the last that matters is left out.
fn add_hit(result: ptr<function, Trace>, position: vec3<f32>, energy: f32, lambda: f32) {
    let hit = Hit(position, disk_redshift(length(position), energy, lambda));
    if (*result).hit_count == 0u {
        (*result).hits[0] = hit;
    } else if (*result).hit_count == 1u {
        (*result).hits[1] = hit;
    }
    (*result).hit_count = min((*result).hit_count + 1u, MAX_HITS);
}

// Gives the recorded crossings their g.
fn shift_hits(result: ptr<function, Trace>, energy: f32, lambda: f32) {
    (*result).hits[0].g = disk_redshift(length((*result).hits[0].position), energy, lambda);
    (*result).hits[1].g = disk_redshift(length((*result).hits[1].position), energy, lambda);
}
