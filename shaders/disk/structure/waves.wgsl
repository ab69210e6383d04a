// Structure of the disk's light: shearing waves in rings that rotate with the matter.
// optics/structure explains the model; the twin in f64 is
// crates/lightfall-core/tests/physics/structure_field.rs.
//
// Gives: structure_factor.

// One wave of each of four octaves: their azimuthal wave numbers, and the radial ones in radians
// per unit of ln r.
struct Group {
    m: vec4<f32>,
    k: vec4<f32>,
}

struct Structure {
    // ln r of the first ring's centre, rings per unit of ln r, and the last ring's number.
    start: f32,
    rings_per_ln_r: f32,
    last_ring: f32,
    // Standard deviation of the logarithm of the flux.
    contrast: f32,
    // Groups in a ring, and one over it.
    group_count: u32,
    group_share: f32,
    // Amplitude of each octave's waves.
    amplitudes: vec4<f32>,
    rings: array<Ring, MAX_RINGS>,
    // The groups of the first ring, then those of the second, and so on.
    groups: array<Group, MAX_RINGS * MAX_GROUPS>,
}

struct Ring {
    // ln r of its centre.
    centre: f32,
    // 1/T and T/(2 pi), where T is the life of its waves.
    lives_per_time: f32,
    life_over_turn: f32,
    // The fraction of the present life that has passed on its clock.
    lives: f32,
    // The place of each octave's phases of this life in the list of phases; of life 0 where the
    // structure repeats.
    phase_places: vec4<u32>,
    // Where the structure repeats: the number of this life in the period, and the lives of a
    // period.
    number: f32,
    cycle: f32,
}

@group(0) @binding(BINDING_STRUCTURE) var<uniform> structure: Structure;

// Distance between the places of an octave's neighbouring waves in the list of phases.
const GROUP_STRIDE: u32 = 0x9e3779b9u;

// The births of a group's waves, in units of the time between groups.
const BIRTHS: vec4<f32> = vec4<f32>(0.0, 0.25, 0.5, 0.75);

// cos(pi s) for |s| <= 1/2; the error is at most 8e-6. Twice its square less one is cos(2 pi s),
// with an error of at most 3.2e-5.
fn cos_half_turns(s: vec4<f32>) -> vec4<f32> {
    let y = s * s;
    return (0.25 - y) * (3.99996873 + y * (1.21780146 * y - 3.73545675));
}

// Random phases in turns, from -1/2 to 1/2: the integer hash that Wellons found by search
// (lowbias32, 2018). Its upper bits become the fraction of a number from 1 to 2, faster than by a
// conversion.
fn phases_at(places: vec4<u32>) -> vec4<f32> {
    var z = places;
    z = (z ^ (z >> vec4<u32>(16u))) * 0x7feb352du;
    z = (z ^ (z >> vec4<u32>(15u))) * 0x846ca68bu;
    z ^= z >> vec4<u32>(16u);
    return bitcast<vec4<f32>>((z >> vec4<u32>(9u)) ^ vec4<u32>(0x3fc00000u)) - 1.5;
}

// The number of a life in the list of phases; `whole` counts lives from the ring's present one. The
// half keeps the quotient away from whole numbers.
fn life_number(ring: Ring, whole: f32) -> u32 {
    var number = whole;
    if REPEATS {
        number += ring.number;
        number -= ring.cycle * floor((number + 0.5) / ring.cycle);
    }
    return bitcast<u32>(i32(number));
}

// The factor by which the structure multiplies the flux. The mean over all phases is one.
//
// The filter's exponents are in powers of two: covariance is P log2(e)/2, where P = J J^T/12 is
// that of the footprint in (ln r, phi), from differences of positions, because azimuths jump by a
// turn. A neighbour farther away than MAX_DX or MAX_DPHI belongs to another image of the disk, and
// is ignored.
fn structure_factor(hit: Hit, footprint: Footprint) -> f32 {
    let p = hit.position.xy;
    let r2 = max(dot(p, p), MASS * MASS);
    let right = footprint.to_the_right.xy;
    let down = footprint.downward.xy;
    let all_dx = vec2<f32>(dot(p, right), dot(p, down)) / r2;
    let all_dphi = vec2<f32>(p.x * right.y - p.y * right.x, p.x * down.y - p.y * down.x) / r2;
    let same_image = abs(all_dx) < vec2<f32>(MAX_DX) & abs(all_dphi) < vec2<f32>(MAX_DPHI);
    let dx = select(vec2<f32>(0.0), all_dx, same_image);
    let dphi = select(vec2<f32>(0.0), all_dphi, same_image);
    let covariance = vec3<f32>(dot(dx, dx), 2.0 * dot(dx, dphi), dot(dphi, dphi)) * (0.5 * 1.442695 / 12.0);

    let x = 0.5 * log_precise(r2);
    let turns = atan2_precise(p.y, p.x) * (0.5 / PI);
    // Omega and -dOmega/dln r (Bardeen, Press & Teukolsky 1972 eq. 2.16).
    let y2 = MASS * inverseSqrt(r2);
    let y3 = y2 * sqrt(y2);
    let stretch = 1.0 + scene.hole.a / MASS * y3;
    let omega = y3 / (MASS * stretch);
    let shear = 1.5 * omega / stretch;

    // One ring contributes, or two where they overlap.
    let place = clamp((x - structure.start) * structure.rings_per_ln_r, 0.0, structure.last_ring);
    let inner = floor(place);
    // The share of the outer ring, s in the weights cos(pi s/2) and sin(pi s/2).
    let share = clamp(2.0 * (place - inner) - 0.5, 0.0, 1.0);
    let smooth_share = 0.5 * share * share * (3.0 - 2.0 * share);
    let weights = cos_half_turns(vec4<f32>(smooth_share, 0.5 - smooth_share, 0.0, 0.0)).xy;
    let first_side = select(0u, 1u, share >= 1.0);
    let last_side = select(0u, 1u, share > 0.0);

    var value = 0.0;
    var squares = 0.0;
    var fourth_powers = 0.0;
    for (var side = first_side; side <= last_side; side++) {
        let index = min(u32(inner) + side, MAX_RINGS - 1u);
        let ring = structure.rings[index];
        let weight = select(weights.x, weights.y, side == 1u);
        let lives = ring.lives - hit.delay * ring.lives_per_time;
        let whole = floor(lives);
        let life = life_number(ring, whole);
        let to_next_life = vec4<u32>(life_number(ring, whole + 1.0) - life);
        let phase_places = ring.phase_places + life;
        let swept = omega * ring.life_over_turn;
        let sheared = shear * ring.life_over_turn * (2.0 * PI);
        let offset = (x - ring.centre) * (0.5 / PI);
        // 1.6329932 is sqrt(8/3), which makes the mean square of cos^2 one.
        let amplitudes = structure.amplitudes * (1.6329932 * weight);
        let groups = min(structure.group_count, MAX_GROUPS);
        for (var group = 0u; group < groups; group++) {
            let waves = structure.groups[index * MAX_GROUPS + group];
            let m = waves.m;
            // The births of the groups' waves are spread over a life.
            let count = (lives - whole) + (f32(group) + BIRTHS) * structure.group_share;
            let counted = count >= vec4<f32>(1.0);
            let age = count - select(vec4<f32>(0.5), vec4<f32>(1.5), counted);
            let window = cos_half_turns(age);
            let sheared_k = waves.k + m * (sheared * age);
            let filtered = (covariance.x * sheared_k + covariance.y * m) * sheared_k + covariance.z * m * m;
            let amplitude = amplitudes * (window * window) * exp2(-filtered);
            let places = phase_places + group * GROUP_STRIDE + select(vec4<u32>(0u), to_next_life, counted);
            let phase = m * (turns - swept * age) + waves.k * offset + phases_at(places);
            let wave = cos_half_turns(phase - round(phase));
            let power = amplitude * amplitude;
            value += dot(amplitude, 2.0 * wave * wave - 1.0);
            squares += dot(power, vec4<f32>(1.0));
            fourth_powers += dot(power, power);
        }
    }
    let sigma = structure.contrast;
    let mean = 0.25 * sigma * sigma * (squares - 0.0625 * sigma * sigma * fourth_powers);
    return exp(sigma * value - mean);
}
