// A hot spot in the disk, which orbits with the matter. The twin in f64 is
// crates/lightfall-core/tests/physics/hot_spot_flux.rs.
//
// Gives: hot_spot_factor.

struct HotSpot {
    // One over the radius of its middle, and the angular velocity there.
    inverse_r: f32,
    angular_velocity: f32,
    // The azimuth of its middle at the disk's time less scene.observer.time_lead, in (-pi, pi], and
    // the time from hot_spot.time to then. The elapsed time matters only where it is precise.
    azimuth: f32,
    elapsed: f32,
    // Standard deviation, as a share of the radius; the flux that it adds, relative to the disk's;
    // and one over the standard deviation in time, zero if it always shines.
    size: f32,
    strength: f32,
    inverse_duration: f32,
    // The finest structure of a sheared spot, as a share of the radius.
    finest: f32,
}

@group(0) @binding(BINDING_HOT_SPOT) var<uniform> hot_spot: HotSpot;

// The angle less whole turns: 2 pi in two parts, the first with few digits (Cody & Waite 1980).
fn less_whole_turns(angle: f32) -> f32 {
    let turns = round(angle / (2.0 * PI));
    return (angle - turns * 6.28125) - turns * 1.93530718e-3;
}

// The sum of exp(-psi^2 / (2 v)) over all turns of psi, which is in [-pi, pi]: over turns, or over
// waves (Poisson's formula), whichever needs few terms. Those omitted are below 3e-6 of the sum.
fn gaussian_on_circle(psi: f32, v: f32) -> f32 {
    let turns = vec3<f32>(psi - 2.0 * PI, psi, psi + 2.0 * PI);
    let over_turns = dot(exp(-0.5 / v * turns * turns), vec3<f32>(1.0));
    let q = exp(-0.5 * v);
    let c = sin_cos_precise(psi).y;
    let over_waves = sqrt(v / (2.0 * PI)) * (1.0 + 2.0 * q * (c + q * q * q * (2.0 * c * c - 1.0)));
    return select(over_waves, over_turns, v < 3.0);
}

// The ratio of the flux to that of the disk alone.
fn hot_spot_factor(hit: Hit) -> f32 {
    let r = length(hit.position);
    let x = log_precise(r * hot_spot.inverse_r);
    // From hot_spot.time to the emission.
    let since = hot_spot.elapsed - hit.delay;
    var psi = atan2_precise(hit.position.y, hit.position.x) - hot_spot.azimuth
        + hot_spot.angular_velocity * hit.delay;
    var v = square(hot_spot.size);
    if SHEARED_SPOT {
        // The spot is blurred over the finest structure, across which rates differ by `shear`.
        let omega = angular_velocity(r);
        let shear = 1.5 * omega * (1.0 - scene.hole.a * omega) * hot_spot.finest;
        psi -= (omega - hot_spot.angular_velocity) * since;
        v += square(shear * since);
    }
    let along = hot_spot.size * inverseSqrt(v) * gaussian_on_circle(less_whole_turns(psi), v);
    let across = exp(-0.5 * square(x / hot_spot.size));
    let envelope = exp(-0.5 * square(since * hot_spot.inverse_duration));
    return 1.0 + hot_spot.strength * envelope * across * along;
}
