// The light of jets along a part of a step. The part is divided at the sides of the spine and at the place
// nearest to the axis, and each of the four pieces has Gauss-Legendre nodes. Jets let all light through.
//
// Gives: MAX_JET_SPANS, add_jet, spans_in_jets.

// Both jets may be in one step.
const MAX_JET_SPANS: u32 = 2u;
// Places of a step at which the search looks for the jets.
const JET_PLACES_OF_STEP: u32 = 9u;
// Halvings of a boundary's interval, and steps of the search for the place nearest to the axis.
const JET_HALVINGS: u32 = 10u;
const JET_SEARCH: u32 = 8u;
// The stream at the sides of the spine.
const SPINE_SIDE: f32 = 0.02;

fn inside_jets_at(path: Curve, base: f32, share: f32) -> f32 {
    let y = curve_at(path, share);
    return inside_jets(1.0 / max(base + y.x, TINY), y);
}

// The parts of the first `end` of a step inside the jets. One that ends before it begins is empty.
fn spans_in_jets(path: Curve, base: f32, end: f32) -> array<vec2<f32>, MAX_JET_SPANS> {
    var spans = array<vec2<f32>, MAX_JET_SPANS>(vec2<f32>(1.0, 0.0), vec2<f32>(1.0, 0.0));
    let width = end / f32(JET_PLACES_OF_STEP - 1u);
    var count = 0u;
    var start = 0.0;
    var within = inside_jets_at(path, base, 0.0) > 0.0;
    for (var i = 1u; i < JET_PLACES_OF_STEP && count < MAX_JET_SPANS; i++) {
        let place = width * f32(i);
        if (inside_jets_at(path, base, place) > 0.0) != within {
            var low = place - width;
            var high = place;
            for (var j = 0u; j < JET_HALVINGS; j++) {
                let middle = 0.5 * (low + high);
                let before = (inside_jets_at(path, base, middle) > 0.0) == within;
                low = select(low, middle, before);
                high = select(middle, high, before);
            }
            if within {
                spans[count] = vec2<f32>(start, high);
                count += 1u;
            }
            start = low;
            within = !within;
        }
    }
    if within && count < MAX_JET_SPANS {
        spans[count] = vec2<f32>(start, end);
    }
    return spans;
}

fn stream_at(path: Curve, base: f32, share: f32) -> f32 {
    let y = curve_at(path, share);
    return jet_stream(1.0 / max(base + y.x, TINY), y);
}

// Where a ray leaves the spine, between a place inside and one that may be outside.
fn spine_share(path: Curve, base: f32, inner: f32, outer: f32) -> f32 {
    var low = inner;
    var high = outer;
    for (var i = 0u; i < JET_HALVINGS; i++) {
        let middle = 0.5 * (low + high);
        let inside = stream_at(path, base, middle) < SPINE_SIDE;
        low = select(low, middle, inside);
        high = select(middle, high, inside);
    }
    return high;
}

// The light of a node, of which this `part` of the step belongs to it, and of which this share arrives.
fn jet_light(way: Way, orbit: KerrRay, photon: Photon, share: f32, part: f32, arriving: f32) -> vec3<f32> {
    let y = curve_at(way.path, share);
    let slope = curve_slope(way.path, share);
    let r = 1.0 / max(way.motion.base + y.x, TINY);
    let stream = jet_stream(r, y);
    if r <= jet.base || r >= jet.length || stream >= 1.0 {
        return vec3<f32>(0.0);
    }
    let slowing = max(jet_slowing(orbit, r, stream, y, slope / way.h), 1e-6);
    let sigma = r * r + square(scene.hole.a) * y.y * y.y;
    let length = part * way.h * sigma * slowing;
    let g = medium_shift(photon, vec4<f32>(r), vec4<f32>(y.y), vec4<f32>(orbit.scale / slowing)).x;
    let factor = jet_factor(way, share, part, r, stream, y, slope);
    let light = synchrotron_colour(r, g, factor) * (beaming_factor(g) * jet_emission(r, stream) * length * factor);
    // Nothing absorbs within the jets, so all their places have the same share.
    weigh(way, share, r, y.y, orbit.scale / slowing, arriving * light);
    return light;
}

// Adds a span of a step inside the jets, between two shares of the step.
fn add_jet(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, span: vec2<f32>) {
    if span.y - span.x <= 1e-6 {
        return;
    }
    // The place nearest to the axis, by golden sections.
    var low = span.x;
    var high = span.y;
    for (var i = 0u; i < JET_SEARCH; i++) {
        let width = 0.381966 * (high - low);
        let left = stream_at(way.path, way.motion.base, low + width) < stream_at(way.path, way.motion.base, high - width);
        low = select(low + width, low, left);
        high = select(high, high - width, left);
    }
    let nearest = 0.5 * (low + high);
    var ends = array<f32, 5>(span.x, nearest, nearest, nearest, span.y);
    if stream_at(way.path, way.motion.base, nearest) < SPINE_SIDE {
        ends[1] = spine_share(way.path, way.motion.base, nearest, span.x);
        ends[3] = spine_share(way.path, way.motion.base, nearest, span.y);
    }
    var nodes = JET_NODES;
    var light = vec3<f32>(0.0);
    let arriving = (*result).transmission * jet.brightness;
    for (var piece = 0u; piece < 4u; piece++) {
        let parts = parts_of_chunk();
        let width = (ends[piece + 1u] - ends[piece]) / f32(parts);
        if width > 1e-6 {
            for (var i = 0u; i < parts * JET_NODE_COUNT; i++) {
                let node = nodes[i % JET_NODE_COUNT];
                let start = ends[piece] + width * f32(i / JET_NODE_COUNT);
                light += jet_light(way, orbit, photon, start + width * node.x, width * node.y, arriving);
            }
            (*result).samples += parts * JET_NODE_COUNT;
        }
    }
    (*result).light += arriving * light;
}
