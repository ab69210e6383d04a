// Matter with depth: jets, and between them a disk without thickness, which a ray meets where it crosses
// the plane.
//
// Gives: add_step, brightest_light, is_within_matter.

// Whether no matter lies between a place and the hole.
fn is_within_matter(u: f32) -> bool {
    return u * min(jet.base, scene.disk.inner) >= 1.0;
}

// About the light of the brightest place, as matter beside it sees it.
fn brightest_light() -> f32 {
    return max(brightest_disk_light(), jet.brightness);
}

// Adds what a ray meets in the first `end` of a step: the jets before the plane, the disk, and the jets
// behind.
fn add_step(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, end: f32) {
    let spans = spans_in_jets(way.path, way.motion.base, end);
    let crossing = plane_share(way.path, end);
    for (var side = 0u; side < 2u; side++) {
        let part = select(vec2<f32>(0.0, crossing), vec2<f32>(crossing, end), side == 1u);
        for (var i = 0u; i < MAX_JET_SPANS; i++) {
            add_jet(result, way, orbit, photon, vec2<f32>(max(spans[i].x, part.x), min(spans[i].y, part.y)));
        }
        if side == 0u && crossing < end {
            add_sheet(result, way, orbit, photon, crossing);
        }
        if crossing >= end {
            break;
        }
    }
}
