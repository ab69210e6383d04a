// Matter with depth: a disk with thickness.
//
// Gives: add_step, brightest_light, is_within_matter.

// Whether no matter lies between a place and the hole.
fn is_within_matter(u: f32) -> bool {
    return u * scene.disk.inner >= 1.0;
}

// About the light of the brightest place, as matter beside it sees it.
fn brightest_light() -> f32 {
    return brightest_disk_light();
}

// Adds what a ray meets in the first `end` of a step.
fn add_step(result: ptr<function, Passage>, way: Way, orbit: KerrRay, photon: Photon, end: f32) {
    add_disk(result, way, orbit, photon, span_in_medium(way.path, way.motion.base, end));
}
