// Where the chunks of a disk with thickness end, along a part of a step: where the smooth matter has the optical
// depths 1, 3, 7, 11 and so on from the start of the part, and where the fades of the disk's edges end.
//
// Gives: add_disk.

// Places of a part at which the smooth density decides where chunks end.
const DENSITIES: u32 = 9u;
// More chunks than a part has before nothing comes through it.
const MAX_CHUNKS: u32 = 24u;
// The depths of the first two chunks, and of each later one.
const CHUNK_DEPTHS: vec3<f32> = vec3<f32>(1.0, 2.0, 4.0);
// A chunk with this times the depth that it should have is halved: the densities said too little.
const EXCESS: f32 = 2.0;
// Matter that is thinner than this share of the mean in front of it counts as this dense. Otherwise, where the
// density fades out, the ends of chunks would move by many nodes from one pixel to the next, and structure
// would show dark lines there.
const LEAST_DENSITY: f32 = 0.25;
// The least distance between the ends of chunks where fades end, in units of the distance of two densities.
const MIN_PART: f32 = 0.1;

// Where the fade of an edge ends between two neighbouring radii, because there the density bends: the share of
// the way from one to the other, along which 1/r is almost linear, and the length of this way over which r
// changes by the width of the fade. Only shares from `least` to 1 count; without any, the share is 2.
fn bend_between(r: vec2<f32>, least: f32) -> vec2<f32> {
    let fades = vec2<f32>(scene.disk.inner_fade, thick_disk.outer_fade);
    let ends = vec2<f32>(scene.disk.inner + fades.x, scene.disk.outer - fades.y);
    let passes = (vec2<f32>(r.x) > ends) != (vec2<f32>(r.y) > ends);
    if !any(passes) {
        return vec2<f32>(2.0, 0.0);
    }
    let change = r.y - r.x;
    let shares = select(vec2<f32>(2.0), r.y * (ends - r.x) / (ends * change), passes);
    let counted = select(vec2<f32>(2.0), shares, shares >= vec2<f32>(least));
    let lengths = fades / abs(change);
    return select(vec2<f32>(counted.y, lengths.y), vec2<f32>(counted.x, lengths.x), counted.x < counted.y);
}

// What is known of a part up to one of its places: the density, as the depth for each interval between two
// places, the depth so far, and the radius.
struct Known {
    density: f32,
    depth: f32,
    r: f32,
}

// Adds a span of a step inside the disk, between two shares of the step.
fn add_disk(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, span: vec2<f32>) {
    let width = (span.y - span.x) / f32(DENSITIES - 1u);
    if width <= 1e-7 {
        return;
    }
    // Where the chunk begins, its largest width, the depth that it should have, and the depth at which it ends.
    var start = span.x;
    var longest = 1.0;
    var planned = CHUNK_DEPTHS.x;
    var limit = planned;
    // The first place behind the chunk's start, and the place before it.
    let first = places_at(way, orbit, vec4<f32>(span.x));
    var place = 1u;
    var last = Known(first.rate.x * width, 0.0, first.r.x);
    for (var chunk = 0u; chunk <= MAX_CHUNKS; chunk++) {
        // Neighbouring rays find the ends of their chunks first, and then add the chunks together.
        var stop = span.y;
        var bend = vec2<f32>(2.0, 0.0);
        var next = place;
        var at = last;
        for (var i = place; i < DENSITIES; i++) {
            let before = span.x + width * f32(i - 1u);
            let ahead = places_at(way, orbit, vec4<f32>(span.x + width * f32(i)));
            if bend.x > 1.0 {
                bend = bend_between(vec2<f32>(at.r, ahead.r.x), (start - before) / width + MIN_PART);
                bend = select(bend, vec2<f32>(before, 0.0) + width * bend, bend.x <= 1.0);
            }
            let density = max(ahead.rate.x * width, LEAST_DENSITY * at.depth / f32(i));
            let depth = at.depth + 0.5 * (at.density + density);
            if depth > limit && chunk < MAX_CHUNKS {
                // Where the depth of a linear density is the limit.
                let missing = limit - at.depth;
                let root = sqrt(max(at.density * at.density + 2.0 * (density - at.density) * missing, 0.0));
                let share = clamp(2.0 * missing / max(at.density + root, TINY), 0.0, 1.0);
                stop = min(before + width * share, span.y);
                break;
            }
            at = Known(density, depth, ahead.r.x);
            next = i + 1u;
        }
        let bends = bend.x < stop - MIN_PART * width && bend.y < stop - start;
        if !bends {
            place = next;
            last = at;
        }
        let end = min(select(stop, bend.x, bends), start + longest);
        let most = select(EXCESS * planned, 1e30, chunk == MAX_CHUNKS);
        if end > start && !add_parts(result, way, orbit, photon, vec2<f32>(start, end), most) {
            longest = 0.5 * (end - start);
            continue;
        }
        if hides(*result) || end >= span.y {
            return;
        }
        longest = min(2.0 * longest, 1.0);
        start = end;
        if end >= stop {
            planned = select(CHUNK_DEPTHS.z, CHUNK_DEPTHS.y, limit == CHUNK_DEPTHS.x);
            limit += planned;
        }
    }
}

// Adds a chunk, in parts, unless the first of them has more than `most` smooth depth. Gives whether it was added.
fn add_parts(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, ends: vec2<f32>, most: f32) -> bool {
    let parts = parts_of_chunk();
    let part = (ends.y - ends.x) / f32(parts);
    for (var i = 0u; i < parts; i++) {
        let end = select(ends.x + part * f32(i + 1u), ends.y, i + 1u == parts);
        let own_most = select(1e30, most, i == 0u);
        if !add_chunk(result, way, orbit, photon, vec2<f32>(ends.x + part * f32(i), end), own_most) {
            return false;
        }
    }
    return true;
}
