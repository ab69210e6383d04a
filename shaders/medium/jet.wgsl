// Jets: where they are, how they shine and how they move. The twin in f64, which gives the sources, is
// optics/medium/jet/mod.rs.
//
// Gives: inside_jets, jet, jet_across, jet_emission, jet_slowing, jet_stream, synchrotron_colour.

struct Jet {
    // kappa of the streamlines psi = r^kappa (1 - |cos theta|), and one over psi of the outermost one.
    kappa: f32,
    inverse_width: f32,
    // Where the sheath is, and one over its thickness.
    sheath: f32,
    inverse_sheath_width: f32,
    // The brightness of the axis, and one over the square of the spine's radius.
    spine: f32,
    inverse_spine_width2: f32,
    // The power of the stream with which the light falls to nothing at the edge.
    rim: f32,
    // Velocity times Lorentz factor far out, the radius at which it is half of this, and the one at
    // which the matter is at rest.
    speed: f32,
    rise: f32,
    rest: f32,
    // The radii where the light begins and ends, and the length of its fade.
    base: f32,
    length: f32,
    fade: f32,
    // A jet's radius where r = 1, and the power with which the emission falls with the radius.
    radius: f32,
    decay: f32,
    // Velocity about the axis over that along it.
    swirl: f32,
    // The spectrum's frequency where r = 1, as a place in the table of colours, and how many places it
    // falls with ln r / ln 2.
    colour: f32,
    cooling: f32,
    // The power of the patterns' factor with which the frequency grows: shocks heat.
    heating: f32,
    // Scale of the light.
    brightness: f32,
    // Linear sRGB divided by the brightest channel, and the logarithm of that channel.
    colours: array<vec4<f32>, JET_COLOURS>,
    patterns: Patterns,
}

@group(0) @binding(BINDING_JET) var<storage, read> jet: Jet;

// The radius of a jet beyond which the matter swirls less.
const SWIRL_RADIUS: f32 = 2.0;

// 1 - |cos theta| = (n_x^2 + n_y^2)/(1 + |n_z|), which has no cancellation.
fn below_pole(y: vec4<f32>) -> f32 {
    return dot(y.zw, y.zw) / (1.0 + abs(y.y));
}

// psi over that of the outermost streamline: the square of the place across the jet.
fn jet_stream(r: f32, y: vec4<f32>) -> f32 {
    return exp2(jet.kappa * log2(r)) * below_pole(y) * jet.inverse_width;
}

// How far inside the jets a place is: positive inside.
fn inside_jets(r: f32, y: vec4<f32>) -> f32 {
    return min(1.0 - jet_stream(r, y), min(r / jet.base - 1.0, 1.0 - r / jet.length));
}

// The distance of the outermost streamline from the axis.
fn jet_radius(r: f32) -> f32 {
    return jet.radius * exp2((1.0 - 0.5 * jet.kappa) * log2(r));
}

fn jet_fade(share: f32) -> f32 {
    let s = clamp(share, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

// The brightness of the sheath and of the spine.
fn jet_across(stream: f32) -> vec2<f32> {
    let off = (sqrt(stream) - jet.sheath) * jet.inverse_sheath_width;
    return vec2<f32>(exp(-off * off), jet.spine * exp(-stream * jet.inverse_spine_width2));
}

// Emission of the smooth jets for each r_s of the way in the matter's frame.
fn jet_emission(r: f32, stream: f32) -> f32 {
    let rim = max(1.0 - exp2(jet.rim * log2(max(stream, TINY))), 0.0);
    let parts = jet_across(stream);
    let across = (parts.x + parts.y) * rim * rim;
    let ends = jet_fade(r / jet.base - 1.0) * jet_fade((jet.length - r) / jet.fade);
    return across * ends * exp2(-jet.decay * log2(jet_radius(r)));
}

// 1/g: emitted over observed frequency, scaled like the constants of the ray, where the ray has the state
// y with these slopes in Mino time. On the axis the swirl and the photon's momentum about it both vanish.
fn jet_slowing(orbit: KerrRay, r: f32, stream: f32, y: vec4<f32>, slope: vec4<f32>) -> f32 {
    let a = scene.hole.a;
    let z = abs(y.y);
    let sin2 = dot(y.zw, y.zw);
    let sigma = r * r + a * a * y.y * y.y;
    let delta = (r - scene.hole.horizon) * (r - scene.hole.inner_horizon);
    let area = sigma * (r * r + a * a) + r * a * a * sin2;
    let lapse = sqrt(max(sigma * delta / area, TINY));
    let frequency = (orbit.constants.energy - a * r / area * orbit.angular_momentum) / lapse;
    // The matter's direction: tan(theta/2) = sin(theta)/(1 + |cos(theta)|) leads toward the axis.
    let inward = jet.kappa * sqrt(max(delta, 0.0)) / (r * (1.0 + z));
    let swirl = jet.swirl * min(SWIRL_RADIUS / jet_radius(r), 1.0);
    let momentum = jet.speed * (r - jet.rest) / (r + jet.rise);
    let lorentz = sqrt(1.0 + momentum * momentum);
    let speed = momentum / lorentz * inverseSqrt(1.0 + inward * inward * sin2 + swirl * swirl * stream);
    // The photon's momentum along it. The place across the jet over sin(theta) is finite.
    let outward = slope.x * r * r * inverseSqrt(max(sigma * delta, TINY));
    let toward_axis = -sign(y.y) * inward * slope.y * inverseSqrt(sigma);
    let over_sine = sqrt(exp2(jet.kappa * log2(r)) * jet.inverse_width / (1.0 + z));
    let about = swirl * over_sine * orbit.angular_momentum * inverseSqrt(area / sigma);
    return lorentz * (frequency - speed * (outward + toward_axis + about));
}

// Linear sRGB per unit of bolometric flux, seen with this shift, where patterns multiply the emission by
// `factor`. Beyond the last entry of the table light falls by a power of the frequency; below the first one
// it is as dark as there.
fn synchrotron_colour(r: f32, g: f32, factor: f32) -> vec3<f32> {
    let last = f32(JET_COLOURS - 1u);
    let octaves = log2(max(g, TINY)) + jet.heating * log2(max(factor, TINY));
    let wanted = jet.colour - jet.cooling * log2(r) + JET_COLOURS_PER_OCTAVE * octaves;
    let place = clamp(wanted, 0.0, last);
    let beyond = max(wanted - last, 0.0) / JET_COLOURS_PER_OCTAVE;
    let low = min(u32(place), JET_COLOURS - 2u);
    let entry = mix(jet.colours[low], jet.colours[low + 1u], place - f32(low));
    return max(entry.rgb, vec3<f32>(0.0)) * (exp(entry.a) * exp2(-JET_FALL_BEYOND_COLOURS * beyond));
}
