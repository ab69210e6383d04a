// The field of the disk's structure: shearing waves in rings that rotate with the matter.
// optics/structure explains the model; the twin in f64 is optics/structure/field.rs.
//
// Gives: BIRTHS, GROUP_STRIDE, cos_half_turns, life_number, phases_at, structure.

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
