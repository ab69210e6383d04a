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
    // The footprint's covariance in (ln r, phi - Omega t, n_z), in units in which the filter's exponent is
    // q.P.q in powers of two: its diagonal, and twice the other components (12, 13, 23).
    spread: vec3<f32>,
    mixed: vec3<f32>,
}

// The rates of azimuth and delay for each unit of the step's share, at four nodes: the azimuth's own, with
// chi' = a (E - W/D), and delay.wgsl's plain form.
struct Rates {
    turning: vec4<f32>,
    slowing: vec4<f32>,
    // The slopes of u and n_z.
    inward: vec4<f32>,
    upward: vec4<f32>,
}

fn rates_at_nodes(way: Way, shares: vec4<f32>, at: Places) -> Rates {
    let c = way.path;
    let m = way.motion;
    let a = scene.hole.a;
    let v = 1.0 / at.r - m.base;
    let energies = (m.w.x + v * (m.w.y + v * m.w.z)) / max(m.d.x + v * (m.d.y + v * m.d.z), vec4<f32>(TINY));
    let x = c.c0.z + shares * (c.c1.z + shares * (c.c2.z + shares * (c.c3.z + shares * (c.c4.z + shares * c.c5.z))));
    let y = c.c0.w + shares * (c.c1.w + shares * (c.c2.w + shares * (c.c3.w + shares * (c.c4.w + shares * c.c5.w))));
    let c2 = 2.0 * c.c2;
    let c3 = 3.0 * c.c3;
    let c4 = 4.0 * c.c4;
    let c5 = 5.0 * c.c5;
    let dx = c.c1.z + shares * (c2.z + shares * (c3.z + shares * (c4.z + shares * c5.z)));
    let dy = c.c1.w + shares * (c2.w + shares * (c3.w + shares * (c4.w + shares * c5.w)));
    let inward = c.c1.x + shares * (c2.x + shares * (c3.x + shares * (c4.x + shares * c5.x)));
    let upward = c.c1.y + shares * (c2.y + shares * (c3.y + shares * (c4.y + shares * c5.y)));
    let swept = (x * dy - y * dx) / max(x * x + y * y, vec4<f32>(TINY));
    let turning = swept + (a * way.h) * (m.constants.energy - energies);
    let twist = a * a * m.constants.energy * at.n_z * at.n_z - m.constants.drag;
    return Rates(turning, way.h * ((at.r * at.r + a * a) * energies + twist), inward, upward);
}

// A node of which a `part` of the step belongs to it. `turns` and `delay` are those of the node.
fn matter_place(way: Way, share: f32, part: f32, r: f32, n_z: f32, turns: f32, delay: f32, rates: vec4<f32>) -> MatterPlace {
    let a = scene.hole.a;
    let y2 = MASS * inverseSqrt(r * r);
    let y3 = y2 * sqrt(y2);
    let stretch = 1.0 + a / MASS * y3;
    let omega = y3 / (MASS * stretch);
    // A line of length one has the variance 1/12.
    let scale = select(0.0, sqrt(0.5 * 1.442695 / 12.0), MEDIUM_FILTERS);
    let tangent = vec3<f32>(-rates.z * r, rates.x, rates.w);
    let along = (scale * part) * vec3<f32>(tangent.x, rates.x + omega * rates.y, tangent.z);
    let y = curve_at(way.path, share);
    let right = scale * deviation_at(way.neighbours.right, share, y, 1.0 / r, tangent);
    let below = scale * deviation_at(way.neighbours.below, share, y, 1.0 / r, tangent);
    return MatterPlace(
        log(r),
        turns,
        n_z,
        delay,
        omega,
        1.5 * omega / stretch,
        along * along + right * right + below * below,
        2.0 * (along.xxy * along.yzz + right.xxy * right.yzz + below.xxy * below.yzz),
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
            let filtered = k * (at.spread.x * k + at.mixed.x * waves.m + at.mixed.y * kappa)
                + waves.m * (at.spread.y * waves.m + at.mixed.z * kappa) + at.spread.z * kappa * kappa;
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

// The depth of a lump that the filter took away, over the depth of a chunk of such matter. Fitted: with it, the
// mean light of disks seen at 60 and 83 degrees is within 1 % of that of 36 rays a pixel.
const LUMP_DEPTH: f32 = 1.5;

// exp(sigma f) over its mean, for the flux and for the density, of a node with this smooth depth.
//
// Where one field makes matter dense and bright, light comes from the bright places. The filter took away a
// part of the field, with some variance; its mean light is that of lumps with the values -sqrt(3), 0 and
// sqrt(3) times its standard deviation (Gauss-Hermite nodes), each weighted by what it absorbs.
fn factors_of(sums: vec3<f32>, depth: f32) -> vec2<f32> {
    let sigma = vec2<f32>(thick_disk.flux_spread, thick_disk.density_spread);
    let sigma2 = sigma * sigma;
    let factors = exp(sigma * sums.x - 0.25 * sigma2 * (sums.y - 0.0625 * sigma2 * sums.z));
    if !MEDIUM_FILTERS {
        return factors;
    }
    let variance = max(1.0 - 0.5 * sums.y, 0.0);
    let spread = 1.7320508 * sqrt(variance) * sigma;
    let mean = exp(-0.5 * variance * sigma2);
    let dense = exp(spread);
    let sparse = 1.0 / dense;
    let lump = LUMP_DEPTH * f32(MEDIUM_NODES) * depth * factors.y * mean.y;
    let absorbed = vec3<f32>(4.0, 1.0, 1.0) * (1.0 - exp(-lump * vec3<f32>(1.0, dense.y, sparse.y)));
    let all = absorbed.x + absorbed.y + absorbed.z;
    let brighter = mean.x * dot(absorbed, vec3<f32>(1.0, dense.x, sparse.x)) / max(all, TINY);
    return vec2<f32>(factors.x * select(1.0, brighter, all > 1e-5), factors.y);
}

// The factors at the nodes of a chunk between two shares of the step. Azimuth and delay at the nodes are
// those at the chunk's start and the integrals of the polynomials through their rates.
fn matter_factors(way: Way, ends: vec2<f32>, places: array<Places, MEDIUM_BLOCKS>) -> array<Factors, MEDIUM_BLOCKS> {
    var at = places;
    var node_places = MEDIUM_PLACES;
    var node_weights = MEDIUM_WEIGHTS;
    var partial = MEDIUM_PARTIAL;
    let width = ends.y - ends.x;
    let first = curve_at(way.path, ends.x);
    let turns = turns_at(way, ends.x, first);
    // A chunk may begin beyond the outer edge, where nothing depends on the delay, and at u = 0 there is none.
    let v = max(first.x, 0.5 / scene.disk.outer - way.motion.base);
    let delay = way.delay + crossing_delay(way.motion, way.step, way.h, ends.x, v);
    var rates: array<Rates, MEDIUM_BLOCKS>;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        rates[i] = rates_at_nodes(way, ends.x + width * node_places[i], at[i]);
    }
    var factors: array<Factors, MEDIUM_BLOCKS>;
    for (var i = 0u; i < MEDIUM_BLOCKS; i++) {
        var turned = vec4<f32>(0.0);
        var slowed = vec4<f32>(0.0);
        for (var j = 0u; j < MEDIUM_BLOCKS; j++) {
            turned += partial[i * MEDIUM_BLOCKS + j] * rates[j].turning;
            slowed += partial[i * MEDIUM_BLOCKS + j] * rates[j].slowing;
        }
        let shares = ends.x + width * node_places[i];
        let parts = width * node_weights[i];
        let all_turns = turns + (width * 0.5 / PI) * turned;
        let delays = delay + width * slowed;
        for (var lane = 0u; lane < 4u; lane++) {
            let own = vec4<f32>(rates[i].turning[lane], rates[i].slowing[lane], rates[i].inward[lane], rates[i].upward[lane]);
            let place = matter_place(way, shares[lane], parts[lane], at[i].r[lane], at[i].n_z[lane], all_turns[lane], delays[lane], own);
            let found = factors_of(waves_at(place), parts[lane] * at[i].rate[lane]);
            factors[i].flux[lane] = found.x;
            factors[i].density[lane] = found.y;
        }
    }
    return factors;
}
