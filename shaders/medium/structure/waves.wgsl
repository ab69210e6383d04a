// Structure of matter with depth: the waves of disk/structure/field.wgsl with a third wave number, along
// the normal. One field decides where the matter is dense and where it is bright. The twin in f64 is
// optics/structure/field.rs.
//
// Gives: matter_factors.

@group(0) @binding(BINDING_WAVE_HEIGHTS) var<uniform> wave_heights: array<vec4<f32>, MAX_RINGS * MAX_GROUPS>;

// A node in the coordinates that turn with the matter.
struct MatterPlace {
    // ln r, the azimuth in turns, and n_z.
    x: f32,
    turns: f32,
    n_z: f32,
    delay: f32,
    // Omega of the circular orbit, and -dOmega/dln r (Bardeen, Press & Teukolsky 1972 eq. 2.16).
    omega: f32,
    shear: f32,
    // What the node stands for in (ln r, phi - Omega t, n_z): its part of the ray, and the way across it to
    // the neighbours at the right and below.
    along: vec3<f32>,
    right: vec3<f32>,
    below: vec3<f32>,
}

// Azimuth in turns, where the ray has the state y.
fn turns_at(way: Way, share: f32, y: vec4<f32>) -> f32 {
    var angle = way.chi;
    if SPINNING {
        angle = add_angle(angle, azimuth_gain(way.motion, way.path, way.h, share, y.x, way.regular, way.ingoing));
        if way.ingoing {
            angle = add_angle(angle, azimuth_lag_to_infinity(way.motion, y.x));
        }
    }
    return (atan2_precise(y.w, y.z) + wrap_angle(angle)) * (0.5 / PI);
}

// A place on the way, of which a node stands for this `part` of the step.
fn matter_place(way: Way, share: f32, part: f32, r: f32) -> MatterPlace {
    let y = curve_at(way.path, share);
    let slope = curve_slope(way.path, share);
    let a = scene.hole.a;
    let u = max(way.motion.base + y.x, TINY);
    let y2 = MASS * inverseSqrt(r * r);
    let y3 = y2 * sqrt(y2);
    let stretch = 1.0 + a / MASS * y3;
    let omega = y3 / (MASS * stretch);
    // The rates of azimuth and delay: chi' = a (E - W/D), and delay.wgsl's plain form.
    let energies = quadratic(way.motion.w, y.x) / max(quadratic(way.motion.d, y.x), TINY);
    let swept = (y.z * slope.w - y.w * slope.z) / max(dot(y.zw, y.zw), TINY);
    let turning = swept + a * way.h * (way.motion.constants.energy - energies);
    let slowing = (1.0 / (u * u) + a * a) * energies - way.motion.constants.drag + a * a * way.motion.constants.energy * y.y * y.y;
    let change = vec3<f32>(-slope.x / u, turning + omega * way.h * slowing, slope.y);
    let delay = way.delay + crossing_delay(way.motion, way.step, way.h, share, y.x);
    let tangent = vec3<f32>(change.x, turning, change.z);
    let right = deviation_at(way.neighbours.right, share, y, u, tangent);
    let below = deviation_at(way.neighbours.below, share, y, u, tangent);
    // The filter's exponents are in powers of two, and a line of length one has the variance 1/12.
    let scale = select(0.0, sqrt(0.5 * 1.442695 / 12.0), MEDIUM_FILTERS);
    return MatterPlace(
        log_precise(r),
        turns_at(way, share, y),
        y.y,
        delay,
        omega,
        1.5 * omega / stretch,
        (scale * part) * change,
        scale * right,
        scale * below,
    );
}

// f, and the sums of the squares and of the fourth powers of the amplitudes.
fn waves_at(at: MatterPlace) -> vec3<f32> {
    let place = clamp((at.x - structure.start) * structure.rings_per_ln_r, 0.0, structure.last_ring);
    let inner = floor(place);
    let share = clamp(2.0 * (place - inner) - 0.5, 0.0, 1.0);
    let smooth_share = 0.5 * share * share * (3.0 - 2.0 * share);
    let weights = cos_half_turns(vec4<f32>(smooth_share, 0.5 - smooth_share, 0.0, 0.0)).xy;
    let first_side = select(0u, 1u, share >= 1.0);
    let last_side = select(0u, 1u, share > 0.0);
    var sums = vec3<f32>(0.0);
    for (var side = first_side; side <= last_side; side++) {
        let index = min(u32(inner) + side, MAX_RINGS - 1u);
        let ring = structure.rings[index];
        let weight = select(weights.x, weights.y, side == 1u);
        let lives = ring.lives - at.delay * ring.lives_per_time;
        let whole = floor(lives);
        let life = life_number(ring, whole);
        let to_next_life = vec4<u32>(life_number(ring, whole + 1.0) - life);
        let phase_places = ring.phase_places + life;
        let swept = at.omega * ring.life_over_turn;
        let sheared = at.shear * ring.life_over_turn * (2.0 * PI);
        let offset = (at.x - ring.centre) * (0.5 / PI);
        let height = at.n_z * (0.5 / PI);
        // 1.6329932 is sqrt(8/3), which makes the mean square of cos^2 one.
        let amplitudes = structure.amplitudes * (1.6329932 * weight);
        let groups = min(structure.group_count, MAX_GROUPS);
        for (var group = 0u; group < groups; group++) {
            let waves = structure.groups[index * MAX_GROUPS + group];
            let kappa = wave_heights[index * MAX_GROUPS + group];
            // The births of the groups' waves are spread over a life.
            let count = (lives - whole) + (f32(group) + BIRTHS) * structure.group_share;
            let counted = count >= vec4<f32>(1.0);
            let age = count - select(vec4<f32>(0.5), vec4<f32>(1.5), counted);
            let window = cos_half_turns(age);
            let k = waves.k + waves.m * (sheared * age);
            let along = at.along.x * k + at.along.y * waves.m + at.along.z * kappa;
            let right = at.right.x * k + at.right.y * waves.m + at.right.z * kappa;
            let below = at.below.x * k + at.below.y * waves.m + at.below.z * kappa;
            let filtered = along * along + right * right + below * below;
            let amplitude = amplitudes * (window * window) * exp2(-filtered);
            let places = phase_places + group * GROUP_STRIDE + select(vec4<u32>(0u), to_next_life, counted);
            let phase = waves.m * (at.turns - swept * age) + waves.k * offset + kappa * height + phases_at(places);
            let wave = cos_half_turns(phase - round(phase));
            let power = amplitude * amplitude;
            sums += vec3<f32>(dot(amplitude, 2.0 * wave * wave - 1.0), dot(power, vec4<f32>(1.0)), dot(power, power));
        }
    }
    return sums;
}

// exp(sigma f) over its mean, for the flux and for the density.
fn factors_of(sums: vec3<f32>) -> vec2<f32> {
    let sigma = vec2<f32>(thick_disk.flux_spread, thick_disk.density_spread);
    let sigma2 = sigma * sigma;
    return exp(sigma * sums.x - 0.25 * sigma2 * (sums.y - 0.0625 * sigma2 * sums.z));
}

// The factors at four nodes, of which each stands for this part of the step.
fn matter_factors(way: Way, shares: vec4<f32>, parts: vec4<f32>, at: Places) -> Factors {
    let x = factors_of(waves_at(matter_place(way, shares.x, parts.x, at.r.x)));
    let y = factors_of(waves_at(matter_place(way, shares.y, parts.y, at.r.y)));
    let z = factors_of(waves_at(matter_place(way, shares.z, parts.z, at.r.z)));
    let w = factors_of(waves_at(matter_place(way, shares.w, parts.w, at.r.w)));
    return Factors(vec4<f32>(x.x, y.x, z.x, w.x), vec4<f32>(x.y, y.y, z.y, w.y));
}
