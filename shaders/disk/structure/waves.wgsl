// Structure of the light of a disk without thickness. disk/structure/field.wgsl has its waves; the twin
// in f64 is optics/structure/field.rs.
//
// Gives: structure_factor.

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
