// The thin disk: where a ray crosses it, and how the motion of its matter shifts the light.
//
// Gives: HAS_DISK, add_hit, angular_velocity, crosses_plane, in_annulus, near_annulus,
//     plane_crossing, record_crossing, segment_delay, shift_hits, whole_redshift.

const HAS_DISK: bool = true;

// Bisections of the interval that contains a crossing.
const BISECTIONS: u32 = 10u;

// Hermite's cubic through the segment's ends with the velocities there, at the share t of its
// length.
fn hermite(segment: Segment, t: f32) -> vec3<f32> {
    let s = 1.0 - t;
    return (s * s * (1.0 + 2.0 * t)) * segment.x0 + (t * t * (3.0 - 2.0 * t)) * segment.x1
        + (segment.h * s * t) * (s * segment.v0 - t * segment.v1);
}

// Whether a step from the height z0 to z1 crosses the plane. A crossing belongs to the step that
// contains it or ends at it, as optics/reference.rs explains.
fn crosses_plane(z0: f32, z1: f32) -> bool {
    return z0 != 0.0 && (z1 == 0.0 || (z0 > 0.0) != (z1 > 0.0));
}

fn in_annulus(r: f32) -> bool {
    return r > scene.disk.inner && r < scene.disk.outer;
}

// Whether a crossing near this radius may be in the annulus: the cubic through a step of
// kerr-schild is wrong by less than a thousandth of the radius.
fn near_annulus(r: f32) -> bool {
    return r > 0.95 * scene.disk.inner && r < 1.05 * scene.disk.outer;
}

// The point where the segment crosses the plane, and its share of the length. Meaningless if
// `crosses` is false.
fn plane_crossing(segment: Segment, crosses: bool) -> vec4<f32> {
    let above = segment.x0.z > 0.0;
    var low = 0.0;
    var high = 1.0;
    // Drivers that execute both sides of a branch still skip a loop of zero length.
    let bisections = select(0u, BISECTIONS, crosses);
    for (var i = 0u; i < bisections; i++) {
        let middle = 0.5 * (low + high);
        let beyond = (hermite(segment, middle).z > 0.0) != above;
        low = select(middle, low, beyond);
        high = select(high, middle, beyond);
    }
    let share = 0.5 * (low + high);
    return vec4<f32>(hermite(segment, share), share);
}

// The delay after a share of the segment, by the trapezoidal rule.
fn segment_delay(segment: Segment, share: f32) -> f32 {
    let rates = segment.delay_rates;
    return segment.delay + segment.h * share * (rates.x + 0.5 * share * (rates.y - rates.x));
}

// Records the segment's crossing of the annulus, if any, for methods whose positions are r n;
// without g, which shift_hits computes later.
fn record_crossing(result: ptr<function, Trace>, segment: Segment) {
    let crosses = crosses_plane(segment.x0.z, segment.x1.z) && (*result).hit_count < MAX_HITS;
    let crossing = plane_crossing(segment, crosses);
    if crosses && in_annulus(length(crossing.xyz)) {
        let hit = Hit(crossing.xyz, 0.0, segment_delay(segment, crossing.w) - scene.observer.time_lead);
        if (*result).hit_count == 0u {
            (*result).hits[0] = hit;
        } else {
            (*result).hits[1] = hit;
        }
        (*result).hit_count += 1u;
    }
}

// 1 + chi y^3, with y = sqrt(M / r) and chi = a / M.
fn orbit_stretch(y3: f32) -> f32 {
    return 1.0 + scene.hole.a / MASS * y3;
}

// Angular velocity of matter on a circular orbit: Omega = y^3 / (M (1 + chi y^3)).
fn angular_velocity(r: f32) -> f32 {
    let y = sqrt(MASS / max(r, MASS));
    let y3 = y * y * y;
    return y3 / (MASS * orbit_stretch(y3));
}

// Observed over emitted frequency of light from matter on a circular orbit (Cunningham 1975;
// Bardeen, Press & Teukolsky 1972 eqs. 2.12, 2.13 and 2.16 for the orbit), with y = sqrt(M / r) and
// lambda = L/E:
//
//   g = 1 / (E u^t (1 - Omega lambda)),   u^t = (1 + chi y^3) / sqrt(1 - 3 y^2 + 2 chi y^3)
//
// The article's 1 + Omega L_n is the same: its L_n belongs to the backward ray and is -lambda. The
// root's argument keeps its digits for chi -> 1, r -> M as (1 - y)^2 (1 + 2 y) - 2 (1 - chi) y^3.
fn whole_redshift(r: f32, energy: f32, lambda: f32) -> f32 {
    let outside = max(r, MASS);
    let y = sqrt(MASS / outside);
    let y3 = y * y * y;
    let one_minus_y = (outside - MASS) / (outside * (1.0 + y));
    let root2 = one_minus_y * one_minus_y * (1.0 + 2.0 * y) - 2.0 * scene.hole.one_minus_spin * y3;
    let slowing = max(energy * (1.0 - angular_velocity(r) * lambda), 1e-6);
    return sqrt(max(root2, TINY)) / (orbit_stretch(y3) * slowing);
}

// whole_redshift without the effects that are switched off.
fn disk_redshift(r: f32, energy: f32, lambda: f32) -> f32 {
    return disk_shift(whole_redshift(r, energy, lambda), r, lambda);
}

// Appends a crossing of the annulus, except after MAX_HITS.
fn add_hit(result: ptr<function, Trace>, position: vec3<f32>, energy: f32, lambda: f32, delay: f32) {
    let hit = Hit(position, disk_redshift(length(position), energy, lambda), delay);
    if (*result).hit_count == 0u {
        (*result).hits[0] = hit;
    } else if (*result).hit_count == 1u {
        (*result).hits[1] = hit;
    }
    (*result).hit_count = min((*result).hit_count + 1u, MAX_HITS);
}

// Computes the g of the recorded crossings.
fn shift_hits(result: ptr<function, Trace>, energy: f32, lambda: f32) {
    (*result).hits[0].g = disk_redshift(length((*result).hits[0].position), energy, lambda);
    (*result).hits[1].g = disk_redshift(length((*result).hits[1].position), energy, lambda);
}
