// Matter with depth: a disk with thickness, and jets.
//
// Where both are in the same place, as in a disk almost as high as wide, they are added in turns: the
// common part is divided in four, and in each of these the jets' light passes through half of the disk's
// depth. For a depth d of such a quarter this is wrong by d^2/24 of the jets' light there.
//
// Gives: add_step, brightest_light, is_within_matter.

// Parts into which the common part is divided.
const COMMON_PARTS: f32 = 4.0;
// The disk alone, both, the jets alone and so on: more than a step can have.
const MAX_PARTS: u32 = 16u;

// Whether no matter lies between a place and the hole.
fn is_within_matter(u: f32) -> bool {
    return u * min(jet.base, scene.disk.inner) >= 1.0;
}

// The nearer one of two marks that lies behind a place.
fn next_mark(after: f32, marks: vec2<f32>, nearest: f32) -> f32 {
    let first = select(nearest, min(nearest, marks.x), marks.x > after);
    return select(first, min(first, marks.y), marks.y > after);
}

// About the light of the brightest place, as matter beside it sees it.
fn brightest_light() -> f32 {
    return max(brightest_disk_light(), jet.brightness);
}

// Adds what a ray meets in the first `end` of a step, in its order.
fn add_step(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, end: f32) {
    let disk = span_in_medium(way.path, way.motion.base, end);
    let spans = spans_in_jets(way.path, way.motion.base, end);
    var from_share = 0.0;
    // A quarter of the common part, inside one.
    var quarter = 0.0;
    for (var part = 0u; part < MAX_PARTS && from_share < end; part++) {
        // Where one of them begins or ends.
        var mark = end;
        if disk.x < disk.y {
            mark = next_mark(from_share, disk, mark);
        }
        var in_jet = false;
        for (var i = 0u; i < MAX_JET_SPANS; i++) {
            if spans[i].x < spans[i].y {
                mark = next_mark(from_share, spans[i], mark);
                in_jet = in_jet || spans[i].x <= from_share && from_share < spans[i].y;
            }
        }
        let in_disk = disk.x <= from_share && from_share < disk.y;
        var to_share = mark;
        if in_disk && in_jet {
            quarter = select(quarter, (mark - from_share) / COMMON_PARTS, quarter == 0.0);
            // Rounding leaves no fifth part.
            to_share = select(from_share + quarter, mark, mark - from_share < 1.5 * quarter);
        } else {
            quarter = 0.0;
        }
        let before = (*result).transmission;
        if in_disk {
            add_disk(result, way, orbit, photon, vec2<f32>(from_share, to_share));
        }
        if in_jet {
            let behind = (*result).transmission;
            (*result).transmission = sqrt(before * behind);
            add_jet(result, way, orbit, photon, vec2<f32>(from_share, to_share));
            (*result).transmission = behind;
        }
        from_share = to_share;
    }
}
