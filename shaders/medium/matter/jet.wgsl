// Matter with depth: jets.
//
// Gives: add_step, brightest_light, is_within_matter.

// Whether no matter lies between a place and the hole.
fn is_within_matter(u: f32) -> bool {
    return u * jet.base >= 1.0;
}

// About the light of the brightest place as matter beside it sees it.
fn brightest_light() -> f32 {
    return jet.brightness;
}

// Adds what a ray meets in the first `end` of a step.
fn add_step(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, end: f32) {
    let spans = spans_in_jets(way.path, way.motion.base, end);
    for (var i = 0u; i < MAX_JET_SPANS; i++) {
        add_jet(result, way, orbit, photon, spans[i]);
    }
}
