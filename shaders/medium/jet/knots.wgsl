// Strands and knots of the jets: waves that travel with the matter. The twin in f64, which has the
// equations, is optics/medium/jet/knots.rs.
//
// Gives: Patterns, jet_factor.

// Four waves. Phases are in turns: so are the frequency for each r_s/c, and the numbers along and across
// for each unit of ln r and of the place across the jet.
struct JetWaves {
    frequency: vec4<f32>,
    about: vec4<f32>,
    along: vec4<f32>,
    across: vec4<f32>,
    // At the scene's clock, of the jet above the disk and of the one below.
    phases_above: vec4<f32>,
    phases_below: vec4<f32>,
    amplitude: vec4<f32>,
}

struct Patterns {
    // ln r of the first entry of the table of travel times, and entries for each unit of ln r.
    start: f32,
    per_ln_r: f32,
    // The square of the place across the jet within which waves about the axis vanish.
    axis: f32,
    // Standard deviations of the logarithm of the emission: by strands, by knots in the spine, and by knots
    // in the sheath.
    strands: f32,
    knots: f32,
    sheath_knots: f32,
    // The time of a pattern's way from the base and its turn about the axis, in turns; two entries in a row.
    travel: array<vec4<f32>, JET_TRAVEL_ROWS>,
    waves: array<JetWaves, JET_WAVE_ROWS>,
}

// The change of a wave's coordinates along a line: time, azimuth in turns, ln r, and place across the jet.
fn pattern_change(change: vec4<f32>, travel_rate: vec2<f32>, across_rate: vec2<f32>) -> vec4<f32> {
    return vec4<f32>(
        -change.w - travel_rate.x * change.x,
        change.y * (0.5 / PI) - travel_rate.y * change.x,
        change.x,
        across_rate.x * change.x + across_rate.y * change.z,
    );
}

// cos of an angle in turns, of any number of them, with an error of at most 3.2e-5.
fn cos_turns(turns: vec4<f32>) -> vec4<f32> {
    let s = turns - round(turns);
    let y = s * s;
    let half = (0.25 - y) * (3.99996873 + y * (1.21780146 * y - 3.73545675));
    return 2.0 * half * half - 1.0;
}

// exp(sigma f) over its mean, where `sums` has the value of the field f and the sums of its amplitudes'
// squares and fourth powers.
fn wave_factor(sums: vec3<f32>, sigma: f32) -> f32 {
    let sigma2 = sigma * sigma;
    return exp(sigma * sums.x - 0.25 * sigma2 * (sums.y - 0.0625 * sigma2 * sums.z));
}

// The brightness of the spine, which a pixel spreads over its own width. Of the pixel's sides, `right` and
// `below`, the azimuth and the place across the jet are in the unit of the filter's exponents.
fn spread_spine(x: f32, right: vec4<f32>, below: vec4<f32>) -> f32 {
    let sides = vec4<f32>(right.w, below.w, x * (2.0 * PI) * right.y, x * (2.0 * PI) * below.y);
    // The variance across the jet, twice: the exponents have 2 pi^2 / ln 2 of it.
    let spread = dot(sides, sides) * (0.6931472 / (PI * PI));
    let widening = 1.0 + spread * jet.inverse_spine_width2;
    return jet.spine * inverseSqrt(widening) * exp(-x * x * jet.inverse_spine_width2 / widening);
}

fn travel_entry(place: u32) -> vec2<f32> {
    let row = jet.patterns.travel[place / 2u];
    return select(row.xy, row.zw, place % 2u == 1u);
}

// The factor of a node's emission, where `part` of the step belongs to it. Its mean is one.
fn jet_factor(way: Way, share: f32, part: f32, r: f32, stream: f32, y: vec4<f32>, slope: vec4<f32>) -> f32 {
    let u = max(way.motion.base + y.x, TINY);
    let ln_r = log_precise(r);
    let place = clamp((ln_r - jet.patterns.start) * jet.patterns.per_ln_r, 0.0, f32(2u * JET_TRAVEL_ROWS - 1u));
    let low = min(u32(place), 2u * JET_TRAVEL_ROWS - 2u);
    let entry = travel_entry(low);
    let to_next = travel_entry(low + 1u) - entry;
    let travel = entry + (place - f32(low)) * to_next;
    let travel_rate = to_next * jet.patterns.per_ln_r;

    let x = sqrt(stream);
    let elapsed = -(way.delay + crossing_delay(way.motion, way.step, way.h, share, y.x)) - travel.x;
    let turns = turns_at(way, share, y) - travel.y;
    // dx = x/2 (kappa d ln r - d|n_z| / (1 - |n_z|)).
    let across_rate = vec2<f32>(0.5 * x * jet.kappa, -sign(y.y) * 0.5 * exp2(jet.kappa * log2(r)) * jet.inverse_width / max(x, 0.02));
    let change = change_at(way, y, slope);
    // The filter's exponents are in powers of two; a line of length one has the variance 1/12.
    let scale = select(0.0, (2.0 * PI) * sqrt(0.5 * 1.442695 / 12.0), MEDIUM_FILTERS);
    let along = (scale * part) * pattern_change(change, travel_rate, across_rate);
    let right = scale * pattern_change(vec4<f32>(deviation_at(way.neighbours.right, share, y, u, change.xyz), 0.0), travel_rate, across_rate);
    let below = scale * pattern_change(vec4<f32>(deviation_at(way.neighbours.below, share, y, u, change.xyz), 0.0), travel_rate, across_rate);

    let off_axis = 0.5 * log2(max(stream, 1e-12) / (stream + jet.patterns.axis));
    // Of strands and of knots the value, and the sums of the amplitudes' squares and fourth powers.
    var strands = vec3<f32>(0.0);
    var knots = vec3<f32>(0.0);
    for (var i = 0u; i < JET_WAVE_ROWS; i++) {
        let wave = jet.patterns.waves[i];
        let first = along.x * wave.frequency + along.y * wave.about + along.z * wave.along + along.w * wave.across;
        let second = right.x * wave.frequency + right.y * wave.about + right.z * wave.along + right.w * wave.across;
        let third = below.x * wave.frequency + below.y * wave.about + below.z * wave.along + below.w * wave.across;
        let filtered = first * first + second * second + third * third;
        let amplitude = wave.amplitude * exp2(abs(wave.about) * off_axis - filtered);
        let phases = select(wave.phases_above, wave.phases_below, y.y < 0.0);
        let phase = phases + elapsed * wave.frequency + turns * wave.about + ln_r * wave.along + x * wave.across;
        let power = amplitude * amplitude;
        let sums = vec3<f32>(dot(amplitude, cos_turns(phase)), dot(power, vec4<f32>(1.0)), dot(power, power));
        let is_strand = i < JET_STRAND_ROWS;
        strands += select(vec3<f32>(0.0), sums, is_strand);
        knots += select(sums, vec3<f32>(0.0), is_strand);
    }
    let in_sheath = wave_factor(strands, jet.patterns.strands) * wave_factor(knots, jet.patterns.sheath_knots);
    let parts = jet_across(stream);
    let spine = spread_spine(x, right, below) * wave_factor(knots, jet.patterns.knots);
    return (parts.x * in_sheath + spine) / (parts.x + parts.y);
}
